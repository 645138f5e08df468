package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.testkit.ServiceKit;

class CessnaControlTest {
  private static final double STEP_S = 0.05;

  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  @Test
  void tuning_ofTheShippedFile_isThatOfTheDeclaredDefaults() {
    AutopilotVariables declared =
        AutopilotVariables.in(XmlConfiguration.inMemory("none", Map.of())).get();
    assertThat(TestTuning.standard().toString()).isEqualTo(declared.toString());
  }

  @Test
  void refuseUndeclared_shippedFile_passes() {
    XmlConfiguration file = XmlConfiguration.load(TestTuning.FILE);
    AutopilotVariables.in(file);
    file.getVariable(
        org.u2sa.interfaces.configuration.VariableDeclaration.number("STALE AFTER", "s"));
    file.getVariable(
        org.u2sa.interfaces.configuration.VariableDeclaration.number("COMMAND EXPIRY", "s"));
    file.getVariable(
        org.u2sa.interfaces.configuration.VariableDeclaration.number("POWER EXPIRY", "s"));
    file.getVariable(
        org.u2sa.interfaces.configuration.VariableDeclaration.number("BLEND TIME", "s"));
    file.refuseUndeclared();
  }

  @Test
  void callback_stateInFlight_commandsAllEightActuatorsWithExpiry() {
    kit.start(CessnaControl::new);
    fly(flying(), Point.of(300.0, 0.0, 0.0), 1);
    List<ActuatorCommand> commands = kit.published(Channels.ACTUATION);
    assertThat(commands)
        .extracting(ActuatorCommand::actuatorName)
        .containsExactly(
            "AILERON",
            "ELEVATOR",
            "RUDDER",
            "THROTTLE",
            "MIXTURE",
            "FLAPS",
            "LEFT BRAKE",
            "RIGHT BRAKE");
    List<String> power =
        List.of("THROTTLE", "MIXTURE", "FLAPS"); // a short silence is no reason to idle
    assertThat(commands)
        .allSatisfy(
            c -> assertThat(c.expiry()).hasValue(power.contains(c.actuatorName()) ? 10.0 : 0.5));
  }

  @Test
  void callback_aileronsWithdrawn_rollsByTheRudderAndSaysSo() {
    kit.start(CessnaControl::new);
    fly(flying(), Point.of(200.0, -200.0, 0.0), 20);
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement()
            .actuatorName("AILERON")
            .minimum(-100.0)
            .maximum(100.0)
            .available(0.0));
    fly(flying(), Point.of(200.0, -200.0, 0.0), 20);

