package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.Quaternions;

/** A vehicle whose only gyroscopes take on another bias under way; everything else is right. */
class GyroscopeStepTest {
  private static final double STEP_AT_S = 20.0;
  private static final double SIGMA_RADPS = 0.003;
  private static final double TILT_SIGMA_RAD = Math.toRadians(1.0);

  private final Measurement m = new Measurement();
  private ErrorStateFilter filter;
  private double worstM;
  private double worstTiltRad;

  @ParameterizedTest
  @CsvSource({
    "1, AIR, 0.1, 0.05, 0.05",
    "2, AIR, 0.1, 0, 0",
    "3, AIR, 0, -0.1, 0",
    "4, AIR, -0.07, 0.07, -0.07",
    "5, WATER, 0.1, 0.05, 0.05",
    "6, WATER, 0, -0.1, 0",
    "7, UNDERWATER, 0.1, 0.05, 0.05",
    "8, UNDERWATER, -0.07, 0.07, -0.07"
  })
  void add_biasOfTheGyroscopesSteps_isLearnt(
      int seed, MotionDomain domain, double p, double q, double r) {
    filter = new ErrorStateFilter(FilterTuning.of(domain));
    double push = domain == MotionDomain.AIR ? 0.5 : 0.1;
    SimulatedMotion motion = new SimulatedMotion(seed);
    double[] step = {p, q, r, 0.0, 0.0, 0.0};
    double[] none = new double[6];
    for (int i = 1; i <= 6_000; i++) {
      motion.fly(push, 0.2 * push);
      double t = motion.micros * 1e-6;
      motion.imu(m, "IMU", t < STEP_AT_S ? none : step, SIGMA_RADPS, 0.05);
      m.set(SensedQuantity.TILT, 0, tilt(motion, Quaternions.phi(motion.r)), TILT_SIGMA_RAD);
      m.set(SensedQuantity.TILT, 1, tilt(motion, Quaternions.theta(motion.r)), TILT_SIGMA_RAD);
      filter.add(m);
      if (i % 10 == 0) {
        filter.add(motion.compass(m, "Compass", Math.toRadians(2.0)));
      }
      if (i % 20 == 0) {
        filter.add(motion.fix(m, "GPS", 0.05, 0.05, 1.0));
        compare(motion, t);
      }
    }

    assertThat(worstM).isLessThan(2.0);
    assertThat(Math.toDegrees(worstTiltRad)).as("10 s later").isLessThan(3.0);
  }

  private static double tilt(SimulatedMotion motion, double rad) {
    return rad + motion.gauss(TILT_SIGMA_RAD);
  }

  private void compare(SimulatedMotion motion, double t) {
    Estimate e = filter.at(motion.micros);
    if (t < 10.0) {
      return; // still aligning
    }
    double[] errors = motion.errors(e);
    worstM = Math.max(worstM, Math.hypot(errors[0], errors[1]));
    if (t > STEP_AT_S + 10.0) {
      worstTiltRad = Math.max(worstTiltRad, Math.abs(e.phi() - Quaternions.phi(motion.r)));
      worstTiltRad = Math.max(worstTiltRad, Math.abs(e.theta() - Quaternions.theta(motion.r)));
    }
  }
}
