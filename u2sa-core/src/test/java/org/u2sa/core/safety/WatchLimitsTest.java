package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.BatteryState;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.OperatorHeartbeat;

/** What each watch says at exactly its limit and one microsecond, or one step, beyond. */
class WatchLimitsTest {
  private static final long SECOND = 1_000_000; // µs

  private static Supplier<SafetyVariables> with(Map<String, ?> values) {
    return XmlConfiguration.inMemory("test", values).settings(SafetyVariables.class);
  }

  @Test
  void operator_heardAtTimeZero_isLostOnlyBeyondItsDeadline() {
    HeartbeatWatch watch = HeartbeatWatch.ofOperators(with(Map.of("OPERATOR DEADLINE", 5.0)));
    watch.see(new OperatorHeartbeat().operator("Ann"), 0);

    assertThat(watch.trouble(5 * SECOND)).isEmpty();
    assertThat(watch.trouble(5 * SECOND + 1)).contains("\"Ann\" silent for 5.0 s");
  }

  @Test
  void operator_silentForLong_isTroubleOfItsOwnIfConfigured() {
    HeartbeatWatch watch =
        HeartbeatWatch.ofLongLostOperators(with(Map.of("LONG OPERATOR DEADLINE", 180.0)));
    HeartbeatWatch never = HeartbeatWatch.ofLongLostOperators(with(Map.of()));
    assertThat(watch.trouble(400 * SECOND)).as("never heard").isEmpty();
    watch.see(new OperatorHeartbeat().operator("Ann"), 0);
    never.see(new OperatorHeartbeat().operator("Ann"), 0);

    assertThat(watch.trouble(180 * SECOND)).isEmpty();
    assertThat(watch.trouble(181 * SECOND)).contains("\"Ann\" silent for 181.0 s");
    assertThat(never.trouble(100_000 * SECOND)).isEmpty();
    assertThat(watch.hazard().words()).isEqualTo("operator link for long");
  }

  @Test
  void operator_heardAtTimeZeroAndRequired_isThere() {
    HeartbeatWatch watch = HeartbeatWatch.ofOperators(with(Map.of("OPERATOR REQUIRED", true)));
    assertThat(watch.objection(0)).contains("no operator heard");

    watch.see(new OperatorHeartbeat().operator("Ann"), 0);

    assertThat(watch.objection(0)).isEmpty();
  }

  @Test
  void monitor_heardAtTimeZero_isLostOnlyBeyondItsDeadline() {
    HeartbeatWatch watch = HeartbeatWatch.ofMonitor(with(Map.of("HEALTH MONITOR DEADLINE", 4.0)));
    HealthReport report = new HealthReport().serviceName("HealthMonitor");
    watch.see(report.status(ServiceStatus.RUNNING), 0);

    assertThat(watch.trouble(4 * SECOND)).isEmpty();
    assertThat(watch.trouble(4 * SECOND + 1)).contains("HealthMonitor silent for 4.0 s");
  }

  @Test
  void monitor_reportsThatItStopsOrAnotherServiceReports_isNotHeard() {
    HeartbeatWatch watch = HeartbeatWatch.ofMonitor(with(Map.of("HEALTH MONITOR REQUIRED", true)));
    HealthReport stops = new HealthReport().serviceName("HealthMonitor");
    watch.see(stops.status(ServiceStatus.STOPPING), 0);
    watch.see(new HealthReport().serviceName("Control").status(ServiceStatus.RUNNING), 0);

    assertThat(watch.objection(0)).contains("no HealthMonitor heard");
  }

