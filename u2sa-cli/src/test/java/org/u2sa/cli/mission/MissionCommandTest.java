package org.u2sa.cli.mission;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.CommandFixture;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.ForeignSystem;
import org.u2sa.testkit.FreePort;

/** {@code u2sa mission} on a system of another process: one mission, changed step by step. */
@Timeout(120)
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class MissionCommandTest extends CommandFixture {
  private static final String MISSION =
      """
      <mission>
        <timeLimit unit="min">20</timeLimit>
        <home><x>8</x><y>50</y></home>
        <waypoint><name>gate</name><next>buoy</next><next if="failed">dock</next><x>8</x><y>50.001</y></waypoint>
        <waypoint><name>buoy</name><next>dock</next><repeat from="gate" times="2"/><x>8.001</x><y>50</y></waypoint>
        <waypoint><name>dock</name><x>8</x><y>50.5</y><timeLimit>90</timeLimit></waypoint>
      </mission>
      """;

  @TempDir private static Path directory;
  private static ForeignSystem foreign;

  @BeforeAll
  static void start() throws IOException {
    int port = FreePort.find();
    Files.writeString(
        directory.resolve("Manager.xml"),
        "<configuration><variable name=\"COMMUNICATION MANAGER PORT\" type=\"int\" value=\""
            + port
            + "\"/></configuration>");
    Files.writeString(
        directory.resolve("MissionManager.xml"),
        "<configuration><variable name=\"MISSION\" type=\"string\" value=\"mission.xml\"/>"
            + "<variable name=\"DEFAULT THRESHOLD\" type=\"double\" value=\"2\"/></configuration>");
    Files.writeString(directory.resolve("mission.xml"), MISSION);
    Path system =
        Files.writeString(
            directory.resolve("system.xml"),
            "<system id=\"rover\"><communication configuration=\"Manager.xml\"/>"
                + "<service class=\"org.u2sa.mission.MissionManager\" configuration=\"MissionManager.xml\"/>"
                + "<service class=\""
                + StandingRover.class.getName()
                + "\"/></system>");
    foreign = ForeignSystem.start(system, port);
  }

  @AfterAll
  static void end() {
    foreign.close();
  }

  private int run(String... arguments) {
    return runAt("rover", "60", arguments);
  }

  private int runAt(String system, String timeout, String... arguments) {
    List<String> all = new ArrayList<>(List.of("mission"));
    all.addAll(List.of(arguments));
    all.addAll(List.of("--broker", foreign.broker(), "--system", system, "--timeout", timeout));
    out.getBuffer().setLength(0);
    err.getBuffer().setLength(0);
    return u2sa(all.toArray(new String[0]));
  }

  private static String goals(String name, String goals) throws IOException {
    return Files.writeString(directory.resolve(name), "<mission>\n" + goals + "\n</mission>")
        .toString();
  }

  @Test
  @Order(1)
  void show_tellsEachGoalWithStateDistanceAndWhatFollows() {
    assertThat(run("show")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .contains("System rover, mission ")
        .contains("0 of 4 goals done in ")
        .contains(" of 20:00, pursuing gate")
        .containsPattern("> +gate +Waypoint +current +111\\.\\d m +buoy; if failed: dock")
        .containsPattern("buoy +Waypoint +next +71\\.\\d m +gate \\(2 times\\); dock")
        .containsPattern("dock +Waypoint +open +55\\.\\d\\d km +1:30");
  }

  @Test
  @Order(2)
  void show_json_isReadByPrograms() throws IOException {
    assertThat(run("show", "--json")).isEqualTo(ExitCode.DONE);
    JsonNode root = new ObjectMapper().readTree(out.toString());

    assertThat(root.get("current").get(0).asText()).isEqualTo("gate");
    assertThat(root.get("timeLimitS").asDouble()).isEqualTo(1200.0);
    JsonNode gate = root.get("goals").get(0);
    assertThat(gate.get("distanceM").asDouble()).isBetween(111.0, 112.0);
    assertThat(gate.get("next").get(1).get("when").asText()).isEqualTo("if failed");
  }

  @Test
  @Order(3)
  void skip_currentGoal_isAnsweredAndShown() {
    assertThat(run("skip")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("rover: goal \"gate\" skipped; current: buoy");
    run("show");
    assertThat(out.toString()).containsPattern("gate +Waypoint +skipped .*skipped by .+@");
  }

  @Test
  @Order(4)
  void goTo_thenResume_goesThereAndBack() {
    assertThat(run("goto", "home")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("rover: pursuing goal \"home\"");
    assertThat(run("resume")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("rover: resumed at [buoy]");
    assertThat(run("resume")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString()).contains("RESUME was not carried out: nothing to resume");
  }

  @Test
  @Order(5)
  void insert_thenUpdate_changeTheMission() throws IOException {
    String detour =
        goals("detour.xml", "<waypoint><name>detour</name><x>8.002</x><y>50</y></waypoint>");
    assertThat(run("insert", detour, "--after", "buoy")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("rover: inserted \"detour\" after \"buoy\"");
    String moved = goals("moved.xml", "<waypoint><name>detour</name><y>50.01</y></waypoint>");
    assertThat(run("update", moved)).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("rover: updated \"detour\"");
    run("show");
    assertThat(out.toString())
        .containsPattern("buoy +Waypoint +current .* gate \\(2 times\\); detour")
        .containsPattern("detour +Waypoint +open +1\\.12 km +dock");
  }

  @Test
  @Order(6)
  void insert_now_isPursuedAtOnce() throws IOException {
    String first = goals("first.xml", "<waypoint><name>first</name><x>8</x><y>50</y></waypoint>");
    assertThat(run("insert", first, "--now")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("rover: pursuing \"first\", then buoy");
    assertThat(run("insert", first, "--now", "--after", "gate")).isEqualTo(ExitCode.BAD_INPUT);
  }

  @Test
  @Order(7)
  void orders_thatAreWrong_failWithFileAndLine() throws IOException {
    String wrong = goals("wrong.xml", "<waypoint><x>800</x></waypoint>");
    assertThat(run("insert", wrong)).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString())
        .contains(
            "INSERT was not carried out: " + wrong + ", line 2, <x>: 800.0 is outside -180.0");
    assertThat(run("goto", "doc")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString()).contains("no goal \"doc\"", "did you mean \"dock\"?");
    assertThat(run("insert", directory.resolve("none.xml").toString()))
        .isEqualTo(ExitCode.BAD_INPUT);
    String cut = Files.writeString(directory.resolve("cut.xml"), "<mission><way").toString();
    assertThat(run("update", cut)).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("cut.xml, line 1");
  }

  @Test
  @Order(8)
  void orders_thatNobodyAnswers_sayHowLongTheyWaitedAndWhatElseIsThere() {
    assertThat(runAt("rovre", "0.8", "show")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString())
        .contains("rovre: no Mission Manager answered within 0.8 s", "did you mean \"rover\"?");
    assertThat(runAt("rovre", "0.8", "skip")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString())
        .contains("no Mission Manager answered within 0.8 s", "the order may still be carried out");
  }

  @Test
  @Order(9)
  void mission_alone_printsItsHelp() {
    out.getBuffer().setLength(0);
    assertThat(u2sa("mission")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("show", "goto", "skip", "insert", "update", "resume");
  }
}
