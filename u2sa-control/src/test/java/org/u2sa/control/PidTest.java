package org.u2sa.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.service.handover.HandOver;

class PidTest {
  private static final double STEP_S = 0.001;
  private static final DoubleUnaryOperator UNLIMITED = u -> u;

  /** What a step response says. */
  private record Response(double overshoot, double settlingS, double last, double largestOutput) {}

  /** Three equal lags, 1 / (s + 1)³, the process of Åström's and Hägglund's examples. */
  private static Response stepOfThreeLags(
      Pid.Gains gains, DoubleUnaryOperator actuator, double seconds) {
    Pid pid = new Pid(gains);
    double[] lag = new double[3];
    double highest = 0.0;
    double settled = 0.0;
    double output = 0.0;
    for (double t = 0.0; t < seconds; t += STEP_S) {
      double u = pid.step(1.0, lag[2], STEP_S);
      double done = actuator.applyAsDouble(u);
      pid.attained(done, STEP_S);
      output = Math.max(output, u);
      lag[2] += STEP_S * (lag[1] - lag[2]);
      lag[1] += STEP_S * (lag[0] - lag[1]);
      lag[0] += STEP_S * (done - lag[0]);
      highest = Math.max(highest, lag[2]);
      settled = Math.abs(lag[2] - 1.0) > 0.02 ? t : settled;
    }
    return new Response(highest - 1.0, settled, lag[2], output);
  }

  private static Pid wound(Pid.Gains gains) {
    Pid pid = new Pid(gains);
    for (int i = 0; i < 1000; i++) {
      pid.attained(pid.step(1.0, 0.001 * i, STEP_S), STEP_S);
    }
    return pid;
  }

  @Test
  void gains_gainZero_switchesAllOffAtOnce() {
    Pid pid = wound(Pid.Gains.of(2.0, 0.5, 0.1));

    pid.gains(Pid.Gains.of(0.0, 0.5, 0.1));

    assertThat(pid.step(1.0, 0.0, STEP_S)).isZero();
    pid.attained(0.0, STEP_S);
    pid.gains(Pid.Gains.of(2.0, 0.5, 0.1));
    assertThat(pid.step(1.0, 1.0, 0.0)).isZero(); // nothing was kept meanwhile
  }

  @Test
  void gains_integralTimeZero_switchesTheIntegralOffAtOnce() {
    Pid pid = wound(Pid.Gains.of(2.0, 0.5, 0.0));

    pid.gains(Pid.Gains.of(2.0, 0.0, 0.0));

    assertThat(pid.step(1.0, 0.75, STEP_S)).isCloseTo(0.5, within(1e-12));
  }

  @Test
  void takeOver_switchedOff_putsOutNothing() {
    Pid before = wound(Pid.Gains.of(2.0, 0.5, 0.1));
    HandOver state = new HandOver("test");
    before.transfer(Transfer.saving(state), "SURGE");
    Pid pid = new Pid(Pid.Gains.of(0.0, 0.5, 0.1));

    pid.transfer(Transfer.restoring(state), "SURGE");
    assertThat(pid.step(1.0, 0.0, STEP_S)).isZero();
    pid.takeOver(3.0, 1.0, 0.0);
    assertThat(pid.step(1.0, 0.0, STEP_S)).isZero();
  }

  /**
   * P control of 1 / (s + 1)³ with gain K ends at K / (1 + K), and is stable up to K = 8 (Åström
   * &amp; Hägglund 2006, the ultimate gain of the process).
   */
  @ParameterizedTest
  @CsvSource({"1.0", "2.0", "4.0"})
  void step_proportional_endsWhereTheLoopGainSays(double gain) {
    Response response = stepOfThreeLags(Pid.Gains.of(gain, 0.0, 0.0), UNLIMITED, 60.0);

    assertThat(response.last()).isCloseTo(gain / (1.0 + gain), within(1e-3));
  }

  @Test
  void step_proportionalBeyondTheUltimateGain_isUnstable() {
    assertThat(stepOfThreeLags(Pid.Gains.of(7.5, 0.0, 0.0), UNLIMITED, 120.0).overshoot())
        .isLessThan(1.0);
    assertThat(stepOfThreeLags(Pid.Gains.of(8.5, 0.0, 0.0), UNLIMITED, 120.0).overshoot())
        .isGreaterThan(1.0);
  }

  /** Skogestad's rules (SIMC, J. Process Control 13 (2003)) for θ = τ₂/2 = 0.5: no error, calm. */
  @Test
  void step_piBySkogestad_settlesWithLittleOvershoot() {
    // 1/(s+1)³ ≈ e^(−1.5 s)/(1.5 s + 1) by the half rule; K = 1.5/(2·1.5), T_i = 1.5
    Response response = stepOfThreeLags(Pid.Gains.of(0.5, 1.5, 0.0), UNLIMITED, 60.0);

    assertThat(response.last()).isCloseTo(1.0, within(1e-3));
    assertThat(response.overshoot()).isBetween(0.0, 0.10);
    assertThat(response.settlingS()).isLessThan(15.0);
  }

  @Test
  void step_saturatedActuator_backCalculationKeepsTheOvershootSmall() {
    DoubleUnaryOperator weak = u -> Math.max(-1.2, Math.min(1.2, u));
    Pid.Gains gains = Pid.Gains.of(4.0, 3.0, 0.7);

    Response with = stepOfThreeLags(gains, weak, 60.0);
    Response without = windingUp(gains, weak);

    assertThat(with.last()).isCloseTo(1.0, within(0.01));
    assertThat(with.overshoot()).isLessThan(0.5 * without.overshoot());
  }

