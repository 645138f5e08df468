package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.u2sa.control.Transfer;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.service.handover.HandOver;

class PursuitLawTest {
  private static final double STEP_S = 0.1;
  private static final PursuitSettings SETTINGS =
      new PursuitSettings(
          tuning(1.2, 0.9),
          10.0,
          new PursuitSettings.SpotTurn(true, Math.toRadians(50.0), Math.toRadians(10.0), 2.0));

  private final PursuitLaw law = new PursuitLaw(SETTINGS);

  private static PursuitVariables tuning(double turnRateRadPerS, double regulatedRadiusM) {
    Map<String, Object> values =
        Map.of(
            "CRUISE SPEED", 1.0,
            "ACCELERATION", 0.5,
            "BRAKING", 1.0,
            "APPROACH SPEED", 0.1,
            "REGULATED RADIUS", regulatedRadiusM,
            "TURN RATE", Math.toDegrees(turnRateRadPerS),
            "TURN RATE CHANGE", Math.toDegrees(2.0));
    return XmlConfiguration.inMemory("test", values).settings(PursuitVariables.class).get();
  }

  private static Optional<GroundTarget> at(double forwardM, double leftM) {
    return Optional.of(new GroundTarget(forwardM, leftM, OptionalDouble.empty(), false));
  }

  /** How it moves when it has long gone to a point that stays where it is, seen from it. */
  private Drive settled(Optional<GroundTarget> target) {
    for (int i = 0; i < 100; i++) {
      law.step(target, STEP_S);
    }
    return law.step(target, STEP_S);
  }

  @Test
  void step_pointAhead_isReachedByTheArcThroughIt() {
    Drive drive = settled(at(2.0, 0.5));

    assertThat(drive.speedMps()).isEqualTo(1.0);
    double radius = drive.speedMps() / drive.yawRateRadPerS();
    // the centre of the arc lies to the left: as far from the vehicle as from the point
    assertThat(Math.hypot(2.0, 0.5 - radius)).isCloseTo(radius, within(1.0e-9));
  }

  @Test
  void step_pointToTheRight_turnsRight() {
    assertThat(settled(at(2.0, -0.5)).yawRateRadPerS()).isNegative();
  }

  @Test
  void step_fromRest_speedGrowsWithTheAcceleration() {
    law.step(at(5.0, 0.0), STEP_S);

    assertThat(law.step(at(5.0, 0.0), STEP_S).speedMps()).isCloseTo(0.1, within(1.0e-9));
  }

  @Test
  void step_noTarget_brakesAndStands() {
    settled(at(5.0, 0.0));

    assertThat(law.step(Optional.empty(), STEP_S).speedMps()).isCloseTo(0.9, within(1.0e-9));
    assertThat(settled(Optional.empty())).isEqualTo(Drive.STANDING);
  }

  @Test
  void step_theOtherWay_brakesToAStopFirst() {
    settled(at(5.0, 0.0));
    Optional<GroundTarget> behind =
        Optional.of(new GroundTarget(-5.0, 0.0, OptionalDouble.of(1.0), true));
    assertThat(law.step(behind, STEP_S).speedMps()).isCloseTo(0.9, within(1.0e-9));
    for (int i = 0; i < 8; i++) {
      law.step(behind, STEP_S);
    }
    assertThat(law.step(behind, STEP_S).speedMps()).isCloseTo(0.0, within(1.0e-9));
    law.step(behind, STEP_S); // rounding may have left a little
    assertThat(law.step(behind, STEP_S).speedMps()).isBetween(-0.101, -0.049);
  }

  @Test
  void step_speedZeroAtAPointAside_brakesOnTheArcToIt() {
    settled(at(2.0, 0.5));
    Optional<GroundTarget> stop =
        Optional.of(new GroundTarget(2.0, 0.5, OptionalDouble.of(0.0), false));
    for (int i = 0; i < 5; i++) {
      Drive drive = law.step(stop, STEP_S);
      assertThat(drive.yawRateRadPerS() / drive.speedMps())
          .isCloseTo(2.0 * 0.5 / (2.0 * 2.0 + 0.5 * 0.5), within(1.0e-9));
    }
    assertThat(settled(stop)).isEqualTo(Drive.STANDING);
  }

