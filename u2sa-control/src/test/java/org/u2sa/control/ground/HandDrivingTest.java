package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.Map;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.control.ControlSystem;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.ManualDrive;
import org.u2sa.messages.safety.ManualOrder;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.service.ServiceContext;

/** Ground vehicles on a mission that an operator drives by hand for a while. */
class HandDrivingTest {
  private static final double[][] CORNERS = {{60, 0}, {60, 30}};

  @TempDir private Path directory;

  private RoverDrive onItsWay(
      Function<ServiceContext, ? extends ControlSystem> control, Map<String, Object> variables) {
    return onItsWay(new KinematicRover(KinematicRover.differential(0.0), 0.0), control, variables);
  }

  private RoverDrive onItsWay(
      KinematicRover rover,
      Function<ServiceContext, ? extends ControlSystem> control,
      Map<String, Object> variables) {
    RoverDrive drive =
        new RoverDrive(
            rover,
            RoverDrive.mission(directory, 0.5, CORNERS),
            Map.of(
                "LOOK AHEAD", 1.2, "LOOK AHEAD TIME", 1.2, "AT END", "HOLD", "HOLD AT REST", true),
            control,
            variables);
    drive.until(() -> false, 5.0);
    return drive;
  }

  private RoverDrive differential() {
    return onItsWay(DifferentialPursuitControl::new, Map.of("MANUAL SPEED", 0.8));
  }

  private static ManualState order(RoverDrive drive, boolean active, String operator) {
    drive.kit.publish(
        Channels.MANUAL_ORDERS,
        new ManualOrder().requestId("m" + active).active(active).operator(operator));
    drive.until(() -> false, 0.1);
    return drive.kit.latest(Channels.MANUAL_STATE).orElseThrow();
  }

  private static void hold(RoverDrive drive, ManualDrive wanted, double forS) {
    for (double t = 0.0; t < forS; t += 0.1) {
      drive.kit.publish(Channels.MANUAL_DRIVE, (ManualDrive) wanted.copy());
      drive.until(() -> false, 0.1);
    }
  }

  private static ManualDrive by(String operator) {
    return new ManualDrive().operator(operator);
  }

  private static double speed(RoverDrive drive) {
    return drive.track.get(drive.track.size() - 1).speed();
  }

  @Test
  void drive_speedAndTurnRate_areThoseOfTheVehicle() {
    try (RoverDrive drive = differential()) {
      assertThat(order(drive, true, "Ann").active()).isTrue();
      hold(drive, by("Ann").speed(0.5).turnRate(-0.3), 4.0);
      double before = drive.rover.heading;
      hold(drive, by("Ann").speed(0.5).turnRate(-0.3), 2.0);

      assertThat(speed(drive)).isCloseTo(0.5, within(0.08));
      assertThat(drive.rover.heading - before).as("to the right").isCloseTo(0.6, within(0.1));
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.0, -1.0})
  void drive_tighterThanTheSteeringAllows_goesStraightOnceTheStickIsCentred(double side) {
    KinematicRover rover = new KinematicRover(KinematicRover.ackermann(), 0.0);
    Map<String, Object> steered =
        Map.of("WHEELBASE", 0.6, "STEERING ANGLE", 28.0, "MAX SPEED", 3.0, "MANUAL SPEED", 0.8);
    try (RoverDrive drive = onItsWay(rover, AckermannPursuitControl::new, steered)) {
      order(drive, true, "Ann");
      hold(drive, by("Ann").speed(0.3).turnRate(side * 0.785), 6.0);
      assertThat(Math.abs(rover.yawRate)).as("at full lock").isCloseTo(0.26, within(0.03));
      hold(drive, by("Ann").speed(0.5).turnRate(0.0), 1.5);
      double before = rover.heading;
      hold(drive, by("Ann").speed(0.5).turnRate(0.0), 4.0);

      assertThat(rover.heading).isCloseTo(before, within(Math.toRadians(5.0)));
    }
  }

  @Test
  void drive_sharesAndBeyondTheLimit_areThoseOfManualSpeed() {
    try (RoverDrive drive = differential()) {
      order(drive, true, "Ann");
      hold(drive, by("Ann").speedShare(-0.5), 4.0);
      assertThat(speed(drive)).isCloseTo(-0.4, within(0.08));
      hold(drive, by("Ann").speed(5.0), 4.0);
      assertThat(speed(drive)).isCloseTo(0.8, within(0.1));
    }
  }