    assertThat(kit.percent("AILERON")).isZero();
    assertThat(kit.percent("RUDDER")).isGreaterThan(5.0);
    assertThat(kit.log("Control"))
        .anySatisfy(line -> assertThat(line).contains("ailerons lost: rolling slowly, by rudder"));
  }

  @Test
  void callback_pilotHasTakenOver_commandsNothingUntilGivenBackAndSaysSo() {
    kit.start(CessnaControl::new);
    fly(flying(), Point.of(300.0, 0.0, 0.0), 5);
    double throttle = kit.percent("THROTTLE");
    kit.publish(
        Channels.MANUAL_STATE, new ManualState().active(true).operator("pilot").takeovers(1));
    kit.forget();
    fly(flying(), Point.of(300.0, 0.0, 0.0), 5);
    assertThat(kit.published(Channels.ACTUATION)).isEmpty();
    kit.publish(
        Channels.MANUAL_ORDERS, new ManualOrder().active(true).operator("ann").requestId("q"));
    ManualState answer = kit.latest(Channels.MANUAL_STATE).orElseThrow();
    assertThat(answer.active()).isTrue();
    assertThat(answer.takeovers()).isEqualTo(1);
    assertThat(answer.reason().orElseThrow()).contains("cannot be driven by hand");
    kit.publish(
        Channels.MANUAL_STATE, new ManualState().active(false).operator("pilot").takeovers(1));
    fly(flying(), Point.of(300.0, 0.0, 0.0), 1);

    assertThat(kit.percent("THROTTLE")).isCloseTo(throttle, within(5.0));
  }

  /** A radio service that has ended says nothing about who flies. */
  @Test
  void callback_pilotsServiceFallsSilent_commandsAgainAfterTwoSeconds() {
    kit.start(CessnaControl::new);
    fly(flying(), Point.of(300.0, 0.0, 0.0), 5);
    kit.publish(
        Channels.MANUAL_STATE, new ManualState().active(true).operator("pilot").takeovers(1));
    kit.forget();
    fly(flying(), Point.of(300.0, 0.0, 0.0), (int) Math.floor(2.0 / STEP_S));
    assertThat(kit.published(Channels.ACTUATION)).isEmpty();
    fly(flying(), Point.of(300.0, 0.0, 0.0), 2);

    assertThat(kit.published(Channels.ACTUATION)).isNotEmpty();
    assertThat(kit.log("Control")).anyMatch(line -> line.contains("flies: in control"));
    ManualState ended = kit.latest(Channels.MANUAL_STATE).orElseThrow();
    assertThat(ended.active()).isFalse();
    assertThat(ended.takeovers()).isEqualTo(1);
    assertThat(ended.reason()).contains("no service reports any longer that \"pilot\" flies");
  }

  @Test
  void callback_pointToTheRight_rollsRight() {
    kit.start(CessnaControl::new);
    fly(flying(), Point.of(200.0, -200.0, 0.0), 20); // BODY: y is to the left
    assertThat(kit.percent("AILERON")).isGreaterThan(5.0);
  }

  @Test
  void callback_pointToTheLeft_rollsLeft() {
    kit.start(CessnaControl::new);
    fly(flying(), Point.of(200.0, 200.0, 0.0), 20);
    assertThat(kit.percent("AILERON")).isLessThan(-5.0);
  }

  @Test
  void callback_pointAbove_raisesNoseAndOpensThrottle() {
    kit.start(CessnaControl::new);
    fly(flying(), Point.of(300.0, 0.0, 0.0), 1);
    double throttle = kit.percent("THROTTLE");
    fly(flying(), Point.of(300.0, 0.0, -80.0), 40); // BODY: z is down
    assertThat(kit.percent("ELEVATOR")).isLessThan(-1.0);
    assertThat(kit.percent("THROTTLE")).isGreaterThan(throttle + 5.0);
  }

  @Test
  void callback_navigationGoesStaleInABank_levelsWingsAndHolds() {
    kit.start(CessnaControl::new);
    fly(flying(), Point.of(200.0, -200.0, 0.0), 2);
    AircraftState banked = flying();
    banked.phi(Math.toRadians(20.0));
    for (int i = 0; i < 40; i++) {
      state(banked);
    }
    assertThat(kit.latest(ControlStatus.CHANNEL).orElseThrow().phase()).isEqualTo(FlightPhase.HOLD);
    assertThat(kit.latest(ControlStatus.CHANNEL).orElseThrow().navigating()).isFalse();
    assertThat(kit.percent("AILERON")).isLessThan(-5.0);
    assertThat(kit.log("Control")).anyMatch(line -> line.contains("HOLD, no navigation"));
  }

  @Test
  void callback_onTheRunwayWithoutNavigation_standsOnTheBrakesIdling() {
    kit.start(CessnaControl::new);
    for (int i = 0; i < 100; i++) {
      state(standing());
    }
    assertThat(kit.percent("LEFT BRAKE")).isEqualTo(100.0);
    assertThat(kit.percent("RIGHT BRAKE")).isEqualTo(100.0);
    assertThat(kit.percent("THROTTLE")).isZero();
  }

  @Test
  void callback_onTheRunwayWithNavigation_opensThrottleThenReleasesBrakes() {
    kit.start(CessnaControl::new);
    fly(standing(), Point.of(300.0, 0.0, -100.0), 40);
    assertThat(kit.latest(ControlStatus.CHANNEL).orElseThrow().phase())
        .isEqualTo(FlightPhase.RUN_UP);
    assertThat(kit.percent("LEFT BRAKE")).isEqualTo(100.0);
    fly(standing(), Point.of(300.0, 0.0, -100.0), 100);
    assertThat(kit.latest(ControlStatus.CHANNEL).orElseThrow().phase()).isEqualTo(FlightPhase.ROLL);
    assertThat(kit.percent("LEFT BRAKE")).isZero();
    assertThat(kit.percent("THROTTLE")).isEqualTo(100.0);
  }

  @Test
  void callback_disarmed_keepsTheThrottleClosedAtRestOnly() {
    kit.start(CessnaControl::new);
    AircraftState onTheCatapult = standing();
    onTheCatapult.heightAboveGround(300.0).weightOnWheels(false); // as without sensors of height
    fly(onTheCatapult, Point.of(300.0, 0.0, -40.0), 15);
    assertThat(kit.percent("THROTTLE")).as("within READY TIME").isZero();

    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(false));
    fly(onTheCatapult, Point.of(300.0, 0.0, -40.0), 40);
    assertThat(kit.percent("THROTTLE")).isZero();

    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));
    fly(onTheCatapult, Point.of(300.0, 0.0, -40.0), 2);
    assertThat(kit.percent("THROTTLE")).isGreaterThan(20.0);

    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(false));
    fly(flying(), Point.of(300.0, 0.0, 0.0), 2);
    assertThat(kit.percent("THROTTLE")).as("in flight").isGreaterThan(20.0);
  }

  @Test
  void callback_onTheCatapultWithoutNavigation_keepsTheThrottleClosed() {
    kit.start(CessnaControl::new);
    AircraftState onTheCatapult = standing();
    onTheCatapult.heightAboveGround(300.0).weightOnWheels(false); // as without sensors of height
    for (int i = 0; i < 60; i++) {
      state(onTheCatapult);
      assertThat(kit.percent("THROTTLE")).isZero();
    }
    fly(onTheCatapult, Point.of(300.0, 0.0, -40.0), 3);
    assertThat(kit.percent("THROTTLE")).isGreaterThan(20.0);
  }

  @Test
  void callback_standsInTheAirAgainstTheWindWithoutNavigation_fliesOn() {
    kit.start(CessnaControl::new);
    AircraftState againstTheWind = flying();
    againstTheWind.xDot(0.5);
    for (int i = 0; i < 60; i++) {
      state(againstTheWind);
    }
    assertThat(kit.percent("THROTTLE")).isGreaterThan(20.0);
  }

  @Test
  void callback_pointWithSpeed0WhileItRuns_brakesAtOnce() {
    kit.start(CessnaControl::new);
    fly(standing(), Point.of(300.0, 0.0, -100.0), 150);
    assertThat(kit.percent("THROTTLE")).isEqualTo(100.0);

    NavigationPoint stay = NavigationPoint.at(Point.of(1.0, 0.0, 0.0)).speed(0.0);
    stay.timestamp(kit.clock().micros());
    kit.publish(Channels.NAVIGATION, stay);
    state(standing());
    assertThat(kit.latest(ControlStatus.CHANNEL).orElseThrow().phase())
        .isEqualTo(FlightPhase.STOPPED);
    assertThat(kit.percent("LEFT BRAKE")).isPositive();
  }

  @Test
  void takeOver_restartedOrSwappedTwiceInFlight_flaresOverTheGroundItTookOffFrom() {
    CessnaControl first = kit.with("GROUND", "START").start(CessnaControl::new);
    fly(sensed(standing()), Point.of(300.0, 0.0, -100.0), 40);
    fly(sensed(flying()), Point.of(300.0, 0.0, 0.0), 40);
    CessnaControl restarted = kit.restart(first, CessnaControl::new);
    assertThat(flareBegins()).isTrue();

    fly(sensed(flying()), Point.of(300.0, 0.0, 0.0), 40);
    ThesisControl between = kit.withoutVariables().swap(restarted, ThesisControl::new);
    kit.with("GROUND", "START").swap(between, CessnaControl::new);
    fly(sensed(flying()), Point.of(300.0, 0.0, 0.0), 2);
    assertThat(flareBegins()).isTrue();
  }

  @Test
  void callback_landingWithoutHeight_isRefusedWhenItBegins() {
    kit.start(CessnaControl::new);
    land(sensed(flying()));

    GoalInformation report = kit.latest(Channels.GOAL_REPORTS).orElseThrow();
    assertThat(report.uid()).isEqualTo("L");
    assertThat(report.abandoned()).isTrue();
    assertThat(report.reason().orElseThrow()).contains("no height above ground, and GROUND is not");
  }

  @Test
  void callback_landingWithHeight_isFlown() {
    kit.start(CessnaControl::new);
    land(flying());
    fly(sensed(flying()), Point.of(300.0, 0.0, 0.0), 80); // the sensor falls silent

    assertThat(kit.published(Channels.GOAL_REPORTS)).isEmpty();
  }

  private void land(StateInformation state) {
    Landing landing = new Landing();
    landing.horizontalThreshold(1.0).x(0.0).y(0.0).z(0.0).uid("L");
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(landing)));
    fly(state, Point.of(300.0, 0.0, 0.0), 80);
  }

  @Test
  void callback_startedInFlightWithoutHeight_saysThatItCannotLand() {
    kit.with("GROUND", "START").start(CessnaControl::new);
    fly(sensed(flying()), Point.of(300.0, 0.0, 0.0), 2);

    assertThat(kit.log("Control"))
        .filteredOn(line -> line.contains("the altitude of the ground is unknown"))
        .hasSize(1);
  }

  private boolean flareBegins() {
    StateInformation low = sensed(flying()).z(6.0);
    fly(low, Point.of(60.0, 0.0, 3.0), 40);
    return kit.latest(ControlStatus.CHANNEL).orElseThrow().phase() == FlightPhase.FLARE;
  }

  /** What an aircraft without sensors of height and weight on wheels knows. */
  private static StateInformation sensed(AircraftState state) {
    StateInformation sensed = new StateInformation();
    for (StateField field : StateField.values()) {
      state.number(field).ifPresent(value -> sensed.number(field, value));
    }
    return sensed;
  }

  @Test
  void callback_stateLacksAttitude_saysSoAndCommandsNothing() {
    kit.start(CessnaControl::new);
    state(new StateInformation().x(0.0).y(0.0).z(0.0));
    state(new StateInformation().x(0.0).y(0.0).z(0.0));
    assertThat(kit.published(Channels.ACTUATION)).isEmpty();
    assertThat(kit.log("Control")).filteredOn(line -> line.contains("state lacks")).hasSize(1);
  }

  @Test
  void kill_inFlight_leavesActuatorsNeutral() {
    CessnaControl control = kit.start(CessnaControl::new);
    fly(flying(), Point.of(200.0, -200.0, 0.0), 20);
    control.kill();
    assertThat(kit.percent("AILERON")).isZero();
    assertThat(kit.percent("ELEVATOR")).isEqualTo(AircraftActuator.TRIMMED_ELEVATOR_PERCENT);
    assertThat(kit.percent("THROTTLE")).isZero();
    assertThat(kit.percent("MIXTURE")).isEqualTo(100.0);
  }

  private void set(String variable, String value) {
    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange().serviceName("Control").variableName(variable).value(value));
  }

  private double bankDemandDeg() {
    return Math.toDegrees(kit.latest(ControlStatus.CHANNEL).orElseThrow().bank().orElseThrow());
  }

  @Test
  void configurationChange_ofTheBankLimitInATurn_fliesOnWithIt() {
    kit.start(CessnaControl::new);
    fly(flying(), Point.of(200.0, -200.0, 0.0), 100);
    assertThat(bankDemandDeg()).isGreaterThan(20.0);
    double throttle = kit.percent("THROTTLE");

    set("BANK LIMIT", "12");
    fly(flying(), Point.of(200.0, -200.0, 0.0), 1);
    assertThat(kit.percent("THROTTLE")).as("goes on").isCloseTo(throttle, within(2.0));
    fly(flying(), Point.of(200.0, -200.0, 0.0), 100);

    assertThat(bankDemandDeg()).isCloseTo(12.0, within(0.1));
    assertThat(kit.latest(ControlStatus.CHANNEL).orElseThrow().phase())
        .isEqualTo(FlightPhase.CRUISE);
  }

  @Test
  void configurationChange_toSpeedsThatDoNotGoTogether_isRefused() {
    CessnaControl control = kit.start(CessnaControl::new);

    set("STALL MARGIN", "2");
    assertThat(control.getVariable("STALL MARGIN")).isEqualTo(1.2);
    assertThat(kit.log("Control"))
        .anyMatch(
            line ->
                line.contains(
                    "STALL SPEED times STALL MARGIN is 52.4 m/s, expected less than CRUISE SPEED 40.0"));

    set("MAX SPEED", "35");
    assertThat(kit.log("Control"))
        .anyMatch(line -> line.contains("CRUISE SPEED 40.0 m/s is above MAX SPEED 35.0 m/s"));
  }

  private void fly(StateInformation state, Point point, int steps) {
    for (int i = 0; i < steps; i++) {
      state(state);
      NavigationPoint navigation = NavigationPoint.at(point);
      navigation.timestamp(kit.clock().micros());
      kit.publish(Channels.NAVIGATION, navigation);
    }
  }

  private void state(StateInformation state) {
    kit.advance(STEP_S);
    kit.publish(Channels.STATE, state.copy());
  }

  /** Level at 40 m/s eastwards, 300 m up. */
  private static AircraftState flying() {
    AircraftState state = new AircraftState();
    state.x(-157.9).y(21.3).z(300.0).xDot(40.0).yDot(0.0).zDot(0.0);
    state.phi(0.0).theta(0.05).psi(Math.PI / 2).phiDot(0.0).thetaDot(0.0).psiDot(0.0);
    state.fluidxDot(40.0).fluidyDot(0.0).fluidzDot(2.15);
    return state.heightAboveGround(295.0).calibratedAirspeed(39.5).engineRpm(2300.0);
  }

  private static AircraftState standing() {
    AircraftState state = new AircraftState();
    state.x(-157.9).y(21.3).z(5.0).xDot(0.0).yDot(0.0).zDot(0.0);
    state.phi(0.0).theta(0.05).psi(Math.PI / 2).phiDot(0.0).thetaDot(0.0).psiDot(0.0);
    state.fluidxDot(0.0).fluidyDot(0.0).fluidzDot(0.0);
    return state
        .heightAboveGround(0.0)
        .calibratedAirspeed(0.0)
        .engineRpm(700.0)
        .weightOnWheels(true);
  }
}
