package org.u2sa.cli.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.configuration.XmlConfiguration;

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

  private static XmlConfiguration set(String text) {
    XmlConfiguration configuration = XmlConfiguration.inMemory("test", Map.of());
    Setting setting = Setting.parse(text);
    configuration.override(setting.variable(), setting.value());
    return configuration;
  }

  @ParameterizedTest
  @ValueSource(strings = {"007", "1.50", "TRUE", "+5", "5e3", "main"})
  void parse_valueOfAVariableThatIsAText_isTakenAsWritten(String text) {
    VariableDeclaration<String> name = VariableDeclaration.text("SERVICE NAME");

    assertThat(set("Lidar:SERVICE NAME=" + text).getVariable(name)).isEqualTo(text);
  }

  @Test
  void parse_valueOfANumber_isANumber() {
    assertThat(set("Lidar:RATE=1.50").getVariable("RATE")).isEqualTo(1.5);
    assertThat(set("Lidar:RATE=007").getVariable("RATE")).isEqualTo(7);
    assertThat(set("Lidar:ON=TRUE").getVariable("ON")).isEqualTo(true);
  }

  @Test
  void parseAll_oneVariableTwice_isRefused() {
    assertThat(Setting.parseAll(List.of("A:X=1", "A:Y=1", "B:X=1"))).hasSize(3);
    assertThatThrownBy(() -> Setting.parseAll(List.of("A:X=1", "A:X=2")))
        .hasMessage("\"A:X=2\": the variable is set to 1 already");
  }
}
