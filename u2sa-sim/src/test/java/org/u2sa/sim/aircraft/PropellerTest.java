package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PropellerTest {
  private static final double DENSITY = 1.225;
  private final Propeller propeller = new Propeller();

  @Test
  void compute_static2350Rpm_takesTheFullThrottlePower() {
    double shaft = 2_350.0 * PistonEngine.RADPERS_PER_RPM;
    propeller.compute(shaft, 0.0, DENSITY);
    // T = CT ρ n² D⁴: 0.080 · 1.225 · 39.17² · 1.905⁴ = 1980 N
    assertThat(propeller.thrustN()).isCloseTo(1_980.0, within(10.0));
    assertThat(propeller.torqueNm() * shaft / 745.7).isBetween(138.0, 148.0);
  }

  @Test
  void compute_cruise_isEightyPercentEfficient() {
    double shaft = 2_500.0 * PistonEngine.RADPERS_PER_RPM;
    double speed = 0.72 * 2_500.0 / 60.0 * 1.905;
    propeller.compute(shaft, speed, DENSITY);
    double efficiency = propeller.thrustN() * speed / (propeller.torqueNm() * shaft);
    assertThat(efficiency).isBetween(0.78, 0.84); // NACA TR-640, 5868-9, two blades, 15°…20°
  }

  @Test
  void compute_fastAndSlowlyTurning_windmills() {
    propeller.compute(1_200.0 * PistonEngine.RADPERS_PER_RPM, 50.0, DENSITY);
    assertThat(propeller.thrustN()).isNegative();
    assertThat(propeller.torqueNm()).isNegative();
  }

  @Test
  void compute_stopped_isDragAndHardlyTorque() {
    propeller.compute(0.0, 35.0, DENSITY);
    assertThat(propeller.thrustN()).isBetween(-150.0, -40.0);
    assertThat(propeller.torqueNm())
        .isBetween(-40.0, 0.0); // less than the engine's friction: it stays stopped
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.9999, 2.0001})
  void compute_aroundTheLastAdvanceRatio_isContinuous(double advanceRatio) {
    propeller.compute(100.0, advanceRatio * 100.0 / (2.0 * Math.PI) * 1.905, DENSITY);
    double n2 = 100.0 / (2.0 * Math.PI) * 100.0 / (2.0 * Math.PI);
    double expected = -0.060 * DENSITY * n2 * Math.pow(1.905, 4);
    assertThat(propeller.thrustN()).isCloseTo(expected, within(0.1));
  }

  @Test
  void compute_standingStill_givesNothing() {
    propeller.compute(0.0, -5.0, DENSITY);
    assertThat(propeller.thrustN()).isZero();
    assertThat(propeller.torqueNm()).isZero();
  }
}
