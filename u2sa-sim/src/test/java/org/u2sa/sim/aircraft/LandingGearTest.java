package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.sim.gear.Wheel;
import org.u2sa.sim.motion.BodyAttitude;

class LandingGearTest {
  private final LandingGear gear = new LandingGear();
  private final BodyAttitude attitude = new BodyAttitude();

  // wing tip 5.48 m out and 2 m above ground: 21.5°; tail ring: 14.5° about the main wheels
  @ParameterizedTest
  @CsvSource({
    "0, 2.5, 1.25, false", "20, 0, 1.25, false", "24, 0, 1.25, true", "-24, 0, 1.25, true",
    "0, 12, 1.37, false", "0, 16, 1.37, true", "0, -10, 1.25, false", "0, -20, 1.25, true",
    "180, 0, 1.6, false", "180, 0, 0.9, true"
  })
  void broken_noWheelLoaded_isWhetherACornerIsBelowGround(
      double rollDeg, double pitchDeg, double heightM, boolean expected) {
    set(rollDeg, pitchDeg);
    assertThat(gear.broken(attitude, heightM)).isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource({"1.0, false", "3.5, false", "3.8, true"})
  void broken_firstContact_isWhetherItWasTooHard(double sinkMps, boolean expected) {
    set(0.0, 2.5);
    for (Wheel wheel : gear.wheels) {
      wheel.compute(attitude, -0.01, 0.0, 0.0, sinkMps, 0.0, 0.0);
    }
    assertThat(gear.broken(attitude, LandingGear.STANDING_M)).isEqualTo(expected);
  }

  @Test
  void broken_legPressedIn_isTrue() {
    set(0.0, 2.5);
    gear.wheels[1].compute(attitude, -0.31, 0.0, 0.0, 0.0, 0.0, 0.0);
    assertThat(gear.broken(attitude, LandingGear.STANDING_M)).isTrue();
  }

  @Test
  void compute_rollingStraight_tyreKeepsSlipAngleForce() {
    // steady slip: deflection = relaxation length · slip angle, so the force follows the angle and
    // not the speed
    Wheel wheel = gear.wheels[1];
    set(0.0, 0.0);
    double slow = steadySideForce(wheel, 5.0);
    double fast = steadySideForce(wheel, 10.0);
    assertThat(slow).isPositive();
    assertThat(fast).isCloseTo(slow, within(0.2 * slow));
  }

  @Test
  void compute_lockedWheel_slidesAtItsLimit() {
    Wheel wheel = gear.wheels[1];
    set(0.0, 0.0);
    wheel.set(0.0, 1.0);
    wheel.compute(attitude, -0.05, 20.0, 0.0, 0.0, 1.0, 0.0);
    assertThat(wheel.forceN() / wheel.forceD()).isCloseTo(0.47, within(1e-9));
  }

  private double steadySideForce(Wheel wheel, double speedMps) {
    double across = 0.0;
    double slipMps = -0.02 * speedMps;
    for (int i = 0; i < 1_000; i++) {
      wheel.compute(attitude, -0.05, speedMps, slipMps, 0.0, 0.0, across);
      across = wheel.boundedAcross(across + 0.001 * wheel.deflectionAcrossRate(across));
    }
    return wheel.forceE();
  }

  private void set(double rollDeg, double pitchDeg) {
    double[] q = new double[4];
    BodyAttitude.write(q, 0, Math.toRadians(rollDeg), Math.toRadians(pitchDeg), 0.0);
    attitude.set(q[0], q[1], q[2], q[3]);
  }
}