  @Test
  void step_tightCurve_isDrivenSlower() {
    Drive drive = settled(at(0.8, 0.8));
    double radius = drive.speedMps() / drive.yawRateRadPerS();

    assertThat(radius).isCloseTo(0.8, within(1.0e-9));
    assertThat(drive.speedMps()).isCloseTo(0.8 / 0.9, within(1.0e-9));
  }

  @Test
  void step_curveTighterThanTheTurnRateAllows_isDrivenSlowerNotWider() {
    Drive drive = settled(Optional.of(new GroundTarget(0.6, 0.6, OptionalDouble.of(2.0), false)));

    assertThat(drive.yawRateRadPerS()).isEqualTo(1.2);
    double radius = drive.speedMps() / drive.yawRateRadPerS();
    assertThat(radius).isCloseTo(0.6, within(1.0e-9));
  }

  @Test
  void step_pointFarAside_turnsOnTheSpotUntilItIsAhead() {
    Drive turning = settled(at(0.0, 3.0));
    assertThat(turning).isEqualTo(new Drive(0.0, 1.2));

    double aheadEnough = Math.toRadians(9.0);
    assertThat(settled(at(3.0 * Math.cos(0.3), 3.0 * Math.sin(0.3))).speedMps()).isZero();
    assertThat(settled(at(3.0 * Math.cos(aheadEnough), 3.0 * Math.sin(aheadEnough))).speedMps())
        .isEqualTo(1.0);
  }

  @Test
  void step_pointBehindAVehicleThatCannotTurnOnTheSpot_drivesItsTightestCurve() {
    PursuitLaw car =
        new PursuitLaw(new PursuitSettings(tuning(1.0, 0.0), 0.5, PursuitSettings.SpotTurn.NONE));
    Drive drive = Drive.STANDING;
    for (int i = 0; i < 100; i++) {
      drive = car.step(at(-3.0, -0.1), STEP_S);
    }

    assertThat(drive.speedMps()).isEqualTo(1.0);
    assertThat(drive.yawRateRadPerS()).isCloseTo(-0.5, within(1.0e-9));
  }

  @Test
  void step_withinTolerance_standsUntilClearlyOutside() {
    assertThat(settled(at(0.1, 0.0))).isEqualTo(Drive.STANDING);
    assertThat(settled(at(0.25, 0.0))).isEqualTo(Drive.STANDING);
    assertThat(settled(at(0.35, 0.0)).speedMps()).isPositive();
  }

  @Test
  void step_goalWithASpeed_isThatFast() {
    assertThat(
            settled(Optional.of(new GroundTarget(9.0, 0.0, OptionalDouble.of(0.4), false)))
                .speedMps())
        .isEqualTo(0.4);
  }

  @Test
  void takeOver_inACurve_goesOnAsTheOtherWouldHave() {
    settled(at(2.0, 0.5));
    HandOver state = new HandOver("PursuitLaw");
    law.transfer(Transfer.saving(state));
    PursuitLaw successor = new PursuitLaw(SETTINGS);
    successor.transfer(Transfer.restoring(state));

    assertThat(successor.step(at(2.0, 0.4), STEP_S)).isEqualTo(law.step(at(2.0, 0.4), STEP_S));
  }

  @Test
  void step_pointBehindToTheLeftBackwards_drivesBackOnTheSameArc() {
    Drive drive = settled(Optional.of(new GroundTarget(-2.0, 0.4, OptionalDouble.of(0.5), true)));

    assertThat(drive.speedMps()).isNegative();
    assertThat(drive.yawRateRadPerS() / drive.speedMps())
        .isCloseTo(2.0 * 0.4 / (4.0 + 0.16), within(1.0e-6)); // 2 y / L²
  }
}
