package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.mission.MissionManager;
import org.u2sa.service.ServiceContext;

/**
 * Files that variables name: refused where they are wrong, and trusted only as they were loaded.
 */
@Timeout(30)
class NamedFilesTest extends WatchedVehicle {
  private static final String SQUARE =
      "<fence><reference>Local ENU</reference><keepIn><corner><x>-%1$s</x><y>-%1$s</y></corner>"
          + "<corner><x>%1$s</x><y>-%1$s</y></corner><corner><x>%1$s</x><y>%1$s</y></corner>"
          + "<corner><x>-%1$s</x><y>%1$s</y></corner></keepIn></fence>";
  private static final String MISSION =
      "<mission><Waypoint><uid>%s</uid><referenceFrame>Local NED</referenceFrame>"
          + "<x>10</x><y>0</y></Waypoint></mission>";

  @TempDir private Path folder;
  private Path fence;
  private Path landing;

  @BeforeEach
  void write() throws IOException {
    fence = write("fence.xml", String.format(SQUARE, "90"));
    landing = write("landing.xml", String.format(MISSION, "runway"));
  }

  private Path write(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text);
  }

  private MissionManager startMissionManager() throws IOException {
    kit.withoutVariables().with("LAND MISSION", landing.toString()).with("DEFAULT THRESHOLD", 1.0);
    kit.with("MISSION", write("mission.xml", String.format(MISSION, "1")).toString());
    return kit.start(MissionManager::new);
  }

  /** With a mission to land by, and a fence. */
  private void startReady() throws IOException {
    startMissionManager();
    kit.withoutVariables().with("ON LOW BATTERY", "LAND").with("LOW BATTERY VOLTAGE", 11.0);
    kit.with("FENCE", fence.toString());
    startManager();
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement().actuatorName("MOTOR").minimum(0.0).maximum(100.0));
    battery(12.5, 80.0);
    live(0.3);
  }

  @Test
  void start_fileThatIsNotThere_isRefusedNamingVariableAndFile() {
    kit.with("FENCE", folder.resolve("none.xml").toString());
    ServiceContext first = kit.context();
    assertThatThrownBy(() -> new SafetyManager(first))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("\"FENCE\"")
        .hasMessageContaining("none.xml");

    for (String variable : List.of("MISSION", "RETURN MISSION", "LAND MISSION")) {
      kit.withoutVariables().with("MISSION", landing.toString()).with("DEFAULT THRESHOLD", 1.0);
      kit.with(variable, folder.resolve("none.xml").toString());
      ServiceContext context = kit.context();
      assertThatThrownBy(() -> new MissionManager(context))
          .isInstanceOf(BadInputException.class)
          .hasMessageContaining("variable \"" + variable + "\": ")
          .hasMessageContaining("none.xml");
      context.abandon();
    }
  }

  @Test
  void set_missionFileThatIsNotThereOrWrong_isRefusedAndWhatWasStays() throws IOException {
    MissionManager manager = startMissionManager();
    Path wrong = write("wrong.xml", "<fence/>");

    for (String variable : List.of("MISSION", "RETURN MISSION", "LAND MISSION")) {
      assertThat(manager.setVariable(variable, folder.resolve("none.xml").toString())).isFalse();
      assertThat(manager.setVariable(variable, wrong.toString())).isFalse();
      assertThat(kit.log("MissionManager"))
          .anyMatch(line -> line.contains("variable \"" + variable + "\"") && line.contains("none"))
          .anyMatch(
              line -> line.contains("variable \"" + variable + "\"") && line.contains("wrong"));
    }
    assertThat(manager.getVariable("LAND MISSION")).isEqualTo(landing.toString());
    assertThat(manager.setVariable("LAND MISSION", "")).isTrue();
  }

  @Test
  void set_fenceThatIsNotThereOrTooNarrow_isRefusedAndWhatWasStays() {
    kit.with("FENCE", fence.toString());
    SafetyManager manager = startManager();

    assertThat(manager.setVariable("FENCE", folder.resolve("none.xml").toString())).isFalse();
    assertThat(manager.setVariable("FENCE MARGIN", 100.0)).isFalse();

    assertThat(kit.log("SafetyManager"))
        .anyMatch(line -> line.contains("\"FENCE\"") && line.contains("none.xml"))
        .anyMatch(line -> line.contains("FENCE MARGIN"));
    assertThat(manager.getVariable("FENCE")).isEqualTo(fence.toString());
  }

  @Test
  void change_ofTheFenceWhileArmed_actsAtOnce() throws IOException {
    startArmedManager();
    Path far = write("far.xml", String.format(SQUARE, "90").replace(">-90<", ">50<"));

    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange()
            .serviceName("SafetyManager")
            .variableName("FENCE")
            .value(far.toString()));
    live(0.3);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    assertThat(failsafe().causes()).containsExactly("geofence: outside");
  }

  @Test
  void arm_landingMissionLoaded_armsAndWithoutItSaysSo() throws IOException {
    startReady();
    assertThat(arm(true).reasons()).isEmpty();

    kit.publish(Channels.GOALS, new GoalList().goals(List.of(waypoint())).landGoals(0));
    arm(false);
    assertThat(arm(true).reasons())
        .containsExactly(
            "failsafe matrix: ON LOW BATTERY is LAND, but the Mission Manager has loaded no LAND MISSION");
  }

  @Test
  void arm_filesDeletedOrSpoiltAfterTheyWereLoaded_isRefusedAndWhatWasLoadedIsInForce()
      throws IOException {
    startReady();
    Files.delete(landing);
    write("fence.xml", "<fence/>");
    live(1.3); // the Safety Manager repeats the failsafe each second

    assertThat(arm(true).reasons())
        .hasSize(2)
        .anyMatch(
            reason ->
                reason.startsWith("geofence: ")
                    && reason.contains("fence.xml")
                    && reason.endsWith("the previously loaded values stay in force"))
        .anyMatch(
            reason ->
                reason.startsWith("mission: LAND MISSION: ")
                    && reason.endsWith("the previously loaded values stay in force"));
    kit.publish(
        Channels.FAILSAFE,
        new FailsafeState().action(FailsafeAction.LAND).causes(List.of("a test")));
    assertThat(kit.latest(Channels.GOALS).orElseThrow().goals().get(0).uid())
        .isEqualTo("LAND runway");
  }

  @Test
  void arm_fileChangedForAnother_saysThatItIsNotInForce() throws IOException {
    startReady();
    write("fence.xml", String.format(SQUARE, "950"));
    live(0.2);

    assertThat(arm(true).reasons())
        .singleElement()
        .asString()
        .contains("fence.xml: was changed after it was loaded");
  }
}
