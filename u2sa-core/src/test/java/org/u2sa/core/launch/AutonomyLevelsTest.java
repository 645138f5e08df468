package org.u2sa.core.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;

/** What system files state of a vehicle's autonomy. */
class AutonomyLevelsTest {
  @TempDir private Path directory;

  private SystemFile read(String autonomy) throws IOException {
    Path file = directory.resolve("system.xml");
    Files.writeString(
        file,
        "<system id=\"boat\">\n" + autonomy + "\n<service class=\"org.example.Boat\"/>\n</system>");
    return SystemFile.read(file);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "<autonomy perception='4' decision='3' independence='5'/>",
        "<autonomy perception='Classification' decision='memory' independence='problem-detection'/>"
      })
  void read_levelsByNumberOrName_areTheSame(String element) throws IOException {
    AutonomyLevels levels = read(element).autonomy().orElseThrow();

    assertThat(levels.perception()).isEqualTo(AutonomyLevels.Perception.CLASSIFICATION);
    assertThat(levels.decision().number()).isEqualTo(3);
    assertThat(levels.independence().words()).isEqualTo("problem detection");
  }

  @Test
  void read_withoutLevels_statesNone() throws IOException {
    assertThat(read("").autonomy()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          <autonomy perception='7' decision='3' independence='5'/> | perception: "7" is not a level; expected one of 1 no sensing, 2 discrete, 3 grouped, 4 classification, 5 static learning, 6 dynamic learning
          <autonomy perception='2' decision='memmory' independence='5'/> | decision: "memmory" is not a level; expected one of 1 no decisions, 2 static response, 3 memory, 4 projection, 5 static task learning, 6 dynamic task learning; did you mean "memory"?
          <autonomy perception='2' decision='2'/> | attribute "independence" is missing
          <autonomy perception='2' decision='2' independence='2' speed='2'/> | unknown attribute "speed"; expected perception, decision, independence
          """)
  void read_wrongLevels_areRefusedWithFileAndLine(String element, String message) {
    assertThatThrownBy(() -> read(element))
        .isInstanceOf(BadInputException.class)
        .hasMessage(directory.resolve("system.xml") + ", line 2, <autonomy>: " + message);
  }

  @Test
  void read_twice_isRefused() {
    String once = "<autonomy perception='2' decision='2' independence='2'/>";
    assertThatThrownBy(() -> read(once + "\n" + once)).hasMessageContaining("line 3, <autonomy>");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "ugv/system.xml",
        "ugv/system-board.xml",
        "ugv/system-four-sensors.xml",
        "ugv/system-pass-through.xml",
        "ugv/system-ackermann.xml",
        "ugv/system-proportional.xml",
        "cessna/system.xml"
      })
  void shippedSystems_stateTheirLevels(String file) {
    assertThat(SystemFile.read(Paths.get("../config").resolve(file)).autonomy()).isPresent();
  }

  @Test
  void planned_serviceOfTheFile_saysItsChannelsWithoutRunning() throws IOException {
    Files.writeString(
        directory.resolve("PathPlanner.xml"),
        "<configuration><variable name=\"SERVICE NAME\" type=\"string\" value=\"Planner\"/></configuration>");
    Path file = directory.resolve("rover.xml");
    Files.writeString(
        file,
        "<system id=\"rover\"><service class=\"org.u2sa.planning.PathPlanner\" configuration=\"PathPlanner.xml\"/>"
            + "<service class=\"org.u2sa.mission.MissionManager\"/></system>");
    var planned = PlannedService.of(SystemFile.read(file));

    assertThat(planned.get(0).name()).isEqualTo("Planner");
    assertThat(planned.get(0).role()).isEqualTo("PATH_PLANNER");
    assertThat(planned.get(0).subscribes()).extracting(Object::toString).contains("goals", "state");
    assertThat(planned.get(0).publishes()).extracting(Object::toString).contains("navigation");
    assertThat(planned.get(1).refusal().orElseThrow()).contains("MISSION");
    assertThat(Thread.getAllStackTraces().keySet())
        .noneMatch(each -> each.getName().equals("Planner"));
  }
}