  @Test
  void drive_fallsSilent_standsAndGoesOnWhenHeardAgain() {
    try (RoverDrive drive = differential()) {
      order(drive, true, "Ann");
      hold(drive, by("Ann").speed(0.6), 3.0);
      drive.until(() -> false, 0.45);
      assertThat(speed(drive)).as("within the dead man's time").isGreaterThan(0.5);
      drive.until(() -> false, 2.0);
      assertThat(speed(drive)).isCloseTo(0.0, within(0.02));
      hold(drive, by("Ann").speed(0.6), 3.0);
      assertThat(speed(drive)).isGreaterThan(0.5);
    }
  }

  @Test
  void drive_bySomebodyElseOrWithoutOrder_isNotObeyed() {
    try (RoverDrive drive = differential()) {
      hold(drive, by("Ann").speed(-0.6), 2.0);
      assertThat(speed(drive)).as("on its mission").isGreaterThan(0.3);
      order(drive, true, "Ann");
      hold(drive, by("Ben").speed(0.6), 3.0);
      assertThat(speed(drive)).isCloseTo(0.0, within(0.02));
      assertThat(order(drive, true, "Ben").takeovers()).isEqualTo(2);
      hold(drive, by("Ben").speed(0.6), 3.0);
      assertThat(speed(drive)).isGreaterThan(0.5);
    }
  }

  @Test
  void end_byOrder_leavesTheMissionPaused() {
    try (RoverDrive drive = differential()) {
      order(drive, true, "Ann");
      hold(drive, by("Ann").speed(0.6), 2.0);
      assertThat(order(drive, false, "Ann").active()).isFalse();
      drive.until(() -> false, 5.0);

      assertThat(drive.kit.latest(Channels.GOALS).orElseThrow().paused()).isTrue();
      assertThat(speed(drive)).isCloseTo(0.0, within(0.05));
    }
  }

