package org.u2sa.cli.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.core.launch.SystemFile;

/** Settings that would have no effect are refused. */
class SettingTest {
  @TempDir Path folder;

  private SystemFile system() throws IOException {
    return SystemFile.read(
        Files.writeString(
            folder.resolve("system.xml"),
            "<system id=\"boat\"><service class=\"org.example.PathPlanner\"/></system>"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"PathPlanner:RATE=5.0", "CommunicationManager:BROKER=none"})
  void requireServiceOf_thatOfTheSystem_isTaken(String text) throws IOException {
    Setting.parse(text).requireServiceOf(system());
  }

  @Test
  void requireServiceOf_another_namesTheNearest() {
    assertThatThrownBy(() -> Setting.parse("PathPlaner:RATE=5.0").requireServiceOf(system()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "\"PathPlaner:RATE=5.0\": "
                + folder.resolve("system.xml")
                + " lists no service of class \"PathPlaner\"; expected one of PathPlanner,"
                + " CommunicationManager; did you mean \"PathPlanner\"?");
  }

  @Test
  void parseAll_oneVariableTwice_isRefused() {
    assertThat(Setting.parseAll(List.of("A:X=1", "A:Y=1", "B:X=1"))).hasSize(3);
    assertThatThrownBy(() -> Setting.parseAll(List.of("A:X=1", "A:X=2")))
        .hasMessage("\"A:X=2\": the variable is set to 1 already");
  }
}
