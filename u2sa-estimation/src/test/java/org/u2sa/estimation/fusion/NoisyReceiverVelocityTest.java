package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** A rover starts north with a wrong compass; the velocity of its accurate receiver is noisy. */
class NoisyReceiverVelocityTest {
  private static final double COMPASS_OFF_RAD = 0.5;
  private static final double SPEED_MPS = 1.5;
  private static final double START_S = 5.0;
  private static final double SIGMA_M = 0.02;
  private static final double SIGMA_MPS = 0.6;

  private final Random random = new Random();
  private final Measurement m = new Measurement();
  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.GROUND));
  private double north;
  private double mps;
  private double worst;
  private double worstSigma;

  private double noise(double sigma) {
    return sigma * random.nextGaussian();
  }

  private void step(int i) {
    long micros = i * 10_000L;
    double force = i * 0.01 > START_S && mps < SPEED_MPS ? 1.0 : 0.0;
    mps += 0.01 * force;
    north += 0.01 * mps;
    if (i % 2 == 0) {
      m.begin("IMU", micros).bodyRates(noise(1e-3), noise(1e-3), noise(1e-3), 1e-3);
      m.specificForce(force + noise(0.05), noise(0.05), noise(0.05) - 9.793, 0.05);
      filter.add(m);
    }
    if (i % 5 == 0) {
      filter.add(m.begin("Wheels", micros).forward(mps + noise(0.02), 0.02));
    }
    if (i % 10 == 0) {
      filter.add(m.begin("Compass", micros).heading(COMPASS_OFF_RAD + noise(0.01), 0.02));
      Geodetic at =
          SimulatedMotion.HOME.fromNed(Point.of(north + noise(SIGMA_M), noise(SIGMA_M), 0));
      m.begin("GPS", micros).place(at.latitudeDeg(), at.longitudeDeg(), SIGMA_M, SIGMA_M);
      m.altitude(5.0 + noise(0.04), 0.04)
          .velocity(mps + noise(SIGMA_MPS), noise(SIGMA_MPS), SIGMA_MPS);
      filter.add(m);
      Estimate e = filter.at(micros);
      Geodetic said = new Geodetic(e.longitudeDeg(), e.latitudeDeg(), 0.0);
      Point is = SimulatedMotion.HOME.nedOf(said);
      worst = Math.max(worst, Math.hypot(is.x() - north, is.y()));
      worstSigma = Math.max(worstSigma, Math.max(e.positionSigmaM(0), e.positionSigmaM(1)));
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
  void add_compassIsWrong_receiverIsNotLeftOut(int seed) {
    random.setSeed(seed);
    for (int i = 1; i <= 3000; i++) {
      step(i);
      if (i % 100 == 0) {
        String sources = filter.sources().at(i * 10_000L).toString();
        assertThat(sources).doesNotContain("source=GPS, standing=BIASED");
      }
    }
    assertThat(worst).isLessThan(3.5); // until positions have prevailed
    assertThat(worstSigma).isLessThan(0.5);
  }
}