  @Test
  void end_byAFailsafeOrDisarming_isAnnouncedWithItsReason() {
    try (RoverDrive drive = differential()) {
      order(drive, true, "Ann");
      drive.kit.publish(Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.HOLD));
      drive.until(() -> false, 0.1);
      ManualState ended = drive.kit.latest(Channels.MANUAL_STATE).orElseThrow();
      assertThat(ended.active()).isFalse();
      assertThat(ended.reason()).contains("failsafe HOLD");
      assertThat(order(drive, true, "Ann").reason()).contains("the failsafe HOLD is in force");

      drive.kit.publish(Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.CONTINUE));
      assertThat(order(drive, true, "Ann").active()).isTrue();
      drive.kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));
      drive.kit.publish(Channels.ARMING_STATE, new ArmingState().armed(false));
      drive.until(() -> false, 0.1);
      assertThat(drive.kit.latest(Channels.MANUAL_STATE).orElseThrow().reason())
          .contains("the vehicle was disarmed");
    }
  }

  @Test
  void swap_whileDrivenByHand_goesOnByHandOrStandsIfTheControlCannot() {
    try (RoverDrive drive = differential()) {
      order(drive, true, "Ann");
      drive.swap(DifferentialPursuitControl::new);
      hold(drive, by("Ann").speed(-0.4), 3.0);
      assertThat(speed(drive)).isLessThan(-0.3);

      drive.swap(DifferentialDriveControl::new);
      hold(drive, by("Ann").speed(-0.4), 6.0);
      assertThat(speed(drive)).as("the mission is paused").isCloseTo(0.0, within(0.1));
      assertThat(order(drive, true, "Ann").reason())
          .contains("this vehicle cannot be driven by hand");
    }
  }

  /** While no control ran, the vehicle may have been disarmed and armed again. */
  @Test
  void restart_whileDrivenByHand_standsUntilSomebodyTakesOverAgain() {
    try (RoverDrive drive = differential()) {
      order(drive, true, "Ann");
      drive.restart(DifferentialPursuitControl::new);
      hold(drive, by("Ann").speed(-0.4), 3.0);
      assertThat(speed(drive)).isCloseTo(0.0, within(0.02));
      assertThat(drive.kit.latest(Channels.MANUAL_STATE).orElseThrow().active()).isFalse();

      ManualState taken = order(drive, true, "Bob");
      assertThat(taken.active()).isTrue();
      assertThat(taken.takeovers()).isEqualTo(2);
    }
  }

  @Test
  void pauseOrEnd_whileDriving_standsWhereItHasStoppedWithoutTurning() {
    try (RoverDrive drive = differential()) {
      pause(drive);
      assertStopsWithoutTurning(drive);

      order(drive, true, "Ann");
      hold(drive, by("Ann").speed(-0.8), 3.0);
      order(drive, false, "Ann");
      assertStopsWithoutTurning(drive);
    }
  }

  private static void pause(RoverDrive drive) {
    drive.kit.publish(
        Channels.MISSION,
        new MissionOrder().requestId("p").operator("Ann").action(MissionAction.PAUSE));
  }

  private static void assertStopsWithoutTurning(RoverDrive drive) {
    double heading = drive.rover.heading;
    double fastest = Math.abs(speed(drive));
    assertThat(fastest).isGreaterThan(0.3);
    drive.until(() -> false, 3.0);
    double northM = drive.rover.north;
    double eastM = drive.rover.east;
    for (int i = 0; i < 100; i++) {
      drive.until(() -> false, 0.1);
      assertThat(drive.rover.heading).isCloseTo(heading, within(Math.toRadians(10.0)));
    }
    assertThat(Math.hypot(drive.rover.north - northM, drive.rover.east - eastM)).isLessThan(0.05);
  }

  /** The speed that was commanded when the drive ended is long out of date. */
  @Test
  void restart_longAfterADrive_standsStill() {
    try (RoverDrive drive = differential()) {
      order(drive, true, "Ann");
      hold(drive, by("Ann").speed(0.8), 3.0);
      order(drive, false, "Ann");
      drive.until(() -> false, 20.0);
      assertThat(speed(drive)).isCloseTo(0.0, within(0.02));
      drive.restart(DifferentialPursuitControl::new);
      assertStandsFor(drive, 3.0);
      drive.restart(DifferentialDriveControl::new);
      assertStandsFor(drive, 3.0);
    }
  }

  private static void assertStandsFor(RoverDrive drive, double forS) {
    double northM = drive.rover.north;
    double eastM = drive.rover.east;
    for (double t = 0.0; t < forS; t += 0.05) {
      drive.until(() -> false, 0.05);
      assertThat(drive.percent("LEFT MOTOR")).as("%.2f s after the restart", t).isZero();
      assertThat(drive.percent("RIGHT MOTOR")).as("%.2f s after the restart", t).isZero();
    }
    assertThat(Math.hypot(drive.rover.north - northM, drive.rover.east - eastM)).isLessThan(0.02);
  }

  @Test
  void order_olderThanItsExpiry_beginsNothingButEnds() {
    RoverDrive drive = differential();
    ManualOrder late = new ManualOrder().requestId("late").active(true).operator("anna");
    late.timestamp(drive.kit.clock().micros() - Clock.micros(20.0));
    drive.kit.publish(Channels.MANUAL_ORDERS, late);

    ManualState refused = drive.kit.latest(Channels.MANUAL_STATE).orElseThrow();
    assertThat(refused.active()).isFalse();
    assertThat(refused.reason().orElseThrow()).startsWith("the order arrived 20.0 s");
    assertThat(order(drive, true, "anna").active()).isTrue();
    ManualOrder end = new ManualOrder().requestId("end").active(false).operator("anna");
    end.timestamp(drive.kit.clock().micros() - Clock.micros(20.0));
    drive.kit.publish(Channels.MANUAL_ORDERS, end);
    assertThat(drive.kit.latest(Channels.MANUAL_STATE).orElseThrow().active()).isFalse();
  }

  @Test
  void end_withoutAMissionManager_standsUntilTheMissionIsPausedAndResumed() {
    try (RoverDrive drive = differential()) {
      drive.missions.kill();
      order(drive, true, "Ann");
      hold(drive, by("Ann").speed(0.6), 2.0);
      order(drive, false, "Ann");
      drive.until(() -> false, 5.0);
      assertThat(speed(drive)).as("nobody has paused").isCloseTo(0.0, within(0.02));
      drive.swap(DifferentialPursuitControl::new);
      drive.until(() -> false, 5.0);
      assertThat(speed(drive)).as("another control").isCloseTo(0.0, within(0.02));

      drive.kit.publish(Channels.GOALS, goals(drive, true));
      drive.until(() -> false, 2.0);
      drive.kit.publish(Channels.GOALS, goals(drive, false));
      drive.until(() -> false, 5.0);
      assertThat(speed(drive)).as("resumed").isGreaterThan(0.3);
    }
  }

  @Test
  void start_aMissionManagerDuringALongDrive_pausesIt() {
    try (RoverDrive drive = differential()) {
      drive.missions.kill();
      order(drive, true, "Ann");
      hold(drive, by("Ann").speed(0.3), 8.0);
      drive.startMissions();
      hold(drive, by("Ann").speed(0.3), 2.0);

      assertThat(drive.kit.latest(Channels.GOALS).orElseThrow().paused()).isTrue();
    }
  }

  /** As by a Mission Manager that forgets the drive when it is replaced. */
  @Test
  void end_pausedBeforeTheDriveAndContinuedDuringIt_stands() {
    try (RoverDrive drive = differential()) {
      drive.missions.kill();
      drive.kit.publish(Channels.GOALS, goals(drive, true));
      order(drive, true, "Ann");
      drive.kit.publish(Channels.GOALS, goals(drive, false));
      hold(drive, by("Ann").speed(0.6), 2.0);
      order(drive, false, "Ann");
      drive.until(() -> false, 5.0);

      assertThat(speed(drive)).isCloseTo(0.0, within(0.02));
    }
  }

  @Test
  void end_goalsOfAServiceThatDoesNotPause_standsUntilItSendsThemAgain() {
    try (RoverDrive drive = differential()) {
      drive.missions.kill();
      order(drive, true, "Ann");
      order(drive, false, "Ann");
      drive.until(() -> false, 5.0);
      drive.kit.publish(Channels.GOALS, drive.kit.latest(Channels.GOALS).orElseThrow());
      drive.until(() -> false, 5.0);
      assertThat(speed(drive)).as("retained ones arrive again").isCloseTo(0.0, within(0.02));

      drive.kit.publish(Channels.GOALS, goals(drive, false));
      drive.until(() -> false, 5.0);
      assertThat(speed(drive)).isGreaterThan(0.3);
    }
  }

  private static GoalList goals(RoverDrive drive, boolean paused) {
    return new GoalList()
        .goals(drive.kit.latest(Channels.GOALS).orElseThrow().goals())
        .paused(paused);
  }

  /** At QoS 1 an order may arrive twice. */
  @Test
  void order_arrivesAgainAfterTheEndOrASwap_doesNotTakeOverAgain() {
    try (RoverDrive drive = differential()) {
      ManualOrder begin = new ManualOrder().requestId("M1").active(true).operator("Ann");
      drive.kit.publish(Channels.MANUAL_ORDERS, begin);
      order(drive, false, "Ann");
      drive.kit.publish(Channels.MANUAL_ORDERS, (ManualOrder) begin.copy());
      ManualState repeated = drive.kit.latest(Channels.MANUAL_STATE).orElseThrow();
      assertThat(repeated.active()).isFalse();
      assertThat(repeated.takeovers()).isEqualTo(1);

      drive.swap(DifferentialPursuitControl::new);
      drive.kit.publish(Channels.MANUAL_ORDERS, (ManualOrder) begin.copy());
      assertThat(drive.kit.latest(Channels.MANUAL_STATE).orElseThrow().active()).isFalse();
      drive.until(() -> false, 0.1);
      ManualOrder again = new ManualOrder().requestId("M1").active(true).operator("Ann");
      drive.kit.publish(Channels.MANUAL_ORDERS, again);
      assertThat(drive.kit.latest(Channels.MANUAL_STATE).orElseThrow().active()).isTrue();
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0, -60.0, 60.0})
  void drive_heldUpForLongerThanOrderExpiry_movesNothingWhateverTheOperatorsClock(double aheadS) {
    RoverDrive drive = differential();
    order(drive, true, "anna");
    drive(drive, 0.0, aheadS, 0.5);
    assertThat(drive.rover.speed).isGreaterThan(0.3);
    drive.until(() -> false, 2.0);

    drive(drive, 20.0, aheadS, 0.5);
    assertThat(drive.rover.speed).isCloseTo(0.0, within(0.01));
    drive(drive, 0.0, aheadS, 0.5);
    assertThat(drive.rover.speed).isGreaterThan(0.3);
  }

  private static void drive(RoverDrive drive, double lateS, double aheadS, double mps) {
    for (int i = 0; i < 20; i++) {
      ManualDrive wanted = by("anna").speed(mps);
      wanted.timestamp(drive.kit.clock().micros() + Clock.micros(aheadS - lateS));
      drive.kit.publish(Channels.MANUAL_DRIVE, wanted);
      drive.until(() -> false, 0.1);
    }
  }
}
