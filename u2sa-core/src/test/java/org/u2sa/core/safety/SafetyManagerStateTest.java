package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;

/** From its start, through stops and disarming, what a SafetyManager says and keeps. */
@Timeout(120)
class SafetyManagerStateTest extends WatchedVehicle {
  private static final String SQUARE =
      "<fence><reference>%s</reference><keepIn><corner><x>-%2$s</x><y>-%2$s</y></corner>"
          + "<corner><x>%2$s</x><y>-%2$s</y></corner><corner><x>%2$s</x><y>%2$s</y></corner>"
          + "<corner><x>-%2$s</x><y>%2$s</y></corner></keepIn></fence>";

  @TempDir private Path folder;

  private String fence(String frame, String half) throws IOException {
    Path file = folder.resolve(frame + ".xml");
    return Files.writeString(file, String.format(SQUARE, frame, half)).toString();
  }

  private void change(String variable, Object value) {
    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange()
            .serviceName("SafetyManager")
            .variableName(variable)
            .value(value.toString()));
  }

  private void predecessorWasArmed() {
    ArmingState state = new ArmingState().armed(true);
    kit.publish(Channels.ARMING_STATE, state.reasons(List.of()));
    kit.forget();
  }

  @Test
  void start_listensForHalfASecond_beforeItSaysAnything() {
    kit.start(SafetyManager::new);
    kit.advance(0.4);
    assertThat(kit.published(Channels.FAILSAFE)).isEmpty();
    assertThat(kit.published(Channels.ARMING_STATE)).isEmpty();

    kit.advance(0.1);

    assertThat(kit.published(Channels.FAILSAFE)).hasSize(1);
    assertThat(kit.published(Channels.ARMING_STATE)).hasSize(1);
  }

  @Test
  void restart_predecessorIsHeardLate_staysArmedAndSaysSo() {
    SafetyManager before = startArmedManager();
    before.kill();
    kit.advance(25.0); // what it said is old; a broker that was away brings what it said last
    kit.restart(before, SafetyManager::new);
    kit.advance(0.3);
    predecessorWasArmed();
    kit.advance(0.3);

    assertThat(kit.published(Channels.ARMING_STATE)).isNotEmpty().allMatch(ArmingState::armed);
    assertThat(kit.log("SafetyManager"))
        .anyMatch(line -> line.endsWith("still armed, as the previous Safety Manager was"));
  }

  @Test
  void start_disarmedWhileItListens_predecessorsWordsBeforeAndAfterwardsDoNotCount() {
    kit.start(SafetyManager::new);
    predecessorWasArmed();
    kit.publish(Channels.ARMING, new ArmCommand().requestId("7").arm(false).operator("Ann"));
    kit.advance(0.2);
    predecessorWasArmed();
    kit.advance(1.0);

    assertThat(kit.published(Channels.ARMING_STATE)).isNotEmpty().noneMatch(ArmingState::armed);
  }

  @Test
  void command_betweenTwoSteps_isAnsweredAtTheNextOne() {
    startManager();
    kit.advance(0.05);
    kit.forget();
    kit.publish(Channels.ARMING, new ArmCommand().requestId("7").arm(true).operator("Ann"));
    assertThat(kit.published(Channels.ARMING_STATE)).isEmpty();

    kit.advance(0.05);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().requestId()).contains("7");
  }

  @Test
  void repeat_overTwentySeconds_isNeverLateByAStep() {
    startArmed();
    kit.forget();
    live(20.0);

    assertThat(kit.published(Channels.FAILSAFE)).hasSize(20);
  }

  private List<String> stopsInItsHealth() {
    return kit.published(Channels.HEALTH).stream()
        .filter(report -> report.serviceName().equals("SafetyManager"))
        .reduce((first, second) -> second)
        .flatMap(HealthReport::emergencyStops)
        .orElseThrow();
  }

  /** By this an operator knows that a stop has reached who decides. */
  @Test
  void health_fromTheStartOn_saysWhichStopsItHeeds() {
    startManager();
    live(2.0);
    assertThat(stopsInItsHealth()).isEmpty();

    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).stopId("Ann 1"));
    live(2.0);

    assertThat(stopsInItsHealth()).containsExactly("Ann 1");
  }

  @Test
  void disarm_inAFailsafe_leavesNoCauseBehindEvenForALaterStop() {
    startArmed();
    position = false;
    live(0.3);
    assertThat(failsafe().causes()).hasSize(1);
    arm(false);
    live(1.0);
    assertThat(failsafe()).extracting(FailsafeState::action).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(failsafe().causes()).isEmpty();

    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).stopId("Ann 1"));
    live(1.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
    assertThat(failsafe().causes()).isEmpty();
  }

  @Test
  void clear_ofAStopByAFailsafe_leavesNoCauseBehindForALaterStop() {
    kit.with("BATTERY TIME", 0.0);
    startArmed();
    battery(12.5, 9.0);
    live(0.3);
    String own = kit.latest(Channels.EMERGENCY_STOP).orElseThrow().stopId().orElseThrow();
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(false).lifts(List.of(own)));
    live(1.0);
    assertThat(failsafe().causes()).isEmpty();
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).stopId("Ann 1"));
    live(1.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
    assertThat(failsafe().causes()).isEmpty();
  }

  @Test
  void change_ofTheMarginAlone_drawsTheFenceInAtOnce() throws IOException {
    kit.with("FENCE", fence("Local ENU", "90"));
    startArmed();
    position = false; // it is at the origin, and states lack x and y from now on
    change("FENCE MARGIN", 20.0);
    live(0.2);

    assertThat(kit.log("SafetyManager")).anyMatch(line -> line.endsWith("Local ENU.xml loaded"));
  }

  @Test
  void fence_onTheEarth_areThoseOfTheKeepInAreaWithoutItsMargin() throws IOException {
    kit.with("FENCE", fence("Global", "0.001")).with("FENCE MARGIN", 20.0);
    assertThat(startManager().fence().orElseThrow().corners(new Geodetic(5.0, 5.0, 0.0)))
        .hasSize(5)
        .allMatch(corner -> Math.abs(Math.abs(corner.latitudeDeg()) - 0.001) < 1e-9)
        .allMatch(corner -> Math.abs(Math.abs(corner.longitudeDeg()) - 0.001) < 1e-9);
  }

  /** A fence that its states do not fit must not keep the other watches from acting. */
  @Test
  void change_toAFenceOfAnotherFrameWhileArmed_isACauseAndOtherCausesStillCount()
      throws IOException {
    kit.with("ON FENCE", "HOLD");
    startArmed();
    change("FENCE", fence("Global", "1"));
    live(0.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    assertThat(failsafe().causes())
        .containsExactly("geofence: a state in LOCAL_ENU does not fit a fence on the earth");

    battery(10.0, 80.0);
    live(10.5);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
  }
}
