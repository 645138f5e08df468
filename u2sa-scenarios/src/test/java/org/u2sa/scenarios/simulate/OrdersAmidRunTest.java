package org.u2sa.scenarios.simulate;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.scenarios.run.CommandLineRun;

/** A rover that drives 11 m to the north, then 13 m to the east, and an operator's orders. */
class OrdersAmidRunTest {
  private static final String KEEP_IN =
      """
      <keepIn>
        <corner><x>9.999</x><y>53.999</y></corner>
        <corner><x>10.001</x><y>53.999</y></corner>
        <corner><x>10.001</x><y>54.001</y></corner>
        <corner><x>9.999</x><y>54.001</y></corner>
      </keepIn>
      """;
  private static final String NEAR_FIRST_WAYPOINT =
      "<keepOut><centre><x>10</x><y>54.00006</y></centre><radius>2</radius></keepOut>";

  @TempDir private Path folder;

  @BeforeEach
  void copy() throws IOException, URISyntaxException {
    Path origin = Path.of(SimulateTest.class.getResource("rover").toURI());
    try (Stream<Path> files = Files.list(origin)) {
      for (Path each : files.toList()) {
        Files.copy(each, folder.resolve(each.getFileName().toString()));
      }
    }
    write("fence.xml", "<fence>" + KEEP_IN + "</fence>");
    write(
        "SafetyManager.xml",
        """
        <configuration>
          <variable name="FENCE" type="string" value="fence.xml"/>
          <variable name="FENCE MARGIN" type="double" value="0.5"/>
          <variable name="ON FENCE" type="string" value="CONTINUE"/>
          <variable name="ON OPERATOR LOSS" type="string" value="CONTINUE"/>
          <variable name="ARM AT START" type="boolean" value="true"/>
        </configuration>
        """);
  }

  private void write(String file, String text) throws IOException {
    Files.writeString(folder.resolve(file), text);
  }

  private CommandLineRun simulate(MissionAction action, double atS, double limitS)
      throws IOException {
    write(
        "Operator.xml",
        "<configuration><variable name=\"FOLDER\" type=\"string\" value=\""
            + folder
            + "\"/><variable name=\"AT\" type=\"double\" value=\""
            + atS
            + "\"/><variable name=\"ACTION\" type=\"string\" value=\""
            + action
            + "\"/></configuration>");
    Path system = folder.resolve("system.xml");
    Files.writeString(
        system,
        Files.readString(system)
            .replace(
                "</system>",
                "<service class=\"org.u2sa.core.safety.SafetyManager\""
                    + " configuration=\"SafetyManager.xml\"/><service class=\""
                    + ScriptedOperator.class.getName()
                    + "\" configuration=\"Operator.xml\"/></system>"));
    List<String> arguments = new ArrayList<>(List.of("simulate", system.toString()));
    arguments.addAll(List.of("--vehicle", folder.resolve("vehicle.xml").toString()));
    arguments.addAll(List.of("--port", "0", "--seed", "3", "--limit", String.valueOf(limitS)));
    arguments.addAll(List.of("--out", folder.resolve("out").toString()));
    return CommandLineRun.of(arguments.toArray(new String[0]));
  }

  private JsonNode summary() throws IOException {
    return new ObjectMapper().readTree(Files.readString(folder.resolve("out/summary.json")));
  }

  @ParameterizedTest
  @EnumSource(names = {"INSERT", "REPLACE"})
  void simulate_orderedGoalNotCompleted_fails(MissionAction action) throws IOException {
    write(
        "ordered-mission.xml",
        "<mission><waypoint><name>far</name><x>10.01</x><y>54.0</y></waypoint></mission>");
    CommandLineRun run = simulate(action, 3.0, 15.0);

    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.FAILED);
    assertThat(run.out()).contains("goal \"far\" was not completed");
    assertThat(summary().get("success").asBoolean()).isFalse();
  }

  @Test
  void simulate_replacementCompleted_succeeds() throws IOException {
    write(
        "ordered-mission.xml",
        "<mission><waypoint><name>near</name><x>10.00005</x><y>54.0</y></waypoint></mission>");
    CommandLineRun run = simulate(MissionAction.REPLACE, 3.0, 60.0);

    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    assertThat(summary().get("goals").asInt()).isEqualTo(1);
    assertThat(summary().get("fenceBreaches").asInt()).isZero();
  }

  @Test
  void simulate_keepOutAreaLiftedAfterItWasCrossed_isABreach() throws IOException {
    write("fence.xml", "<fence>" + KEEP_IN + NEAR_FIRST_WAYPOINT + "</fence>");
    write("ordered-fence.xml", "<fence>" + KEEP_IN + "</fence>");
    simulate(MissionAction.REPLACE, 30.0, 32.0);

    assertThat(Files.readString(folder.resolve("out/logs/SafetyManager.log")))
        .contains("fence: REPLACE by \"ann\": fence of an order by ann in force");
    assertThat(summary().get("fenceBreaches").asInt()).isEqualTo(1);
  }

  @Test
  void simulate_keepOutAreaOrderedAfterItWasLeft_isNoBreach() throws IOException {
    write("ordered-fence.xml", "<fence>" + KEEP_IN + NEAR_FIRST_WAYPOINT + "</fence>");
    simulate(MissionAction.REPLACE, 30.0, 32.0);

    assertThat(Files.readString(folder.resolve("out/logs/SafetyManager.log")))
        .contains("fence: REPLACE by \"ann\": fence of an order by ann in force");
    assertThat(summary().get("fenceBreaches").asInt()).isZero();
  }

  @Test
  void simulate_keepOutAreaOrderedBeforeItIsCrossed_isABreach() throws IOException {
    write("ordered-fence.xml", "<fence>" + KEEP_IN + NEAR_FIRST_WAYPOINT + "</fence>");
    simulate(MissionAction.REPLACE, 3.0, 32.0);

    assertThat(summary().get("fenceBreaches").asInt()).isEqualTo(1);
  }
}
