package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.messages.frame.Geodetic;

/**
 * A submarine on its way north, slowly up and down, with a correct depth gauge and a velocity log
 * that errs from the 30th second on.
 */
class WrongVelocityLogTest {
  private static final double SPEED_MPS = 0.4;
  private static final double WAVE_RAD_PER_S = 0.15;
  private static final double G_MPS2 = 9.795;
  private static final double FAULT_S = 30.0;

  private final Random random = new Random(3);
  private final Measurement m = new Measurement();
  private final ErrorStateFilter filter =
      new ErrorStateFilter(FilterTuning.of(MotionDomain.UNDERWATER));
  private final double[] kept = new double[3];
  private double waveM = 0.3;
  private double errorMps; // vertical
  private double jumpM; // of the depth gauge
  private int outlierAt; // each reading of that number; 0: none
  private boolean isFrozen; // the log
  private boolean isGaugeFrozen;
  private double keptM;
  private double northMps2; // from the fault on
  private double nowS;
  private double altitudeM;
  private double northMps = SPEED_MPS;
  private double northM;
  private double worstM;
  private double worstSigmas;
  private double worstNorthSigmas;

  private double gauss(double sigma) {
    return sigma * random.nextGaussian();
  }

  private void dive(double untilS) {
    for (long step = Math.round(nowS * 100.0); nowS < untilS; step++) {
      nowS = step / 100.0;
      long micros = step * 10_000L + 10_000L;
      double phase = WAVE_RAD_PER_S * nowS;
      altitudeM = -3.0 + waveM * Math.sin(phase);
      double downMps = -waveM * WAVE_RAD_PER_S * Math.cos(phase);
      double downMps2 = waveM * WAVE_RAD_PER_S * WAVE_RAD_PER_S * Math.sin(phase);
      double forwardMps2 = nowS >= FAULT_S ? northMps2 : 0.0;
      northMps += forwardMps2 * 0.01;
      northM += northMps * 0.01;
      if (step == 0) {
        Geodetic home = SimulatedMotion.HOME;
        filter.add(m.begin("GPS", micros).place(home.latitudeDeg(), home.longitudeDeg(), 0.1, 0.1));
      }
      if (step % 2 == 0) {
        m.begin("IMU", micros).bodyRates(gauss(1e-3), gauss(1e-3), gauss(1e-3), 1e-3);
        m.specificForce(
            forwardMps2 + gauss(0.02), gauss(0.02), downMps2 - G_MPS2 + gauss(0.02), 0.02);
        filter.add(m);
      }
      if (step % 10 == 0) {
        filter.add(m.begin("Compass", micros).heading(gauss(0.01), 0.02));
        if (nowS < FAULT_S || !isGaugeFrozen) {
          keptM = altitudeM + (nowS < FAULT_S ? 0.0 : jumpM) + gauss(0.02);
        }
        filter.add(m.begin("Depth", micros).altitude(keptM, 0.02));
      }
      if (step % 20 == 0) {
        log(micros, downMps);
      }
      if (step % 50 == 0 && nowS > 10.0) {
        Estimate e = filter.at(micros);
        double offM = Math.abs(e.altitudeM() - altitudeM);
        worstM = Math.max(worstM, offM);
        worstSigmas = Math.max(worstSigmas, offM / e.positionSigmaM(2));
        double northOffM = (e.latitudeDeg() - SimulatedMotion.HOME.latitudeDeg()) * 110_850.0;
        worstNorthSigmas =
            Math.max(worstNorthSigmas, Math.abs(northOffM - northM) / e.positionSigmaM(0));
      }
    }
  }

  private void log(long micros, double downMps) {
    boolean errs = nowS >= FAULT_S;
    double[] truth = {northMps, 0.0, downMps + (errs ? errorMps : 0.0)};
    m.begin("Log", micros);
    for (int axis = 0; axis < 3; axis++) {
      if (!errs || !isFrozen) {
        kept[axis] = truth[axis] + gauss(0.01);
      }
      boolean isOutlier = errs && axis == 0 && outlierAt > 0 && micros / 200_000L % outlierAt == 0;
      kept[axis] += isOutlier ? 3.0 : 0.0;
      m.set(SensedQuantity.BODY_VELOCITY, axis, kept[axis], 0.02);
    }
    filter.add(m);
  }

  private SourceReports.Standing standing(String source) {
    return filter.sources().at(Math.round(nowS * 1e6)).stream()
        .filter(report -> report.source().equals(source))
        .findFirst()
        .orElseThrow()
        .standing();
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.04, 0.1, -0.1, 0.3})
  void add_logWithVerticalError_depthGaugeIsFollowed(double mps) {
    errorMps = mps;
    dive(120.0);
    assertThat(worstM).isLessThan(0.2);
    assertThat(worstSigmas).isLessThan(6.0);
    assertThat(worstNorthSigmas).isLessThan(3.0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0, 0.01, -0.02})
  void add_frozenLog_errorsStayWithinTheirSigmas(double mps2) {
    isFrozen = true;
    northMps2 = mps2;
    dive(60.0);
    assertThat(worstM).isLessThan(0.1);
    assertThat(worstSigmas).isLessThan(3.0);
    assertThat(worstNorthSigmas).isLessThan(3.0);
  }

  @Test
  void add_depthGaugeThatJumps_isFollowedWithinASecond() {
    jumpM = 1.0;
    dive(FAULT_S + 1.0);
    Estimate e = filter.at(Math.round(nowS * 1e6));
    assertThat(e.altitudeM() - altitudeM).isBetween(0.85, 1.15);
    assertThat(standing("Log")).isEqualTo(SourceReports.Standing.BIASED);
  }

  @Test
  void add_frozenDepthGauge_isNamedAndTheLogCarriesTheDepth() {
    isGaugeFrozen = true;
    waveM = 1.0;
    dive(50.0);
    assertThat(standing("Depth")).isEqualTo(SourceReports.Standing.FROZEN);
    assertThat(worstM).isLessThan(0.3);
  }

  @ParameterizedTest
  @ValueSource(ints = {7, 8, 12})
  void add_logWithOutliers_othersAreUsedAndItIsNamed(int nth) {
    outlierAt = nth;
    dive(300.0);
    assertThat(worstNorthSigmas).isLessThan(3.0);
    assertThat(filter.at(Math.round(nowS * 1e6)).velocitySigmaMps(0)).isLessThan(0.03);
    assertThat(standing("Log")).isEqualTo(SourceReports.Standing.GATED);
  }
}
