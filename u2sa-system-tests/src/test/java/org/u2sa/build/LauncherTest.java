package org.u2sa.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** How the script {@code u2sa} starts Java, with a program in its place. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@DisabledOnOs(OS.WINDOWS)
class LauncherTest {
  @TempDir private Path home;
  private Path runs; // the arguments, a line for each start of Java
  private final List<String> before = new ArrayList<>(); // command that starts the script

  @BeforeEach
  void build() throws IOException {
    Path script = Path.of("u2sa");
    Files.copy(Files.exists(script) ? script : Path.of("../u2sa"), home.resolve("u2sa"));
    Files.createDirectories(home.resolve("target/u2sa/lib"));
    Files.createFile(home.resolve("target/u2sa/estop.jsa"));
    Files.createDirectories(home.resolve("jdk/bin"));
    runs = home.resolve("runs");
  }

  /**
   * Starts the script; in Java's place, a program runs one command with the archive, else another.
   */
  private Process estop(String withArchive, String without) throws IOException {
    return start(withArchive, without, "estop", "--reason", "a b");
  }

  private Process start(String withArchive, String without, String... words) throws IOException {
    Path java = home.resolve("jdk/bin/java");
    Files.writeString(
        java,
        String.join(
            "\n",
            "#!/bin/sh",
            "echo \"$@\" >>" + runs,
            "case \"$*\" in *SharedArchiveFile*) " + withArchive + " ;; *) " + without + " ;; esac",
            ""));
    Files.setPosixFilePermissions(java, PosixFilePermissions.fromString("rwxr-xr-x"));
    List<String> command = new ArrayList<>();
    if (System.getProperty("os.name").equals("Linux")) {
      // A test run under nohup ignores HUP, and a shell cannot trap what it was started ignoring.
      command.addAll(List.of("env", "--default-signal=HUP,INT,TERM"));
    }
    command.addAll(before);
    command.addAll(List.of("/bin/sh", home.resolve("u2sa").toString()));
    command.addAll(List.of(words));
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().put("JAVA_HOME", home.resolve("jdk").toString());
    return builder.redirectErrorStream(true).start();
  }

  private static String output(Process process) throws IOException {
    return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
  }

  @ParameterizedTest
  @ValueSource(strings = {"ABRT", "BUS", "SEGV", "ILL", "FPE"})
  void estop_javaCrashesWithTheArchive_isDoneWithoutIt(String signal) throws Exception {
    Process process = estop("kill -" + signal + " $$", "echo stopped; exit 7");

    assertThat(output(process)).contains("doing it again without").contains("stopped");
    assertThat(process.waitFor()).isEqualTo(7);
    List<String> started = Files.readAllLines(runs);
    assertThat(started).hasSize(2);
    assertThat(started.get(0)).contains("estop.jsa").endsWith("Main estop --reason a b");
    assertThat(started.get(1)).doesNotContain("estop.jsa").endsWith("Main estop --reason a b");
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 130, 137, 143})
  void estop_javaEndsWithTheArchive_itsExitCodeCounts(int code) throws Exception {
    Process process = estop("exit " + code, "echo again");

    assertThat(output(process)).isEmpty();
    assertThat(process.waitFor()).isEqualTo(code);
    assertThat(Files.readAllLines(runs)).hasSize(1);
  }

  private void standInADeletedFolder() throws IOException {
    String gone = Files.createDirectory(home.resolve("gone")).toString();
    String script = "cd \"$1\" && rmdir \"$1\" && shift && exec \"$@\"";
    before.addAll(List.of("/bin/sh", "-c", script, "sh", gone));
  }

  @Test
  void estop_currentFolderWasDeleted_isDoneAtHome() throws Exception {
    standInADeletedFolder();
    Process process = estop("/bin/pwd -P; exit 6", "exit 5");

    assertThat(output(process)).contains(home.toRealPath().toString());
    assertThat(process.waitFor()).isEqualTo(6);
  }

  @Test
  void demo_currentFolderWasDeleted_saysSo() throws Exception {
    standInADeletedFolder();
    Process process = start("exit 6", "exit 5", "demo", "ugv");

    assertThat(output(process)).contains("the current folder no longer exists");
    assertThat(process.waitFor()).isEqualTo(3);
    assertThat(runs).doesNotExist();
  }

  @Test
  void estop_noArchive_isDoneWithout() throws Exception {
    Files.delete(home.resolve("target/u2sa/estop.jsa"));
    Process process = estop("exit 9", "exit 5");

    assertThat(output(process)).isEmpty();
    assertThat(process.waitFor()).isEqualTo(5);
  }

  @ParameterizedTest
  @ValueSource(strings = {"INT 130", "TERM 143", "HUP 129"})
  void estop_signal_endsJavaAndIsNotRepeated(String signalAndCode) throws Exception {
    String[] words = signalAndCode.split(" ");
    Process process =
        estop(
            "trap 'echo ended; exit 1' TERM; echo begun; while :; do sleep 0.05; done",
            "echo again");
    try (BufferedReader out = process.inputReader(StandardCharsets.UTF_8)) {
      assertThat(out.readLine()).isEqualTo("begun");
      new ProcessBuilder("kill", "-" + words[0], String.valueOf(process.pid())).start().waitFor();

      assertThat(out.readLine()).isEqualTo("ended");
      assertThat(out.readLine()).isNull();
    }
    assertThat(process.waitFor()).isEqualTo(Integer.parseInt(words[1]));
  }

  @ParameterizedTest
  @CsvSource({
    "<a class=\"org.u2sa.sensor.Gps\"/>, '', 1",
    "<a class=\"org.u2sa.sensor.Camera\"/>, '', 4",
    "<a class=\"org.u2sa.sensor.Gps\"/>, --runs=9, 4"
  })
  void simulate_systemFile_secondCompilerOnlyForPicturesOrManyRuns(
      String system, String option, int level) throws Exception {
    Path file = Files.writeString(home.resolve("a system.xml"), system);
    Path java = home.resolve("jdk/bin/java");
    Files.writeString(home.resolve("target/u2sa/stamp"), java + "\n"); // built, by this Java
    Process process = start("exit 3", "exit 0", "simulate", file.toString(), option);

    assertThat(output(process)).isEmpty();
    assertThat(process.waitFor()).isZero();
    assertThat(Files.readString(runs)).contains("-XX:TieredStopAtLevel=" + level + " ");
  }
}
