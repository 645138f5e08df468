package org.u2sa.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayDeque;
import java.util.Collections;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RelayTunerTest {
  private static final double STEP_S = 0.002;

  /**
   * 1 / (s + 1)³ has K_u = 8 and T_u = 2π/√3 = 3.628 s. Under a relay with hysteresis it oscillates
   * as Tsypkin's locus says, Σ Im G(i k ω) / k = −π ε / (4 d) over odd k: period 3.838 s, amplitude
   * 0.0897, so the gain of its first harmonic is 7.111 (Tsypkin: Relay Control Systems, 1984).
   */
  @Test
  void step_threeLags_oscillatesAsTsypkinsLocusSays() {
    RelayTuner tuner = new RelayTuner(0.5, 0.005, 100.0);
    double[] lag = new double[3];
    double widest = 0.0;
    for (double t = 0.0; t < 100.0 && tuner.found().isEmpty(); t += STEP_S) {
      double u = tuner.step(lag[2], STEP_S);
      assertThat(Math.abs(u)).isEqualTo(0.5);
      lag[2] += STEP_S * (lag[1] - lag[2]);
      lag[1] += STEP_S * (lag[0] - lag[1]);
      lag[0] += STEP_S * (u - lag[0]);
      widest = Math.max(widest, Math.abs(lag[2]));
    }

    RelayTuner.Found found = tuner.found().orElseThrow();
    assertThat(found.gain()).isCloseTo(7.111, withinPercentage(1.0));
    assertThat(found.periodS()).isCloseTo(3.838, withinPercentage(0.5));
    assertThat(found.gain()).as("K_u, by the first harmonic").isCloseTo(8.0, within(1.0));
    assertThat(widest).isLessThan(0.25);
    assertThat(found.zieglerNicholsPid().gain()).isCloseTo(0.6 * found.gain(), within(1e-9));
    assertThat(found.tyreusLuybenPi().integralS()).isCloseTo(2.2 * found.periodS(), within(1e-9));
    assertThat(found)
        .hasToString(
            "ultimate gain "
                + String.format(
                    java.util.Locale.ROOT, "%.4g, period %.3g s", found.gain(), found.periodS()));
  }

  /**
   * A lag with dead time swings under an ideal relay by a = K d (1 − e^(−L/T)) with the period 2 T
   * ln(2 e^(L/T) − 1), exactly (Wang, Hang &amp; Zou, Ind. Eng. Chem. Res. 36 (1997) 2197).
   */
  @ParameterizedTest
  @CsvSource({"0.2", "1.0", "2.0"})
  void step_lagWithDeadTime_oscillatesAsTheClosedFormSays(double deadS) {
    RelayTuner tuner = new RelayTuner(2.0, 0.0, 200.0);
    double lagS = 1.0;
    double plantGain = 1.5;
    double keeps = Math.exp(-STEP_S / lagS);
    ArrayDeque<Double> late = new ArrayDeque<>();
    // one step less: what is measured at a step acts from the next one on
    late.addAll(Collections.nCopies((int) Math.round(deadS / STEP_S) - 1, 0.0));
    double y = 0.0;
    while (tuner.found().isEmpty() && !tuner.hasFailed()) {
      late.add(tuner.step(y, STEP_S));
      y = keeps * y + (1.0 - keeps) * plantGain * late.remove();
    }

    double amplitude = plantGain * 2.0 * (1.0 - Math.exp(-deadS / lagS));
    double periodS = 2.0 * lagS * Math.log(2.0 * Math.exp(deadS / lagS) - 1.0);
    RelayTuner.Found found = tuner.found().orElseThrow();
    assertThat(found.gain()).isCloseTo(4.0 * 2.0 / (Math.PI * amplitude), withinPercentage(1.0));
    assertThat(found.periodS()).isCloseTo(periodS, withinPercentage(1.0));
  }

  @Test
  void step_nothingMoves_givesUpInTime() {
    RelayTuner tuner = new RelayTuner(1.0, 0.01, 5.0);

    for (int i = 0; i < 51; i++) {
      tuner.step(0.0, 0.1);
    }

    assertThat(tuner.hasFailed()).isTrue();
    assertThatThrownBy(() -> new RelayTuner(0.0, 0.0, 1.0)).hasMessageContaining("amplitude 0.0");
  }
}
