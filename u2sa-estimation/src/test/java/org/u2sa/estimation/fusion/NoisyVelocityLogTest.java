package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/** A submarine that lies still at the surface; its velocity log is noisier than it claims. */
class NoisyVelocityLogTest {
  private static final double CLAIM_MPS = 0.02;
  private static final double PLACE_SIGMA_M = 0.5;
  private static final double ALTITUDE_SIGMA_M = 2.0;
  private static final double FORCE_SIGMA_MPS2 = 0.05;
  private static final int SEEDS = 8;

  private final Measurement m = new Measurement();
  private SensedQuantity quantity = SensedQuantity.BODY_VELOCITY;
  private Random random;
  private ErrorStateFilter filter;
  private double worstSigmas;
  private double fastestMps; // vertically

  private double gauss(double sigma) {
    return sigma * random.nextGaussian();
  }

  private SourceReports.Report lieStill(int seed, double times, double noisyFromS, double untilS) {
    random = new Random(seed);
    filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.UNDERWATER));
    long micros = 0L;
    for (int step = 1; step <= 50.0 * untilS; step++) {
      micros = step * 20_000L;
      m.begin("IMU", micros).bodyRates(gauss(1e-3), gauss(1e-3), gauss(1e-3), 1e-3);
      filter.add(
          m.specificForce(
              gauss(FORCE_SIGMA_MPS2),
              gauss(FORCE_SIGMA_MPS2),
              -9.795 + gauss(FORCE_SIGMA_MPS2),
              FORCE_SIGMA_MPS2));
      if (step % 5 == 0) {
        filter.add(m.begin("Compass", micros).heading(gauss(0.01), 0.01));
      }
      if (step % 10 == 0) {
        log(micros, step < 50.0 * noisyFromS ? 1.0 : times);
        receiver(micros);
      }
    }
    return filter.sources().at(micros).stream()
        .filter(report -> report.source().equals("Log"))
        .findFirst()
        .orElseThrow();
  }

  private void log(long micros, double times) {
    m.begin("Log", micros);
    for (int axis = 0; axis < 3; axis++) {
      m.set(quantity, axis, gauss(times * CLAIM_MPS), CLAIM_MPS);
    }
    filter.add(m);
  }

  private void receiver(long micros) {
    Geodetic home = SimulatedMotion.HOME;
    Geodetic at = home.fromNed(Point.of(gauss(PLACE_SIGMA_M), gauss(PLACE_SIGMA_M), 0.0));
    m.begin("GPS", micros);
    m.place(at.latitudeDeg(), at.longitudeDeg(), PLACE_SIGMA_M, PLACE_SIGMA_M);
    m.altitude(home.altitudeM() + gauss(ALTITUDE_SIGMA_M), ALTITUDE_SIGMA_M);
    filter.add(m.velocity(gauss(0.05), gauss(0.05), 0.05));
    Estimate e = filter.at(micros);
    double offM = Math.abs(e.altitudeM() - home.altitudeM());
    fastestMps = Math.max(fastestMps, Math.abs(e.velocityMps(2)));
    worstSigmas = Math.max(worstSigmas, offM / e.positionSigmaM(2));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.0, 3.0, 5.0, 10.0})
  void add_logNoisierThanItClaims_isUsedWithItsActualSigma(double times) {
    for (int seed = 1; seed <= SEEDS; seed++) {
      SourceReports.Report report = lieStill(seed, times, 0.0, 30.0);
      assertThat(report.standing()).as("seed %s", seed).isEqualTo(SourceReports.Standing.USED);
      assertThat(report.gated()).as("seed %s", seed).isLessThan(3L);
      assertThat(report.sigmaFactor()).isBetween(0.7 * times, 1.4 * times);
    }
    assertThat(worstSigmas).isLessThan(4.0);
  }

  @Test
  void add_noisySpeedsThroughTheWater_verticalSpeedStaysSmall() {
    quantity = SensedQuantity.FLUID_VELOCITY;
    for (int seed = 1; seed <= 20; seed++) {
      lieStill(seed, 10.0, 0.0, 30.0);
    }
    assertThat(fastestMps).isLessThan(0.7);
    assertThat(worstSigmas).isLessThan(4.0);
  }

  @ParameterizedTest
  @CsvSource({"5.0, 70", "10.0, 100"})
  void add_logThatBecomesNoisier_isUsedAgain(double times, long maxGated) {
    for (int seed = 1; seed <= SEEDS; seed++) {
      SourceReports.Report report = lieStill(seed, times, 40.0, 70.0);
      assertThat(report.standing()).isNotEqualTo(SourceReports.Standing.BIASED);
      assertThat(report.gated()).as("seed %s", seed).isLessThan(maxGated);
      assertThat(report.sigmaFactor()).isBetween(0.5 * times, 1.4 * times);
    }
    assertThat(worstSigmas).isLessThan(4.0);
  }
}
