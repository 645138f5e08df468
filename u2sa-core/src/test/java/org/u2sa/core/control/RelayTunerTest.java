package org.u2sa.core.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class RelayTunerTest {
  private static final double STEP_S = 0.002;

  /**
   * 1 / (s + 1)³ has K_u = 8 and T_u = 2π/√3 = 3.63 s (Åström &amp; Hägglund 2006); relay feedback
   * sees the first harmonic only, hence the tolerance.
   */
  @Test
  void step_threeLags_findsUltimateGainAndPeriod() {
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
    assertThat(found.gain()).isCloseTo(8.0, within(1.2));
    assertThat(found.periodS()).isCloseTo(2.0 * Math.PI / Math.sqrt(3.0), within(0.3));
    assertThat(widest).isLessThan(0.25);
    assertThat(found.zieglerNicholsPid().gain()).isCloseTo(0.6 * found.gain(), within(1e-9));
    assertThat(found.tyreusLuybenPi().integralS()).isCloseTo(2.2 * found.periodS(), within(1e-9));
    assertThat(found)
        .hasToString(
            "ultimate gain "
                + String.format(
                    java.util.Locale.ROOT, "%.4g, period %.3g s", found.gain(), found.periodS()));
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
