package org.u2sa.testkit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.opentest4j.TestAbortedException;

class ForeignProgramsTest {
  @TempDir private Path folder;
  @TempDir private Path further;
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private ForeignPrograms desk;
  private ForeignPrograms ci;

  @BeforeEach
  void look() {
    desk =
        new ForeignPrograms(
            new PrintStream(out), Map.of("PATH", folder.toString()), further.toString());
    ci =
        new ForeignPrograms(
            new PrintStream(out),
            Map.of("PATH", folder.toString(), "CI", "true"),
            further.toString());
  }

  /** A shell script in place of the program. */
  private static Path program(Path folder, String name, String script) throws IOException {
    Path file = Files.writeString(folder.resolve(name), "#!/bin/sh\n" + script + "\n");
    return Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
  }

  @Test
  void required_onThePath_isFoundThere() throws IOException {
    Path socat = program(folder, "socat", "exit 0");
    program(further, "socat", "exit 0");

    assertThat(desk.required("socat")).isEqualTo(socat.toString());
    assertThat(desk.missing("socat")).isEmpty();
  }

  @Test
  void required_beyondThePath_isFoundThere() throws IOException {
    Path mosquitto = program(further, "mosquitto", "exit 0");

    assertThat(ci.required("mosquitto")).isEqualTo(mosquitto.toString());
  }

  @Test
  void required_missing_skipsTheTestInOneLine() {
    assertThatThrownBy(() -> desk.required("socat"))
        .isInstanceOf(TestAbortedException.class)
        .hasMessage("socat is not here (./u2sa test installs it)");
    assertThat(out).hasToString("A test is skipped: socat is not here (./u2sa test installs it)\n");
  }

  @Test
  void required_missingUnderCi_failsTheTest() {
    assertThatThrownBy(() -> ci.required("socat"))
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("socat is not here")
        .hasMessageContaining("CI=true");
    assertThatThrownBy(() -> ci.missing("socat")).isInstanceOf(AssertionError.class);
  }

  @Test
  void required_firstPythonLacksTheModule_takesTheOneThatHasIt() throws IOException {
    program(folder, "python3", "exit 1");
    Path able = program(further, "python3", "test \"$2\" = 'import cbor2, paho.mqtt.client'");

    assertThat(desk.required("python3", "cbor2", "paho.mqtt.client")).isEqualTo(able.toString());
    assertThatThrownBy(() -> desk.required("python3", "cbor2"))
        .hasMessageContaining("python3 with cbor2 is not here");
  }

  @Test
  void required_notExecutable_isMissing() throws IOException {
    Files.writeString(folder.resolve("socat"), "no program");

    assertThatThrownBy(() -> desk.required("socat")).isInstanceOf(TestAbortedException.class);
  }
}