  private static StateInformation state(long timestampMicros) {
    StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU);
    state.x(0.0).y(0.0).timestamp(timestampMicros);
    return state;
  }

  @Test
  void state_asOldAsItsDeadline_isFreshAndOneMicrosecondLaterNot() {
    PositionWatch watch = new PositionWatch(with(Map.of("STATE DEADLINE", 1.0)));
    watch.see(state(0), 0);

    assertThat(watch.trouble(SECOND)).isEmpty();
    assertThat(watch.fresh(SECOND)).isPresent();
    assertThat(watch.trouble(SECOND + 1)).contains("state is 1.0 s old");
    assertThat(watch.fresh(SECOND + 1)).isEmpty();
  }

  @Test
  void state_withoutTimestamp_isNotTaken() {
    PositionWatch watch = new PositionWatch(with(Map.of()));
    watch.see(new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU).x(0.0).y(0.0), 0);

    assertThat(watch.trouble(0)).contains("no state yet");
  }

  @ParameterizedTest
  @CsvSource({"50.0, 1.0, true", "1.0, 50.0, true", "50.1, 1.0, false", "1.0, 50.1, false"})
  void state_uncertainInEitherDirection_isLostOnlyAboveTheLimit(
      double xSigmaM, double ySigmaM, boolean known) {
    PositionWatch watch = new PositionWatch(with(Map.of("POSITION SIGMA LIMIT", 50.0)));
    watch.see(state(0).xSigma(xSigmaM).ySigma(ySigmaM), 0);

    assertThat(watch.trouble(0).isEmpty()).isEqualTo(known);
  }

  @ParameterizedTest
  @CsvSource({"x", "y"})
  void state_withOneCoordinateOnly_isNoPosition(String present) {
    PositionWatch watch = new PositionWatch(with(Map.of()));
    StateInformation half = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU);
    half.timestamp(0L);
    watch.see(present.equals("x") ? half.x(0.0) : half.y(0.0), 0);

    assertThat(watch.trouble(0)).contains("state lacks x or y");
  }

  private static BatteryWatch battery(double volts, double percent, double seconds) {
    return BatteryWatch.low(
        with(
            Map.of(
                "LOW BATTERY VOLTAGE", volts,
                "LOW BATTERY REMAINING", percent,
                "BATTERY TIME", seconds)));
  }

  private static BatteryState state(String name, double volts, double percent) {
    return new BatteryState().sensorName(name).voltage(volts).remaining(percent);
  }

  @Test
  void battery_exactlyAtBothLevels_isNotLow() {
    BatteryWatch watch = battery(11.0, 20.0, 0.0);
    watch.see(state("main", 11.0, 20.0), 0);

    assertThat(watch.trouble(SECOND)).isEmpty();
    assertThat(watch.objection(SECOND)).isEmpty();
  }

  @Test
  void battery_inventedBesideTheChosenOnes_isIgnored() {
    BatteryWatch watch =
        BatteryWatch.low(with(Map.of("LOW BATTERY VOLTAGE", 11.0, "BATTERIES", "main, spare")));
    watch.see(state("invented", 5.0, 90.0), 0);
    watch.see(state("main", 12.0, 90.0), 0);

    assertThat(watch.objection(SECOND)).contains("not heard: spare");
    assertThat(watch.trouble(60 * SECOND)).isEmpty();

    watch.see(state("spare", 12.0, 90.0), SECOND);
    assertThat(watch.objection(SECOND)).isEmpty();
    watch.see(state("spare", 5.0, 90.0), SECOND);
    assertThat(watch.objection(SECOND)).contains("spare, voltage 5.0 below 11.0 V");
  }

  @Test
  void battery_voltageWithManyDigits_isRoundedDown() {
    BatteryWatch watch = battery(11.0, 0.0, 0.0);
    watch.see(state("main", 10.999999999, 90.0), 0);
    assertThat(watch.trouble(SECOND)).contains("main, voltage 10.99 below 11.0 V");

    watch.see(state("main", 0.4354838654398918, 90.0), SECOND);
    assertThat(watch.trouble(2 * SECOND)).contains("main, voltage 0.43 below 11.0 V");
  }

  @Test
  void battery_emptyOneAfterManyInvented_isStillHeard() {
    BatteryWatch watch = battery(11.0, 0.0, 0.0);
    for (int i = 0; i < 1_000; i++) {
      watch.see(state("invented" + i, 12.0, 90.0), 0);
    }
    watch.see(state("main", 5.0, 90.0), 0);

    assertThat(watch.trouble(SECOND)).contains("main, voltage 5.0 below 11.0 V");
  }

  @Test
  void battery_emptyWhereNoLevelIsConfigured_isNotLookedAt() {
    BatteryWatch watch = battery(0.0, 0.0, 0.0);
    assertThat(watch.objection(0)).isEmpty();

    watch.see(state("main", 0.0, 0.0), 0);

    assertThat(watch.trouble(SECOND)).isEmpty();
  }

  @ParameterizedTest
  @CsvSource({"11.0, 0.0", "0.0, 20.0"})
  void battery_oneLevelConfiguredAndNoneHeard_isSaidBeforeArming(double volts, double percent) {
    BatteryWatch watch = battery(volts, percent, 0.0);

    assertThat(watch.objection(0)).contains("a threshold is set, but no battery heard");
    assertThat(watch.trouble(SECOND)).isEmpty();
  }

  @Test
  void battery_lowForExactlyItsTime_isTroubleFromThenOn() {
    BatteryWatch watch = battery(11.0, 20.0, 10.0);
    watch.see(state("main", 10.9, 19.0), SECOND);
    watch.see(state("main", 10.8, 19.0), 9 * SECOND);

    assertThat(watch.trouble(11 * SECOND - 1)).isEmpty();
    assertThat(watch.trouble(11 * SECOND))
        .contains("main, voltage 10.8 below 11.0 V, remaining 19.0 below 20.0 %");
  }

  @Test
  void battery_oneOfTwoRecovers_theOtherStaysLowSinceItsOwnTime() {
    BatteryWatch watch = battery(11.0, 0.0, 10.0);
    watch.see(state("aft", 10.5, 50.0), 0);
    watch.see(state("main", 10.9, 50.0), SECOND);
    watch.see(state("aft", 11.5, 50.0), 2 * SECOND);

    assertThat(watch.trouble(11 * SECOND - 1)).isEmpty();
    assertThat(watch.trouble(11 * SECOND)).contains("main, voltage 10.9 below 11.0 V");
  }

  private static HealthReport motor(long obeyed, long refused) {
    HealthReport report = new HealthReport().serviceName("Motor").instance("first");
    return report.commandsObeyed(obeyed).commandsRefused(refused);
  }

  private static ActuationWatch actuation() {
    ActuationWatch watch = new ActuationWatch(with(Map.of("REFUSAL TIME", 2.0)));
    watch.see(new ArmingState().armed(true), 0);
    return watch;
  }

  @Test
  void actuation_refusesAllForExactlyItsTime_isTroubleWithTheCount() {
    ActuationWatch watch = actuation();
    watch.see(motor(10, 5), 0);
    watch.see(motor(10, 8), SECOND);
    watch.see(motor(10, 30), 3 * SECOND - 1);

    assertThat(watch.trouble(3 * SECOND - 1)).isEmpty();
    assertThat(watch.trouble(3 * SECOND)).contains("Motor refuses all commands, 25 in 2.0 s");
  }

  @Test
  void actuation_serviceThatTheSettingsDoNotName_isIgnored() {
    ActuationWatch watch =
        new ActuationWatch(
            with(Map.of("REFUSAL TIME", 2.0, "ACTUATOR SERVICES", "Rudder, Engine")));
    watch.see(motor(10, 5), 0);
    watch.see(motor(10, 8), SECOND);
    watch.see(motor(10, 30), 3 * SECOND);

    assertThat(watch.trouble(3 * SECOND)).isEmpty();
  }

  /** Whoever commands nothing any more is not refused any more. */
  @Test
  void actuation_refusedLastLongerAgoThanItsTime_isNoTrouble() {
    ActuationWatch watch = actuation();
    watch.see(motor(10, 0), 0);
    watch.see(motor(10, 1), SECOND);
    watch.see(motor(10, 2), 2 * SECOND);

    assertThat(watch.trouble(4 * SECOND)).isPresent();
    assertThat(watch.trouble(4 * SECOND + 1)).isEmpty();
  }

  @Test
  void actuation_reportBetweenWithoutACommand_neitherEndsNorProlongsTheRefusal() {
    ActuationWatch watch = actuation();
    watch.see(motor(10, 0), 0);
    watch.see(motor(10, 1), SECOND);
    watch.see(motor(10, 1), 2 * SECOND);
    watch.see(motor(10, 2), 3 * SECOND);

    assertThat(watch.trouble(3 * SECOND)).contains("Motor refuses all commands, 2 in 2.0 s");
    watch.see(motor(10, 2), 5 * SECOND);
    assertThat(watch.trouble(5 * SECOND + 1)).isEmpty();
  }

  @Test
  void actuation_obeysOneCommandBetween_beginsAnew() {
    ActuationWatch watch = actuation();
    watch.see(motor(10, 0), 0);
    watch.see(motor(10, 1), SECOND);
    watch.see(motor(11, 2), 2 * SECOND);
    watch.see(motor(11, 3), 3 * SECOND);

    assertThat(watch.trouble(5 * SECOND - 1)).isEmpty();
    assertThat(watch.trouble(5 * SECOND)).isPresent();
  }

  @Test
  void actuation_serviceStartsAnew_countsFromThereOn() {
    ActuationWatch watch = actuation();
    watch.see(motor(10, 0), 0);
    watch.see(motor(10, 1), SECOND);
    watch.see(motor(10, 40).instance("second"), 2 * SECOND);

    assertThat(watch.trouble(3 * SECOND)).isEmpty();
  }

  /** Asked as soon as the Safety Manager arms, which a broker tells the watch only later. */
  @Test
  void actuation_armedWhileRefusing_countsFromArmingOn() {
    ActuationWatch watch = actuation();
    watch.see(new ArmingState().armed(false), 0);
    watch.see(motor(10, 0), 0);
    watch.see(motor(10, 1), SECOND);
    watch.see(motor(10, 2), 2 * SECOND);
    assertThat(watch.trouble(3 * SECOND)).as("not yet heard that it is armed").isEmpty();
    watch.see(new ArmingState().armed(true), 3 * SECOND);
    assertThat(watch.trouble(3 * SECOND)).isEmpty();
    watch.see(motor(10, 3), 3 * SECOND);
    watch.see(new ArmingState().armed(true), 4 * SECOND); // said once more, which changes nothing

    assertThat(watch.trouble(5 * SECOND)).contains("Motor refuses all commands, 1 in 2.0 s");
    watch.see(new ArmingState().armed(false), 5 * SECOND);
    watch.see(new ArmingState().armed(true), 5 * SECOND);
    assertThat(watch.trouble(5 * SECOND)).isEmpty();
  }

  @Test
  void actuation_serviceWithoutActuators_isNotLookedAt() {
    ActuationWatch watch = actuation();
    for (long second = 0; second < 5; second++) {
      watch.see(new HealthReport().serviceName("Planner").commandsRefused(second), second * SECOND);
    }

    assertThat(watch.trouble(4 * SECOND)).isEmpty();
  }
}
