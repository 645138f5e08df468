package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.Quaternions;

/** An aircraft whose heading sensors are all wrong by the same angle; everything else is right. */
class WrongHeadingsTest {
  private static final double RIGHT_AGAIN_S = 60.0;
  private static final double SIGMA_RAD = Math.toRadians(2.0);

  private final Measurement m = new Measurement();
  private final ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.AIR));
  private double worstM;
  private double worstRad;

  @ParameterizedTest
  @CsvSource({"1, 20, 60", "2, 20, -40", "3, 20, 90", "4, 20, 180", "5, 0, 50", "6, 0, -100"})
  void add_allHeadingsWrong_followsTheReceiver(int seed, double fromS, double wrongDeg) {
    fly(seed, fromS, 1e3, wrongDeg);

    assertThat(worstM).isLessThan(2.0);
    assertThat(Math.toDegrees(worstRad)).as("20 s later").isLessThan(8.0);
  }

  @ParameterizedTest
  @CsvSource({"7, 60", "8, -40", "9, 180"})
  void add_headingsRightAgain_areUsedAgain(int seed, double wrongDeg) {
    fly(seed, 20.0, RIGHT_AGAIN_S, wrongDeg);

    assertThat(worstM).isLessThan(2.0);
    assertThat(filter.sources().at(80_000_000).toString())
        .contains("source=Compass, standing=USED");
  }

  private void fly(int seed, double fromS, double toS, double wrongDeg) {
    SimulatedMotion motion = new SimulatedMotion(seed);
    double[] none = new double[6];
    for (int i = 1; i <= 8_000; i++) {
      motion.fly(1.0, 0.1);
      double t = motion.micros * 1e-6;
      double wrong = t >= fromS && t < toS ? Math.toRadians(wrongDeg) : 0.0;
      motion.imu(m, "IMU", none, 0.003, 0.05);
      m.heading(motion.psi() + wrong + motion.gauss(SIGMA_RAD), SIGMA_RAD);
      m.set(SensedQuantity.TILT, 0, tilt(motion, Quaternions.phi(motion.r)), SIGMA_RAD);
      m.set(SensedQuantity.TILT, 1, tilt(motion, Quaternions.theta(motion.r)), SIGMA_RAD);
      filter.add(m);
      if (i % 10 == 0) {
        double heading = motion.psi() + wrong + motion.gauss(SIGMA_RAD);
        filter.add(m.begin("Compass", motion.micros).heading(heading, SIGMA_RAD));
      }
      if (i % 20 == 0) {
        filter.add(motion.fix(m, "GPS", 0.05, 0.05, 1.0));
        compare(motion, t, fromS);
      }
    }
  }

  private static double tilt(SimulatedMotion motion, double rad) {
    return rad + motion.gauss(SIGMA_RAD);
  }

  private void compare(SimulatedMotion motion, double t, double fromS) {
    if (t < 10.0) {
      return; // still aligning
    }
    double[] errors = motion.errors(filter.at(motion.micros));
    worstM = Math.max(worstM, Math.hypot(errors[0], errors[1]));
    if (t > fromS + 20.0) {
      worstRad = Math.max(worstRad, Math.abs(errors[4]));
    }
  }
}