  private static Response windingUp(Pid.Gains gains, DoubleUnaryOperator actuator) {
    Pid pid = new Pid(gains);
    double[] lag = new double[3];
    double highest = 0.0;
    for (double t = 0.0; t < 60.0; t += STEP_S) {
      double u = pid.step(1.0, lag[2], STEP_S);
      pid.attained(u, STEP_S); // as if the actuator could do all
      lag[2] += STEP_S * (lag[1] - lag[2]);
      lag[1] += STEP_S * (lag[0] - lag[1]);
      lag[0] += STEP_S * (actuator.applyAsDouble(u) - lag[0]);
      highest = Math.max(highest, lag[2]);
    }
    return new Response(highest - 1.0, 0.0, lag[2], 0.0);
  }

  /**
   * Gain and phase against C(jω) = K (1 + 1/(jωT_i) + jωT_d / (1 + jωT_d/N)), Åström &amp; Hägglund
   * 2006, equation 3.20.
   */
  @ParameterizedTest
  @CsvSource({"0.1", "0.5", "1.0", "3.0", "10.0", "40.0"})
  void step_sineOfAFrequency_hasGainAndPhaseOfTheFormula(double omega) {
    double k = 2.0;
    double ti = 4.0;
    double td = 0.5;
    double n = 10.0;
    Pid pid = new Pid(new Pid.Gains(k, ti, td, n, 1.0));
    double dt = Math.min(2e-3, 0.002 / omega);
    long period = Math.round(2.0 * Math.PI / omega / dt);
    double inPhase = 0.0;
    double quadrature = 0.0;
    for (long i = 0; i < 2 * period; i++) {
      double angle = 2.0 * Math.PI * i / period;
      double u = pid.step(0.0, -Math.sin(angle), dt);
      pid.attained(u, dt);
      if (i >= period) {
        inPhase += 2.0 * u * Math.sin(angle) / period;
        quadrature += 2.0 * u * Math.cos(angle) / period;
      }
    }
    double x = omega * td / n;
    double real = k * (1.0 + omega * td * x / (1.0 + x * x));
    double imaginary = k * (-1.0 / (omega * ti) + omega * td / (1.0 + x * x));
    double size = Math.hypot(real, imaginary);
    assertThat(inPhase).isCloseTo(real, within(0.01 * size));
    assertThat(quadrature).isCloseTo(imaginary, within(0.01 * size));
  }

  @Test
  void step_setpointJumps_derivativeDoesNotKick() {
    Pid pid = new Pid(Pid.Gains.of(1.0, 0.0, 5.0));
    pid.step(0.0, 0.0, 0.01);

    assertThat(pid.step(1.0, 0.0, 0.01)).isCloseTo(1.0, within(1e-9));
  }

  @Test
  void takeOver_fromAnotherLaw_nextOutputIsTheOldOne() {
    Pid pid = new Pid(Pid.Gains.of(3.0, 2.0, 0.4));

    pid.takeOver(7.0, 1.0, 0.25);

    assertThat(pid.step(1.0, 0.25, 0.02)).isCloseTo(7.0, within(1e-9));
  }

  /** A fall that the other law did nothing about. */
  @Test
  void takeOverMotion_awayFromTheSetpoint_brakesInProportionAtOnce() {
    Pid pid = new Pid(Pid.Gains.of(3.0, 2.0, 0.0));

    pid.takeOverMotion(0.0, -1.0, 4.0);

    assertThat(pid.step(-1.0, 4.0, 0.02)).isCloseTo(-15.0, within(1e-9));
  }

  @Test
  void takeOverMotion_otherLawBrakesHarder_continuesItsOutput() {
    Pid pid = new Pid(Pid.Gains.of(3.0, 2.0, 0.0));

    pid.takeOverMotion(-20.0, 0.0, 4.0);

    assertThat(pid.step(0.0, 4.0, 0.02)).isCloseTo(-20.0, within(1e-9));
  }

  /** The output against a steady wind is kept. */
  @Test
  void takeOverMotion_slightlyTooFastInADisturbance_keepsTheRestOfTheOutput() {
    Pid pid = new Pid(Pid.Gains.of(3.0, 2.0, 0.0));

    pid.takeOverMotion(2.0, 1.0, 1.1);

    assertThat(pid.step(1.0, 1.1, 0.02)).isCloseTo(2.0 - 0.3, within(1e-9));
  }

  @Test
  void takeOverMotion_slowerThanTheSetpoint_nextOutputIsTheOldOne() {
    Pid pid = new Pid(Pid.Gains.of(3.0, 2.0, 0.4));

    pid.takeOverMotion(7.0, 1.0, 0.25);

    assertThat(pid.step(1.0, 0.25, 0.02)).isCloseTo(7.0, within(1e-9));
  }

  @Test
  void step_afterAGap_neitherIntegratesNorDifferentiates() {
    Pid pid = new Pid(Pid.Gains.of(1.0, 1.0, 1.0));
    pid.step(1.0, 0.0, 0.0);
    pid.attained(1.0, 0.0);

    assertThat(pid.step(1.0, 0.5, 0.0)).isCloseTo(0.5, within(1e-9));
  }

  @Test
  void gains_outOfRange_areRefusedByName() {
    assertThatThrownBy(() -> Pid.Gains.of(-1.0, 0.0, 0.0)).hasMessageContaining("PID gain: -1.0");
    assertThatThrownBy(() -> new Pid.Gains(1.0, 0.0, 0.0, 1.0, 1.0))
        .hasMessageContaining("derivative filter");
  }
}
