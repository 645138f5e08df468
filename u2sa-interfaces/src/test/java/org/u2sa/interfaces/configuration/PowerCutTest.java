package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Map;
import java.util.OptionalLong;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Kills a process that changes its configuration without pause: the file is old or new, whole; both
 * variables of a change have changed or neither; the audit log agrees.
 */
class PowerCutTest {
  private static final int SHORT_KILLS = 6;
  private static final int LONG_KILLS = 150;
  private static final int MAX_LOOKS = 40;
  private static final int PADDING = 400_000; // makes a write last, so that kills fall into it

  @TempDir Path folder;

  /** What the killed process runs: counts up in the file and prints what is written. */
  static final class Writer {
    private Writer() {}

    public static void main(String[] arguments) {
      XmlConfiguration configuration = XmlConfiguration.load(Paths.get(arguments[0]));
      for (int i = (Integer) configuration.getVariable("N") + 1; true; i++) {
        String problem =
            configuration
                .change(
                    Map.of("N", i, "SQUARE", (double) i * i),
                    OptionalLong.empty(),
                    new ChangeOrigin(i, "Writer", "test"),
                    ConfigurationCheck.NONE)
                .refusal()
                .orElse("");
        System.out.print((problem.isEmpty() ? String.valueOf(i) : problem) + "\n");
        System.out.flush();
      }
    }
  }

  private static String text(int n, String padding) {
    return "<configuration>\n<variable name=\"N\" type=\"int\" value=\""
        + n
        + "\"/>\n<!-- "
        + padding
        + " -->\n<variable name=\"SQUARE\" type=\"double\" value=\""
        + (double) n * n
        + "\"/>\n</configuration>\n";
  }

  @Test
  @Timeout(60)
  void change_processKilledAFewTimes_fileIsOldOrNewAndWhole() throws Exception {
    killAndLook(SHORT_KILLS, 11);
  }

  @Test
  @Tag("long")
  @Timeout(900)
  void change_processKilledOften_fileIsOldOrNewAndWhole() throws Exception {
    killAndLook(LONG_KILLS, 12);
  }

  private void killAndLook(int kills, long seed) throws Exception {
    Random random = new Random(seed);
    String padding = "comment ".repeat(PADDING / 8);
    Path file = folder.resolve("X.xml");
    Files.write(file, text(0, padding).getBytes(StandardCharsets.UTF_8));
    int torn = 0;
    for (int kill = 1; kill <= kills; kill++) {
      int last = writeAndKill(file, 1 + random.nextInt(6), random, padding);

      int n = assertWhole(file, padding);
      assertThat(n).as("kill %d", kill).isBetween(last, last + 1);
      XmlConfiguration configuration = XmlConfiguration.load(file);
      assertThat(configuration.getVariable("N")).isEqualTo(n);
      assertThat(configuration.revision()).as("each change is in the log").isEqualTo(n);
      torn += temporaryFiles();
      assertThat(temporaryFiles()).as("left by this kill alone").isLessThanOrEqualTo(1);
    }
    System.out.println(kills + " kills, " + torn + " of them in the middle of a file");
    ConfigurationOutcome undone =
        XmlConfiguration.load(file)
            .undo(new ChangeOrigin(0, "Test", "test"), ConfigurationCheck.NONE);
    assertThat(undone.refusal()).isEmpty();
    assertThat(temporaryFiles()).isZero();
  }

  private int temporaryFiles() {
    return folder.toFile().list((directory, name) -> name.endsWith(".tmp")).length;
  }

  private static int assertWhole(Path file, String padding) throws IOException {
    String content = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
    Matcher number = Pattern.compile("value=\"(\\d+)\"").matcher(content);
    assertThat(number.find()).as("whole: %d characters", content.length()).isTrue();
    int n = Integer.parseInt(number.group(1));
    assertThat(content.equals(text(n, padding))).as("whole: %d", content.length()).isTrue();
    return n;
  }

  /**
   * Runs the writer until it has reported some changes, kills it, and gives the last reported one.
   */
  private static int writeAndKill(Path file, int changes, Random random, String padding)
      throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(
                Paths.get(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-Xshare:auto",
                "-cp",
                System.getProperty("java.class.path"),
                Writer.class.getName(),
                file.toString())
            .redirectErrorStream(true)
            .start();
    int last = 0;
    try (BufferedReader lines =
        new BufferedReader(
            new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
      for (int i = 0; i < changes; i++) {
        last = Integer.parseInt(lines.readLine());
      }
      // A reader sees what a kill at that moment would leave.
      for (int i = random.nextInt(MAX_LOOKS); i > 0; i--) {
        assertWhole(file, padding);
      }
      process.toHandle().destroyForcibly(); // SIGKILL; what it had said can still be read
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        last = Integer.parseInt(line);
      }
    } finally {
      process.destroyForcibly();
    }
    assertThat(process.waitFor(10, TimeUnit.SECONDS)).isTrue();
    return last;
  }
}
