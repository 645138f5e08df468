package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.GoalList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.Waypoint;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ArmCommand;
import org.u2sa.messages.contract.ArmingState;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.EmergencyStop;
import org.u2sa.messages.contract.FailsafeAction;
import org.u2sa.messages.contract.FailsafeState;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.OperatorHeartbeat;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

@Timeout(30)
class SafetyManagerTest {
  private final ServiceKit kit = new ServiceKit();
  private double sigmaM = 1.0;
  private boolean position = true;

  @BeforeEach
  void configure() {
    kit.with("ACTUATOR SERVICES", "Motor, Rudder").with("LOW BATTERY VOLTAGE", 11.0);
    kit.with("CRITICAL BATTERY REMAINING", 10.0).with("ON CRITICAL BATTERY", "STOP");
  }

  @AfterEach
  void close() {
    kit.close();
  }

  private void live(double seconds) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.1) {
      StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU);
      if (position) {
        state.x(0.0).y(0.0);
      }
      state.xSigma(sigmaM);
      kit.send(Channels.STATE, state);
      kit.advance(0.1);
    }
  }

  private SafetyManager start() {
    SafetyManager manager = startManager();
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(waypoint())));
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement().actuatorName("MOTOR").minimum(0.0).maximum(100.0));
    battery(12.5, 80.0);
    return manager;
  }

  /** And waits until no predecessor can be there. */
  private SafetyManager startManager() {
    SafetyManager manager = kit.start(SafetyManager::new);
    kit.advance(0.6);
    return manager;
  }

  private static Waypoint waypoint() {
    return new Waypoint().uid("1").x(1.0).y(1.0).horizontalThreshold(1.0);
  }

  private void battery(double volts, double percent) {
    kit.publish(
        Channels.POWER, new BatteryState().sensorName("main").voltage(volts).remaining(percent));
  }

  private ArmingState arm(boolean arm) {
    kit.publish(Channels.ARMING, new ArmCommand().requestId("7").arm(arm).operator("Ann"));
    kit.advance(0.1);
    return kit.published(Channels.ARMING_STATE).stream()
        .filter(state -> state.requestId().isPresent())
        .reduce((first, second) -> second)
        .orElseThrow();
  }

  private void startArmed() {
    startArmedManager();
  }

  private SafetyManager startArmedManager() {
    SafetyManager manager = start();
    live(0.3);
    assertThat(arm(true).armed()).isTrue();
    return manager;
  }

  private FailsafeState failsafe() {
    return kit.latest(Channels.FAILSAFE).orElseThrow();
  }

  private void condition(String service, Condition condition) {
    kit.publish(Channels.CONDITIONS, given(service, condition));
  }

  private static ServiceCondition given(String service, Condition condition) {
    return new ServiceCondition().serviceName(service).condition(condition).reason("seen so");
  }

  @Test
  void arm_everythingThere_armsAndAnswers() {
    startArmed();

    assertThat(arm(true).reasons()).isEmpty();
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void arm_nothingThere_saysAllReasons() {
    kit.with("OPERATOR REQUIRED", true).with("HEALTH MONITOR REQUIRED", true);
    kit.with("ON FENCE", "LAND");
    startManager();
    condition("PathPlanner", Condition.HUNG);

    ArmingState state = arm(true);

    assertThat(state.armed()).isFalse();
    assertThat(state.requestId()).contains("7");
    assertThat(state.reasons())
        .containsExactly(
            "service PathPlanner is HUNG: seen so",
            "operator link: no operator was heard",
            "position: no state yet",
            "health monitor: no HealthMonitor was heard",
            "low battery: a level is configured, but no battery was heard",
            "critical battery: a level is configured, but no battery was heard",
            "mission: no goals",
            "actuators: none is there",
            "failsafe matrix: ON FENCE is LAND, but no Mission Manager has answered whether it has a LAND MISSION");
  }

  @Test
  void arm_outsideTheFenceUncertainAndLow_saysSoWithTheValues(@TempDir Path directory)
      throws IOException {
    Path fence = directory.resolve("fence.xml");
    String text =
        "<fence><reference>Local ENU</reference><keepIn><corner><x>10</x><y>10</y></corner>"
            + "<corner><x>90</x><y>10</y></corner><corner><x>90</x><y>90</y></corner></keepIn></fence>";
    Files.write(fence, text.getBytes(StandardCharsets.UTF_8));
    kit.with("FENCE", fence.toString()).with("REQUIRED ACTUATORS", "MOTOR, RUDDER");
    start();
    battery(10.5, 80.0);
    sigmaM = 60.0;
    live(0.3);

    assertThat(arm(true).reasons())
        .containsExactly(
            "position: uncertain by 60 m, limit 50 m",
            "low battery: main, voltage 10.5 below 11.0 V",
            "geofence: outside the keep-in area, or inside a keep-out one",
            "actuators: not there: RUDDER");
  }

  @Test
  void armAtStart_checksPassLater_armsOnceByItself() {
    kit.with("ARM AT START", true);
    start();
    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();

    live(0.3);
    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isTrue();
    arm(false);
    live(1.0);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();
  }

  @Test
  void failsafe_notArmed_isContinueWhateverIsWrong() {
    startManager();
    kit.advance(2.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void operator_neverHeard_isNotMissed() {
    startArmed();
    live(8.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void operator_lost_returnsAfterItsDeadlineAndGoesOnUntilArmedAnew() {
    startArmed();
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    live(4.9);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    live(0.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    assertThat(failsafe().causes()).singleElement().asString().startsWith("operator link: \"Ann\"");

    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    live(4.5);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    assertThat(failsafe().causes().get(0)).contains("over; goes on until armed anew");
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    arm(true);
    live(0.2);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void operator_lostAndBackWithResume_continuesAfterTheCauseWasGoneForAWhile() {
    kit.with("RESUME", true);
    startArmed();
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    live(5.3);
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));

    live(2.8);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    live(0.4);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void position_uncertainOrAbsentOrStale_holdsAndContinuesWhenItIsBack() {
    startArmed();
    sigmaM = 51.0;
    live(0.2);
    assertThat(failsafe().causes()).containsExactly("position: uncertain by 51 m, limit 50 m");
    sigmaM = 1.0;
    position = false;
    live(3.5);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    assertThat(failsafe().causes()).containsExactly("position: state lacks x or y");
    position = true;
    live(3.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);

    kit.advance(1.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    assertThat(failsafe().causes().toString()).contains("old", "state estimator: no fresh states");
  }

  @Test
  void estimatorAndActuatorLink_byTheMonitorsWord_hold() {
    startArmed();
    condition("StateEstimator", Condition.STALLED);
    condition("Rudder", Condition.LOST);
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    assertThat(failsafe().causes())
        .containsExactly(
            "state estimator: service StateEstimator is STALLED: seen so",
            "actuator link: service Rudder is LOST: seen so");

    condition("StateEstimator", Condition.ALIVE);
    condition("Rudder", Condition.SILENT);
    live(3.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void service_givenUpByTheMonitor_holdsAndOneThatIsRestartedDoesNot() {
    startArmed();
    kit.publish(Channels.CONDITIONS, given("PathPlanner", Condition.DEAD).action("restart 1 of 3"));
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);

    kit.publish(
        Channels.CONDITIONS,
        given("PathPlanner", Condition.DEAD).action("failsafe, given up after 3 restarts"));
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    assertThat(failsafe().causes())
        .containsExactly("service given up: service PathPlanner is DEAD: seen so");

    condition("PathPlanner", Condition.ALIVE);
    live(3.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void monitor_silent_isACauseByWhichTheVehicleContinues() {
    startArmed();
    kit.publish(
        Channels.HEALTH,
        new HealthReport().serviceName("HealthMonitor").status(ServiceStatus.RUNNING));
    live(4.3);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(failsafe().causes())
        .singleElement()
        .asString()
        .startsWith("health monitor: HealthMonitor silent for 4.");
  }

  @Test
  void battery_lowForItsTimeOnly_returnsThenCriticalStops() {
    startArmed();
    battery(10.9, 80.0);
    live(9.5);
    battery(11.2, 80.0); // it was a load
    live(0.2);
    battery(10.9, 80.0);
    live(9.7);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    live(0.5);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);

    battery(10.9, 9.0);
    live(10.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);
    EmergencyStop stop = kit.latest(Channels.EMERGENCY_STOP).orElseThrow();
    assertThat(stop.active()).isTrue();
    assertThat(stop.reason()).startsWith("critical battery: main, remaining 9.0 below 10.0 %");
  }

  @Test
  void emergencyStop_isRepeatedWhileItHoldsDisarmsAndIsClearedForGood() {
    startArmed();
    EmergencyStop stop = new EmergencyStop().active(true).operator("Ann").reason("smoke");
    kit.publish(Channels.EMERGENCY_STOP, stop);
    live(3.0);
    assertThat(kit.published(Channels.EMERGENCY_STOP)).hasSizeBetween(2, 4).allMatch(stop::equals);
    assertThat(arm(true).reasons()).contains("emergency stop by \"Ann\": smoke");
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.STOP);

    kit.forget();
    EmergencyStop clear =
        new EmergencyStop().active(false).clears(stop.timestamp().orElseThrow()).operator("Ann");
    kit.publish(Channels.EMERGENCY_STOP, clear);
    live(3.0);

    assertThat(kit.published(Channels.EMERGENCY_STOP)).hasSize(1).allMatch(clear::equals);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
    assertThat(arm(true).armed()).isTrue();
  }

  @Test
  void start_anewInAFailsafe_staysArmedAndGoesOnWithIt() {
    SafetyManager before = startArmedManager();
    kit.publish(Channels.OPERATOR, new OperatorHeartbeat().operator("Ann"));
    live(5.3);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.RETURN);
    before.kill();
    kit.forget();
    live(5.0);

    startManager();
    live(3.0);

    assertThat(kit.published(Channels.FAILSAFE))
        .isNotEmpty()
        .allMatch(state -> state.action() == FailsafeAction.RETURN);
    assertThat(failsafe().causes().get(0))
        .startsWith("operator link: \"Ann\" silent for ")
        .endsWith("s (over; goes on until armed anew)");
    assertThat(kit.published(Channels.ARMING_STATE)).isNotEmpty().allMatch(ArmingState::armed);
    arm(true);
    live(0.2);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void start_longAfterAnother_isAnotherRun() {
    startArmedManager().kill();
    kit.advance(25.0);

    startManager();

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();
  }

  @Test
  void start_anewAfterADisarm_staysDisarmed() {
    SafetyManager before = startArmedManager();
    arm(false);
    before.kill();

    startManager();
    live(3.0);

    assertThat(kit.latest(Channels.ARMING_STATE).orElseThrow().armed()).isFalse();
  }

  @Test
  void failsafe_unchanged_isRepeatedSlowly() {
    startArmed();
    kit.forget();
    live(5.0);

    assertThat(kit.published(Channels.FAILSAFE)).hasSize(5);
    assertThat(kit.published(Channels.ARMING_STATE)).hasSize(5);
  }
}
