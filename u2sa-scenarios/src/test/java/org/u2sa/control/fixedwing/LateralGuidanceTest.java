package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Against Park, Deyst and How, AIAA 2004-4900. */
class LateralGuidanceTest {
  private static final double V = 43.0;

  private final LateralGuidance guidance = new LateralGuidance(150.0);

  @Test
  void acceleration_pointStraightAhead_isNone() {
    assertThat(guidance.accelerationMps2(States.level().now(), 0.0, 300.0)).isZero();
  }

  @Test
  void acceleration_pointToTheRight_isTwiceSpeedSquaredOverL1TimesSineEta() {
    double eta = Math.toRadians(20.0); // flying east: south is right
    double a =
        guidance.accelerationMps2(
            States.level().now(), -300.0 * Math.sin(eta), 300.0 * Math.cos(eta));
    assertThat(a).isCloseTo(2.0 * V * V / 300.0 * Math.sin(eta), within(1e-9));
  }

  @Test
  void acceleration_pointOnACircle_isThatOfTheCircle() {
    // Paper, section III.B: the acceleration of the circle through both points, tangent to V.
    double radius = 500.0;
    double arc = Math.toRadians(35.0);
    double east = radius * Math.sin(arc);
    double south = radius * (1.0 - Math.cos(arc));
    assertThat(guidance.accelerationMps2(States.level().now(), -south, east))
        .isCloseTo(V * V / radius, within(1e-9));
  }

  @Test
  void acceleration_pointBehind_isThatOfARightAngle() {
    double a = guidance.accelerationMps2(States.level().now(), -10.0, -300.0);
    assertThat(a).isCloseTo(2.0 * V * V / Math.hypot(10.0, 300.0), within(1e-6));
  }

  @Test
  void acceleration_pointVeryNear_isBoundedByTheShortestL1() {
    double a = guidance.accelerationMps2(States.level().now(), -1.0, 0.0);
    assertThat(a).isCloseTo(2.0 * V * V / 150.0, within(1e-9));
  }

  @Test
  void bank_crosswindDrift_followsTheTrackNotTheNose() {
    FlightState drifting = States.level().ground(-8.0, 42.0).now(); // nose east, blown south
    double track = Math.atan2(42.0, -8.0);
    double bank = guidance.bankRad(drifting, 300.0 * Math.cos(track), 300.0 * Math.sin(track));
    assertThat(bank).isCloseTo(0.0, within(1e-9));
    assertThat(guidance.bankRad(drifting, 0.0, 300.0)).isNegative();
  }

  @Test
  void bank_standingStill_usesTheNose() {
    assertThat(guidance.bankRad(States.standing().now(), 0.0, 300.0)).isZero();
  }
}
