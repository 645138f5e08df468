package org.u2sa.interfaces.configuration;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * A write that the operating system ends halfway, as on a full disk: here by the limit of a process
 * for the size of files.
 */
@DisabledOnOs(OS.WINDOWS)
class HalfWrittenTest {
  private static final int PADDING = 400_000;
  private static final String BLOCKS = "200"; // 100 or 200 kB, as the shell counts

  @TempDir Path folder;

  /** What the limited process runs. */
  static final class Writer {
    private Writer() {}

    public static void main(String[] arguments) {
      XmlConfiguration configuration = XmlConfiguration.load(Paths.get(arguments[0]));
      System.out.println(configuration.change("N", 2).orElse("accepted"));
      System.out.println(configuration.getVariable("N"));
    }
  }

  @Test
  @Timeout(60)
  void change_writeEndsHalfway_oldFileAndValueStayAndTheReasonIsTold() throws Exception {
    String before =
        "<configuration><variable name='N' type='int' value='1'/><!-- "
            + "comment ".repeat(PADDING / 8)
            + "--></configuration>";
    Path file = Files.writeString(folder.resolve("X.xml"), before);

    List<String> said = runLimited(file);

    assertThat(said.get(0))
        .startsWith(file + ", variable \"N\": cannot be written, the old value stays: ")
        .contains("File too large");
    assertThat(said.get(1)).isEqualTo("1");
    assertThat(Files.readString(file)).isEqualTo(before);
    assertThat(folder.toFile().list())
        .containsExactlyInAnyOrder("X.xml", "X.xml.audit.jsonl", ".configuration.lock");
    List<String> audit = Files.readAllLines(folder.resolve("X.xml.audit.jsonl"));
    assertThat(audit.get(1)).contains("FAILED").contains("File too large");

    assertThat(XmlConfiguration.load(file).change("N", 2)).isEmpty();
    assertThat(XmlConfiguration.load(file).revision()).isEqualTo(1);
  }

  private List<String> runLimited(Path file) throws Exception {
    Path out = Files.createTempFile("u2sa", ".txt");
    Process process =
        new ProcessBuilder(
                "sh",
                "-c",
                "ulimit -f " + BLOCKS + "; exec \"$@\"",
                "sh",
                Paths.get(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:-UsePerfData",
                "-cp",
                System.getProperty("java.class.path"),
                Writer.class.getName(),
                file.toString())
            .redirectErrorStream(true)
            .redirectOutput(out.toFile())
            .start();
    assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
    List<String> said = Files.readAllLines(out);
    Files.delete(out);
    return said;
  }
}
