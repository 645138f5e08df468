package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * A rover starts to move while its estimator does, and its wheels spin or slip just then. Every
 * other measurement is as accurate as it claims, and the receiver is accurate to 5 mm.
 */
class WrongFirstSpeedTest {
  private static final double STEP_S = 0.01;
  private static final double TOP_MPS = 0.6;
  private static final double WHEEL_SIGMA_MPS = 0.0025;
  private static final double FIX_SIGMA_M = 0.005;

  private final Measurement m = new Measurement();
  private final double[] truth = new double[4]; // north, east [m], heading [rad], speed [m/s]
  private ErrorStateFilter filter;
  private Random random;

  private double noise(double sigma) {
    return sigma * random.nextGaussian();
  }

  private double errorM(long micros) {
    Estimate e = filter.at(micros);
    Point ned = SimulatedMotion.HOME.nedOf(new Geodetic(e.longitudeDeg(), e.latitudeDeg(), 10.0));
    return Math.hypot(ned.x() - truth[0], ned.y() - truth[1]);
  }

  @ParameterizedTest
  @CsvSource({
    "5, 0.20, 0.16, 0.5", "14, 0.20, 0.16, 0.5", "11, 0.20, 0.16, 0.5",
    "3, 0.20, 0.01, -0.3", "8, 0.30, 0.01, -0.1", "1, 0.20, 0.40, -0.3"
  })
  void add_wheelsWrongAtTheStart_recoversWithinASecond(
      int seed, double atS, double forS, double wrongMps) {
    for (int wheelSteps = 2; wheelSteps <= 10; wheelSteps += 8) {
      filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
      random = new Random(seed);
      double worstM = 0.0;
      double lateM = 0.0;
      truth[0] = 0.0;
      truth[1] = 0.0;
      truth[2] = 0.3;
      truth[3] = 0.0;
      for (int i = 1; i <= 2000; i++) {
        double now = i * STEP_S;
        boolean isWrong = Math.abs(now - atS) < forS;
        move(i, wheelSteps, isWrong ? wrongMps : Double.NaN);
        worstM = Math.max(worstM, i > 10 ? errorM(i * 10_000L) : 0.0);
        lateM = Math.max(lateM, now > 10.0 ? errorM(i * 10_000L) : 0.0);
      }
      assertThat(worstM).isLessThan(1.0);
      assertThat(lateM).isLessThan(0.1);
    }
  }

  private void move(int step, int wheelSteps, double wrongMps) {
    long micros = step * 10_000L;
    double now = step * STEP_S;
    double forward = now < 0.15 ? 0.0 : Math.min(1.0, (TOP_MPS - truth[3]) / 0.3);
    double turn = truth[3] > 0.1 ? 0.3 * Math.sin(0.5 * now) : 0.0;
    truth[2] += STEP_S * turn;
    truth[3] += STEP_S * forward;
    truth[0] += STEP_S * truth[3] * Math.cos(truth[2]);
    truth[1] += STEP_S * truth[3] * Math.sin(truth[2]);
    m.begin("IMU", micros)
        .bodyRates(noise(0.003), noise(0.003), turn + noise(0.003), 0.005)
        .specificForce(
            forward + noise(0.05), truth[3] * turn + noise(0.05), -9.7926 + noise(0.05), 0.1);
    filter.add(m);
    if (step % wheelSteps == 0) {
      double mps = Double.isNaN(wrongMps) ? truth[3] + noise(WHEEL_SIGMA_MPS) : wrongMps;
      m.begin("Wheels", micros).set(SensedQuantity.BODY_VELOCITY, 0, mps, WHEEL_SIGMA_MPS);
      filter.add(m);
    }
    if (step % 10 == 0) {
      double psi = Math.IEEEremainder(truth[2] + noise(0.03), 2.0 * Math.PI);
      filter.add(m.begin("Compass", micros).heading(psi, 0.03));
      Geodetic at =
          SimulatedMotion.HOME.fromNed(
              Point.of(truth[0] + noise(FIX_SIGMA_M), truth[1] + noise(FIX_SIGMA_M), 0.0));
      m.begin("GPS", micros)
          .place(at.latitudeDeg(), at.longitudeDeg(), FIX_SIGMA_M, FIX_SIGMA_M)
          .velocity(
              truth[3] * Math.cos(truth[2]) + noise(0.1),
              truth[3] * Math.sin(truth[2]) + noise(0.1),
              0.1);
      filter.add(m);
    }
  }
}
