package org.u2sa.sim.atmosphere;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class DrydenGustsTest {
  private static final double SPAN_M = 10.97;
  private static final double SIGMA = 1.5;
  private static final double SPEED = 50.0;
  private static final double FOOT = 0.3048;
  private static final int SAMPLES = 400_000;

  @ParameterizedTest
  @ValueSource(doubles = {100.0, 300.0, 1_000.0, 4_000.0})
  void step_long_hasTheSpecifiedVariances(double heightFt) {
    // MIL-F-8785C, 3.7.3: σu = σv = σw / (0.177 + 0.000823 h)^0.4 up to 1000 ft, there all equal
    double shape = Math.pow(0.177 + 0.000823 * Math.min(1_000.0, heightFt), 0.4);
    double dt = 0.1;
    assertThat(deviation(heightFt, dt, DrydenGusts::downMps))
        .isCloseTo(SIGMA, within(0.08 * SIGMA));
    assertThat(deviation(heightFt, dt, DrydenGusts::forwardMps) * shape)
        .isCloseTo(SIGMA, within(0.08 * SIGMA));
    assertThat(deviation(heightFt, dt, DrydenGusts::rightMps) * shape)
        .isCloseTo(SIGMA, within(0.08 * SIGMA));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.01, 0.05, 0.5})
  void step_anyStep_varianceIsTheSame(double dtS) {
    assertThat(deviation(1_000.0, dtS, DrydenGusts::downMps)).isCloseTo(SIGMA, within(0.1 * SIGMA));
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.25, 0.5, 1.0, 2.0})
  void step_long_correlatesAsTheDrydenSpectraSay(double scales) {
    // The spectra's transforms over x = V t / L: exp(−x) along, exp(−x) (1 − x/2) across
    // (MIL-HDBK-1797, appendix)
    double scale = 1_000.0 * FOOT;
    double dt = scale * scales / SPEED / 20;
    double along = correlation(dt, 20, DrydenGusts::forwardMps);
    double down = correlation(dt, 20, DrydenGusts::downMps);
    double right = correlation(dt, 20, DrydenGusts::rightMps);
    assertThat(along).isCloseTo(Math.exp(-scales), within(0.05));
    assertThat(down).isCloseTo(Math.exp(-scales) * (1.0 - scales / 2.0), within(0.05));
    assertThat(right).isCloseTo(Math.exp(-scales) * (1.0 - scales / 2.0), within(0.05));
  }

  @Test
  void step_long_rollGustHasTheVarianceOfItsSpectrum() {
    // Φp integrated: σw²/(V L) · 0.8 (πL/4b)^{1/3} / (1 + (4bω/πV)²) over ω from 0 (MIL-F-8785C,
    // 3.7.1.2)
    double scale = 1_000.0 * FOOT;
    double area = 0.0;
    double step = 0.01;
    for (double omega = step / 2; omega < 2_000.0; omega += step) {
      double lag = 4.0 * SPAN_M * omega / (Math.PI * SPEED);
      area += step / (1.0 + lag * lag);
    }
    double variance =
        SIGMA * SIGMA / (SPEED * scale) * 0.8 * Math.cbrt(Math.PI * scale / (4.0 * SPAN_M)) * area;
    double measured = deviation(1_000.0, 0.05, DrydenGusts::rollRadPerS);
    assertThat(measured).isCloseTo(Math.sqrt(variance), within(0.05 * Math.sqrt(variance)));
  }

  @Test
  void step_sameSeed_sameGustsAndOtherSeedOthers() {
    assertThat(after(7L)).isEqualTo(after(7L)).isNotEqualTo(after(8L));
  }

  @Test
  void step_sigmaZero_isCalm() {
    DrydenGusts gusts = new DrydenGusts(0.0, SPAN_M, 1L);
    gusts.step(0.1, 100.0, SPEED);
    assertThat(gusts.forwardMps()).isZero();
    assertThat(gusts.downMps()).isZero();
    assertThat(gusts.rollRadPerS()).isZero();
  }

  private static double after(long seed) {
    DrydenGusts gusts = new DrydenGusts(SIGMA, SPAN_M, seed);
    for (int i = 0; i < 100; i++) {
      gusts.step(0.01, 100.0, SPEED);
    }
    return gusts.downMps();
  }

  private static double deviation(
      double heightFt, double dtS, ToDoubleFunction<DrydenGusts> component) {
    double[] samples = samples(heightFt, dtS, component);
    double sum = 0.0;
    for (double sample : samples) {
      sum += sample * sample;
    }
    return Math.sqrt(sum / samples.length);
  }

  private static double correlation(double dtS, int lag, ToDoubleFunction<DrydenGusts> component) {
    double[] samples = samples(1_000.0, dtS, component);
    double own = 0.0;
    double shifted = 0.0;
    for (int i = lag; i < samples.length; i++) {
      own += samples[i] * samples[i];
      shifted += samples[i] * samples[i - lag];
    }
    return shifted / own;
  }

  private static double[] samples(
      double heightFt, double dtS, ToDoubleFunction<DrydenGusts> component) {
    DrydenGusts gusts = new DrydenGusts(SIGMA, SPAN_M, 42L);
    double[] samples = new double[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
      gusts.step(dtS, heightFt * FOOT, SPEED);
      samples[i] = component.applyAsDouble(gusts);
    }
    return samples;
  }
}
