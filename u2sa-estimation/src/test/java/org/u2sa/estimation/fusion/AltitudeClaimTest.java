package org.u2sa.estimation.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;

/** Gauges and barometers with a constant error, of which repeated readings say nothing. */
class AltitudeClaimTest {
  private final Random random = new Random(2);
  private final Measurement m = new Measurement();

  private Estimate after(ErrorStateFilter filter, double seconds, String gauge, double sigma) {
    for (int i = 1; i <= seconds * 10; i++) {
      long micros = filter.micros() + 100_000L;
      filter.add(m.begin("Compass", micros).heading(0.01 * random.nextGaussian(), 0.01));
      filter.add(m.begin("GPS", micros).velocity(0.0, 0.0, 0.0, 0.01));
      m.begin(gauge, micros);
      filter.add(m.altitude(-3.0 + 0.01 * random.nextGaussian(), sigma));
    }
    return filter.at(filter.micros());
  }

  @ParameterizedTest
  @EnumSource(MotionDomain.class)
  void positionSigmaM_onlyOnePressure_staysAtItsClaim(MotionDomain domain) {
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(domain));
    Estimate e = after(filter, 300.0, "Depth", 0.1);
    assertThat(e.positionSigmaM(2)).isBetween(0.098, 0.13);
  }

  @Test
  void positionSigmaM_pressureInLocalFrame_staysAtItsClaim() {
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.UNDERWATER));
    for (int i = 1; i <= 1_000; i++) {
      m.begin("Depth", i * 100_000L);
      m.set(SensedQuantity.LOCAL_DOWN, 0, 3.0 + 0.01 * random.nextGaussian(), 0.1);
      filter.add(m);
    }
    assertThat(filter.at(filter.micros()).positionSigmaM(2)).isBetween(0.099, 0.12);
  }

  @Test
  void positionSigmaM_twoPressures_isThatOfTheirMean() {
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.AIR));
    for (int i = 0; i < 1_000; i++) {
      after(filter, 0.1, "one", 3.0);
      after(filter, 0.1, "other", 3.0);
    }
    double mean = 3.0 / Math.sqrt(2.0);
    assertThat(filter.at(filter.micros()).positionSigmaM(2)).isBetween(0.99 * mean, 1.2 * mean);
  }

  @Test
  void positionSigmaM_gaugeFallsSilent_growsFromItsClaim() {
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.UNDERWATER));
    after(filter, 100.0, "Depth", 0.1);
    double later = filter.at(filter.micros() + 5_000_000L).positionSigmaM(2);
    assertThat(later).isGreaterThan(0.2);
  }

  @Test
  void hasAltitude_barometerWithUnknownSeaLevelPressure_isTrue() {
    ErrorStateFilter filter = new ErrorStateFilter(FilterTuning.of(MotionDomain.AIR));
    Estimate e = after(filter, 600.0, "Barometer", 100.0);
    assertThat(e.positionSigmaM(2)).isGreaterThan(90.0);
    assertThat(e.hasAltitude()).isTrue();
  }
}
