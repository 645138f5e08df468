package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.testkit.ServiceKit;

class AllocatingControlTest {
  private static final double STEP_S = 0.1;

  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  /** Heads into a current of its own speed, and is turned by 0.05 rad/s. */
  @Test
  void control_holdsStationInACurrent_rudderCountsBySpeedThroughTheWater() {
    kit.with("YAW WEIGHT", 1.0).with("YAW INERTIA", 100.0).with("YAW INTEGRAL TIME", 0.0);
    kit.start(AllocatingControl::new);
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement()
            .actuatorName("RUDDER")
            .minimum(-100.0)
            .maximum(100.0)
            .moment(Point.of(0.0, 0.0, 100.0))
            .referenceSpeed(2.0));
    kit.publish(
        Channels.STATE,
        new StateInformation()
            .x(9.0)
            .y(54.0)
            .z(0.0)
            .xDot(0.0)
            .yDot(0.0)
            .psi(0.0)
            .psiDot(0.05)
            .fluidxDot(2.0));

    assertThat(kit.percent("RUDDER")).isBetween(-11.0, -9.0); // 100 kg m² times 2 1/s times 0.05
  }

  private AllocatingControl startMultirotor() {
    kit.with("LEANS", true).with("HEAVE WEIGHT", 1.0).with("HEAVE MASS", 1.0);
    AllocatingControl control = kit.start(AllocatingControl::new);
    announceRotor();
    return control;
  }

  private void announceRotor() {
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement()
            .actuatorName("ROTOR")
            .minimum(0.0)
            .maximum(100.0)
            .force(Point.of(0.0, 0.0, -20.0)));
  }

  /** A multirotor would lean as if it were level, and overturn. */
  @Test
  void control_multirotorWithoutRollAndPitch_doesNotLift() {
    startMultirotor();
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));
    kit.publish(Channels.STATE, falling().phi(0.0).theta(0.0));
    assertThat(kit.percent("ROTOR")).isPositive();

    kit.advance(0.1);
    kit.publish(Channels.STATE, falling());
    assertThat(kit.percent("ROTOR")).isZero();
  }

  /** The first arming state of a Safety Manager comes half a second after the first state. */
  @Test
  void control_multirotorBeforeArmingIsKnown_doesNotLift() {
    startMultirotor();
    for (int i = 0; i < 9; i++) {
      kit.publish(Channels.STATE, falling().phi(0.0).theta(0.0));
      assertThat(kit.percent("ROTOR")).isZero();
      kit.advance(0.1);
    }

    kit.advance(0.2); // nobody arms vehicles here
    kit.publish(Channels.STATE, falling().phi(0.0).theta(0.0));
    assertThat(kit.percent("ROTOR")).isPositive();
  }

  @Test
  void takeOver_multirotorRestartedInFlightAndOnTheGround_hoversAtOnceOrStands() {
    AllocatingControl control = startMultirotor();
    StateInformation hovers = falling().zDot(0.0).phi(0.0).theta(0.0);
    kit.publish(Channels.STATE, hovers.copy());
    kit.advance(1.1);
    kit.publish(Channels.STATE, hovers.copy());
    control = kit.restart(control, AllocatingControl::new);
    announceRotor();
    kit.advance(1.1);
    kit.publish(Channels.STATE, hovers.copy());
    kit.advance(1.1);
    kit.publish(Channels.STATE, hovers.copy());
    assertThat(kit.percent("ROTOR")).as("on the ground").isZero();

    kit.advance(0.1);
    kit.publish(Channels.STATE, falling().phi(0.0).theta(0.0));
    assertThat(kit.percent("ROTOR")).isPositive();
    kit.advance(30.0);
    kit.restart(control, AllocatingControl::new);
    announceRotor();
    kit.publish(Channels.STATE, hovers.copy());
    assertThat(kit.percent("ROTOR")).isPositive();
  }

  @Test
  void takeOver_multirotorRestartedAfterItWasDisarmed_stands() {
    AllocatingControl control = startMultirotor();
    arm(true);
    kit.publish(Channels.STATE, falling().phi(0.0).theta(0.0)); // flies
    kit.advance(1.0);
    arm(false);
    kit.publish(Channels.STATE, falling().zDot(0.0).phi(0.0).theta(0.0));
    kit.advance(30.0);
    arm(true);
    kit.restart(control, AllocatingControl::new);
    announceRotor();
    kit.publish(Channels.STATE, falling().zDot(0.0).phi(0.0).theta(0.0));

    assertThat(kit.percent("ROTOR")).isZero();
  }

  /** Without navigation points it would drive off, against an error of its speed. */
  @Test
  void control_speedTooUncertainAndNoPoints_isNotBraked() {
    kit.with("SURGE WEIGHT", 1.0).with("SURGE MASS", 1.0).with("SURGE MAX SPEED", 2.0);
    kit.start(AllocatingControl::new);
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement()
            .actuatorName("THRUSTER")
            .minimum(-100.0)
            .maximum(100.0)
            .force(Point.of(10.0, 0.0, 0.0)));
    for (int i = 0; i < 50; i++) { // its integral grows
      kit.publish(Channels.STATE, drifting(0.2));
      kit.advance(0.1);
    }
    assertThat(kit.percent("THRUSTER")).isNegative();

    kit.publish(Channels.STATE, drifting(4.0));
    assertThat(kit.percent("THRUSTER")).isZero();
  }

  private void startBoat() {
    kit.with("SURGE WEIGHT", 1.0).with("SURGE MASS", 40.0).with("FACES THE WAY", true);
    kit.with("YAW WEIGHT", 3.0).with("YAW INERTIA", 8.0);
    kit.start(AllocatingControl::new);
    kit.publish(Channels.ACTUATORS, thruster("PORT", Point.of(20.0, 0.0, 0.0), 8.0));
  }

  private static ActuatorAnnouncement thruster(String name, Point forceN, double momentNm) {
    return new ActuatorAnnouncement()
        .actuatorName(name)
        .minimum(-100.0)
        .maximum(100.0)
        .force(forceN)
        .moment(Point.of(0.0, 0.0, momentNm));
  }

  /** The boat is to turn to a point on its right, slowly. */
  private void sail(double surgeMps, ActuatorAnnouncement... announced) {
    for (int i = 0; i < 30; i++) {
      for (ActuatorAnnouncement each : announced) {
        kit.publish(Channels.ACTUATORS, (ActuatorAnnouncement) each.copy());
      }
      NavigationPoint point = NavigationPoint.at(Point.of(4.0, -4.0, 0.0)).speed(0.3);
      point.timestamp(kit.clock().micros());
      kit.send(Channels.NAVIGATION, point);
      kit.publish(Channels.STATE, falling().zDot(0.0).xDot(0.0).yDot(surgeMps));
      kit.advance(STEP_S);
    }
  }

  /** The other thruster of two would only drive it in circles, possibly faster than wanted. */
  @Test
  void control_boatThatCannotDriveWithoutTurning_isLeftAdrift() {
    startBoat();
    ActuatorAnnouncement starboard = thruster("STARBOARD", Point.of(20.0, 0.0, 0.0), -8.0);
    sail(0.2, starboard, thruster("PORT", Point.of(20.0, 0.0, 0.0), 8.0));
    assertThat(kit.percent("STARBOARD")).isNotZero();

    sail(0.2, starboard, thruster("PORT", Point.of(20.0, 0.0, 0.0), 8.0).available(0.0));
    assertThat(kit.percent("STARBOARD")).isZero();
    assertThat(kit.log("Control"))
        .anyMatch(line -> line.contains("cannot control surge, yaw; horizontal thrust is off"));
  }

  /** Its bow thruster balances the thruster that is left, and pushes it aside. */
  @Test
  void control_boatThatStillDrivesButDriftsAside_isNotMadeFasterThanWanted() {
    kit.with("SWAY WEIGHT", 1.0).with("SWAY MASS", 80.0);
    startBoat();
    ActuatorAnnouncement port = thruster("PORT", Point.of(20.0, 0.0, 0.0), 8.0);
    ActuatorAnnouncement bow = thruster("BOW", Point.of(0.0, 20.0, 0.0), 10.0);
    sail(0.1, port, bow, thruster("STARBOARD", Point.of(20.0, 0.0, 0.0), -8.0).available(0.0));
    assertThat(kit.percent("PORT")).as("drives on").isPositive();

    sail(0.6, port, bow);
    assertThat(kit.percent("PORT")).isNotPositive();
  }

  /** At the end of the points, the share of its thrust against drag would drive it on. */
  @Test
  void control_pointsEnd_brakesAtOnce() {
    startThruster(1.0);
    for (int i = 0; i < 50; i++) { // slower than wanted: its integral grows
      underWay(0.5, 0.1);
    }
    assertThat(kit.percent("THRUSTER")).isGreaterThan(10.0);

    kit.advance(2.0);
    kit.publish(Channels.STATE, eastwards(0.5, 0.1));
    assertThat(kit.percent("THRUSTER")).isCloseTo(-5.0, within(0.1)); // 1 kg times 1/s times 0.5
  }

  /** Where something stands on its way, it is told to go no further. */
  @Test
  void control_speedOfZeroOnItsWay_brakesAtOnce() {
    startThruster(1.0);
    for (int i = 0; i < 50; i++) { // slower than wanted: its integral grows
      underWay(0.5, 0.1);
    }

    kit.publish(Channels.NAVIGATION, at(NavigationPoint.at(Point.ORIGIN).speed(0.0)));
    kit.publish(Channels.STATE, eastwards(0.5, 0.1));
    kit.advance(0.1);
    assertThat(kit.percent("THRUSTER")).isCloseTo(-5.0, within(0.1)); // 1 kg times 1/s times 0.5
  }

  /** Against an error of its speed it would drive off, and a submarine tumble. */
  @Test
  void control_speedUnknownOnItsWay_coasts() {
    startThruster(2.0);
    underWay(0.5, 0.2);
    assertThat(kit.percent("THRUSTER")).isPositive();

    underWay(0.5, 1.6);
    assertThat(kit.percent("THRUSTER")).isZero();
  }

  /** Level to a point far ahead at the same depth, with its nose up. */
  @Test
  void control_pitchedVehicleToAPointAtItsDepth_doesNotDive() {
    startThruster(0.4);
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement()
            .actuatorName("VERTICAL")
            .minimum(-100.0)
            .maximum(100.0)
            .force(Point.of(0.0, 0.0, 10.0)));
    double pitch = Math.toRadians(20.0);
    kit.publish(Channels.STATE, eastwards(0.0, 0.01).theta(pitch).phi(0.0));
    kit.publish(
        Channels.NAVIGATION,
        at(NavigationPoint.at(Point.of(20.0 * Math.cos(pitch), 0.0, 20.0 * Math.sin(pitch)))));
    kit.advance(0.1);
    kit.publish(Channels.STATE, eastwards(0.0, 0.01).theta(pitch).phi(0.0));

    double down =
        kit.percent("VERTICAL") * Math.cos(pitch) - kit.percent("THRUSTER") * Math.sin(pitch);
    assertThat(kit.percent("THRUSTER")).isGreaterThan(3.0);
    assertThat(down).isCloseTo(0.0, within(0.1));
  }

  private void startThruster(double maxSpeedMps) {
    kit.with("SURGE WEIGHT", 1.0).with("SURGE MASS", 1.0).with("SURGE MAX SPEED", maxSpeedMps);
    kit.with("HEAVE WEIGHT", 1.0).with("HEAVE MASS", 1.0);
    kit.start(AllocatingControl::new);
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement()
            .actuatorName("THRUSTER")
            .minimum(-100.0)
            .maximum(100.0)
            .force(Point.of(10.0, 0.0, 0.0)));
  }

  /** A state, a point far ahead for it, and the next state. */
  private void underWay(double speedMps, double sigmaMps) {
    kit.publish(Channels.STATE, eastwards(speedMps, sigmaMps));
    kit.publish(Channels.NAVIGATION, at(NavigationPoint.at(Point.of(20.0, 0.0, 0.0)).speed(1.0)));
    kit.advance(0.1);
    kit.publish(Channels.STATE, eastwards(speedMps, sigmaMps));
    kit.advance(0.1);
  }

  private NavigationPoint at(NavigationPoint point) {
    point.timestamp(kit.clock().micros());
    return point;
  }

  private static StateInformation eastwards(double speedMps, double sigmaMps) {
    return new StateInformation()
        .x(9.0)
        .y(54.0)
        .z(0.0)
        .xDot(speedMps)
        .yDot(0.0)
        .zDot(0.0)
        .psi(Math.PI / 2.0)
        .xDotSigma(sigmaMps)
        .yDotSigma(sigmaMps);
  }

  private static StateInformation drifting(double sigmaMps) {
    return new StateInformation()
        .xDot(0.0)
        .yDot(1.0)
        .psi(0.0)
        .xDotSigma(sigmaMps)
        .yDotSigma(sigmaMps);
  }

  private static StateInformation falling() {
    return new StateInformation().x(9.0).y(54.0).z(10.0).xDot(0.0).yDot(0.0).zDot(-5.0).psi(0.0);
  }

  /** A slow thruster that turns the vehicle: 50 %/s. */
  private AllocatingControl startSlowThruster() {
    kit.with("YAW WEIGHT", 1.0).with("YAW INERTIA", 100.0).with("YAW INTEGRAL TIME", 0.0);
    AllocatingControl control = kit.start(AllocatingControl::new);
    announceSlowThruster();
    return control;
  }

  private void announceSlowThruster() {
    kit.publish(Channels.ACTUATORS, slowThruster());
  }

  private static ActuatorAnnouncement slowThruster() {
    return new ActuatorAnnouncement()
        .actuatorName("THRUSTER")
        .minimum(-100.0)
        .maximum(100.0)
        .moment(Point.of(0.0, 0.0, 100.0))
        .rateLimit(50.0);
  }

  /** The vehicle lies on its heading and is turned from outside. */
  private void turned(double rateRadPerS, int steps) {
    for (int i = 0; i < steps; i++) {
      kit.advance(STEP_S);
      kit.publish(
          Channels.STATE,
          new StateInformation()
              .x(9.0)
              .y(54.0)
              .z(0.0)
              .xDot(0.0)
              .yDot(0.0)
              .psi(0.0)
              .psiDot(rateRadPerS));
    }
  }

  @Test
  void control_withheldByARadio_restsLikeADisarmedOne() {
    startSlowThruster();
    turned(1.0, 30);
    assertThat(kit.percent("THRUSTER")).isEqualTo(-100.0);

    kit.publish(Channels.ACTUATORS, slowThruster().withheld(true));
    turned(1.0, 1);
    assertThat(kit.percent("THRUSTER")).isZero();
  }

  @Test
  void control_pointAbeamOfAVehicleThatCannotSway_turnsTowardsIt() {
    startSlowThruster();
    turned(0.0, 1);
    kit.publish(Channels.NAVIGATION, at(NavigationPoint.at(Point.of(0.0, 10.0, 0.0)))); // left
    turned(0.0, 3);
    double left = kit.percent("THRUSTER");
    kit.publish(Channels.NAVIGATION, at(NavigationPoint.at(Point.of(0.0, -10.0, 0.0))));
    turned(0.0, 6);

    assertThat(left).isNotZero();
    assertThat(kit.percent("THRUSTER") * left).isNegative();
  }

  /** Percentage of the propeller towards a point behind. */
  private double propellerTowardsAPointBehind(double rudderReferenceMps) {
    kit.with("YAW WEIGHT", 1.0).with("YAW INERTIA", 1.0);
    startThruster(1.0);
    ActuatorAnnouncement rudder =
        new ActuatorAnnouncement()
            .actuatorName("RUDDER")
            .minimum(-100.0)
            .maximum(100.0)
            .moment(Point.of(0.0, 0.0, 10.0));
    kit.publish(
        Channels.ACTUATORS,
        rudderReferenceMps > 0.0 ? rudder.referenceSpeed(rudderReferenceMps) : rudder);
    for (int i = 0; i < 3; i++) {
      kit.publish(Channels.STATE, eastwards(0.0, 0.01));
      kit.publish(Channels.NAVIGATION, at(NavigationPoint.at(Point.of(-20.0, 1.0, 0.0))));
      kit.advance(STEP_S);
    }
    return kit.percent("THRUSTER");
  }

  @Test
  void control_pointBehindAVesselWithARudder_keepsSteerageWay() {
    assertThat(propellerTowardsAPointBehind(1.0)).isGreaterThan(2.0);
  }

  @Test
  void control_pointBehindAVesselThatTurnsAtRest_turnsFirst() {
    assertThat(propellerTowardsAPointBehind(0.0)).isZero();
  }

  private void arm(boolean armed) {
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(armed));
  }

  @Test
  void control_armedAgain_slowActuatorStartsFromRestNotFromItsLastCommand() {
    startSlowThruster();
    arm(true);
    turned(1.0, 30);
    assertThat(kit.percent("THRUSTER")).isEqualTo(-100.0);
    arm(false);
    turned(0.0, 5);
    assertThat(kit.percent("THRUSTER")).isZero();

    arm(true);
    turned(0.0, 1);
    assertThat(kit.percent("THRUSTER")).isBetween(-5.1, 5.1);
  }

  private void announceGhost() {
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement()
            .actuatorName("GHOST")
            .minimum(-100.0)
            .maximum(100.0)
            .moment(Point.of(0.0, 0.0, 1.0e6))
            .renewal(1.0e6));
  }

  @Test
  void control_actuatorThatIsNotNamed_getsNothing() {
    kit.with("ACTUATORS", "RUDDER, THRUSTER");
    startSlowThruster();
    announceGhost();
    turned(1.0, 30);

    assertThat(kit.percent("THRUSTER")).isEqualTo(-100.0);
  }

  @Test
  void control_actuatorsNamedWhileWorking_theOthersAreForgotten() {
    startSlowThruster();
    announceGhost();
    turned(1.0, 30);
    assertThat(kit.percent("THRUSTER")).isBetween(-5.0, 0.0);

    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange()
            .serviceName("Control")
            .variableName("ACTUATORS")
            .value("THRUSTER"));
    turned(1.0, 30);

    assertThat(kit.percent("THRUSTER")).isEqualTo(-100.0);
  }

  @Test
  void control_retunedWhileWorking_slowActuatorGoesOnFromItsCommand() {
    AllocatingControl control = startSlowThruster();
    turned(1.0, 30);
    assertThat(kit.percent("THRUSTER")).isEqualTo(-100.0);

    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange()
            .serviceName(control.getServiceName())
            .variableName("YAW INERTIA")
            .value("110"));
    turned(1.0, 1);
    assertThat(kit.percent("THRUSTER")).isEqualTo(-100.0);
  }

  @Test
  void control_replacesOneOfItsClass_slowActuatorGoesOnFromItsCommand() {
    AllocatingControl control = startSlowThruster();
    turned(1.0, 30);

    kit.swap(control, AllocatingControl::new);
    announceSlowThruster();
    turned(1.0, 1);
    assertThat(kit.percent("THRUSTER")).isEqualTo(-100.0);
  }
}
