package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.Quaternions;

/** An aircraft with two receivers, one of which repeats its fix from some moment on. */
class FrozenReceiverTest {
  private static final double ANGLE_SIGMA = Math.toRadians(2.0);
  private static final double SIGMA = 0.02; // m
  private static final double SPEED_SIGMA = 0.3; // m/s

  private final ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.AIR));
  private final Measurement m = new Measurement();
  private final Measurement second = new Measurement();
  private final double[] biasFrom30S = new double[6]; // of the inertial sensor
  private double worst; // m, in any direction

  private void fly(int seed, double hoversUntilS, double frozenFromS, double frozenUntilS) {
    SimulatedMotion truth = new SimulatedMotion(seed);
    for (int i = 1; i <= 6000; i++) {
      double t = i * 0.01;
      boolean hovers = t < hoversUntilS;
      truth.fly(hovers ? 1e-3 : 2.0, hovers ? 1e-3 : 0.2);
      truth.imu(m, "IMU", t < 30.0 ? new double[6] : biasFrom30S, 0.003, 0.05);
      m.heading(truth.psi() + truth.gauss(ANGLE_SIGMA), ANGLE_SIGMA);
      m.set(SensedQuantity.TILT, 0, tilt(Quaternions.phi(truth.r), truth), ANGLE_SIGMA);
      m.set(SensedQuantity.TILT, 1, tilt(Quaternions.theta(truth.r), truth), ANGLE_SIGMA);
      filter.add(m);
      if (i % 10 == 0) {
        secondFix(truth, t >= frozenFromS && t < frozenUntilS);
        filter.add(truth.fix(m, "GPS", SIGMA, SPEED_SIGMA, 0.0));
      }
      Estimate estimate = filter.at(truth.micros);
      if (t > 2.0) {
        double[] errors = truth.errors(estimate);
        double above = estimate.altitudeM() - SimulatedMotion.HOME.altitudeM() + truth.p[2];
        worst = Math.max(worst, Math.hypot(Math.hypot(errors[0], errors[1]), above));
      }
    }
  }

  private static double tilt(double angle, SimulatedMotion truth) {
    return angle + truth.gauss(ANGLE_SIGMA);
  }

  /** The second receiver's fix, or what it said last, with the time of now. */
  private void secondFix(SimulatedMotion truth, boolean isFrozen) {
    Measurement said = new Measurement();
    said.copyFrom(second);
    truth.fix(second, "SECOND", SIGMA, SPEED_SIGMA, 0.0);
    if (isFrozen) {
      Measurement now = new Measurement();
      now.copyFrom(second);
      second.copyFrom(said);
      second.begin("SECOND", now.micros());
      for (SensedQuantity each :
          new SensedQuantity[] {
            SensedQuantity.PLACE, SensedQuantity.ALTITUDE, SensedQuantity.VELOCITY
          }) {
        for (int c = 0; c < 3; c++) {
          if (said.has(each, c)) {
            second.set(each, c, said.value(each, c), said.sigma(each, c));
          }
        }
      }
    }
    filter.add(second);
  }

  @ParameterizedTest
  @CsvSource({
    "200, 10, 5, 60", "201, 10, 5, 60", "202, 10, 8, 60", "203, 0, 20, 60", "204, 0, 30, 60",
    "205, 20, 3, 40", "206, 0, 10, 30", "207, 5, 3, 60", "208, 5, 4, 30", "209, 0, 15, 16"
  })
  void add_secondReceiverFrozen_otherReceiverIsFollowed(
      int seed, double hoversUntilS, double frozenFromS, double frozenUntilS) {
    fly(seed, hoversUntilS, frozenFromS, frozenUntilS);
    assertThat(worst).isLessThan(1.0);
  }

  /** A velocity that has been lost is set to a measured one, but not to that of the frozen one. */
  @ParameterizedTest
  @CsvSource({"300, 0.1, 0.05", "301, 0.1, 0", "302, 0, -0.1", "303, -0.07, 0.07"})
  void add_gyroscopesStepWhileReceiverIsFrozen_otherReceiverIsFollowed(
      int seed, double p, double q) {
    biasFrom30S[0] = p;
    biasFrom30S[1] = q;
    fly(seed, 0.0, 10.0, 60.0);
    assertThat(worst).isLessThan(6.0);
  }
}
