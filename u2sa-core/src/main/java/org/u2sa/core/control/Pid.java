package org.u2sa.core.control;

import org.u2sa.service.HandOver;

/**
 * A PID controller in parallel form, with filtered derivative of the measurement, set-point weight,
 * anti-windup by back-calculation, and bumpless take-over:
 *
 * <p>u = K (b r − y) + I − K T_d s / (1 + s T_d / N) y, dI/dt = K / T_i (r − y) + (u_attained − u)
 * / T_t
 *
 * <p>Åström &amp; Hägglund: Advanced PID Control (2006), sections 3.3–3.5; the discrete form is
 * that of Åström &amp; Wittenmark: Computer-Controlled Systems (3rd ed.), section 8.4: forward
 * difference for the integral, backward difference for the derivative. For one thread.
 */
public final class Pid {
  /**
   * Gains.
   *
   * @param gain K, output by error; 0 switches all off
   * @param integralS T_i [s]; 0: no integral
   * @param derivativeS T_d [s]; 0: no derivative
   * @param filter N, how many times faster than T_d the derivative's filter is, 2…100
   * @param setpointWeight b, share of the set point in the proportional part, 0…1
   */
  public record Gains(
      double gain, double integralS, double derivativeS, double filter, double setpointWeight) {
    private static final double USUAL_FILTER = 10.0;

    /**
     * @throws IllegalArgumentException if a value is outside its range
     */
    public Gains {
      require("gain", gain, 0.0, Double.MAX_VALUE);
      require("integral time", integralS, 0.0, Double.MAX_VALUE);
      require("derivative time", derivativeS, 0.0, Double.MAX_VALUE);
      require("derivative filter", filter, 2.0, 100.0);
      require("set-point weight", setpointWeight, 0.0, 1.0);
    }

    /** With the usual filter (10) and the full set point in the proportional part. */
    public static Gains of(double gain, double integralS, double derivativeS) {
      return new Gains(gain, integralS, derivativeS, USUAL_FILTER, 1.0);
    }

    private static void require(String name, double value, double lowest, double highest) {
      if (!(value >= lowest && value <= highest)) {
        throw new IllegalArgumentException(
            "PID " + name + ": " + value + " is outside " + lowest + "…" + highest);
      }
    }
  }

  private Gains gains;
  private double integral;
  private double derivative;
  private double measuredBefore = Double.NaN;
  private double output;
  private double pending; // I's growth by the error, due at the next step

  /** At rest. */
  public Pid(Gains gains) {
    this.gains = gains;
  }

  /**
   * Goes on with other gains; the output does not jump by the integral. What is switched off is
   * forgotten.
   */
  public void gains(Gains newGains) {
    gains = newGains;
    forgetSwitchedOff();
  }

  private void forgetSwitchedOff() {
    boolean isOff = gains.gain == 0.0;
    if (isOff || gains.integralS == 0.0) {
      integral = 0.0;
      pending = 0.0;
    }
    if (isOff || gains.derivativeS == 0.0) {
      derivative = 0.0;
    }
  }

  /**
   * The output for a measurement.
   *
   * @param setpoint wanted
   * @param measured in the same unit
   * @param stepS since the call before [s]; 0: at the first one or after a gap: neither integral
   *     nor derivative move
   */
  public double step(double setpoint, double measured, double stepS) {
    if (stepS > 0.0 && !Double.isNaN(measuredBefore) && gains.derivativeS > 0.0) {
      double filterS = gains.derivativeS / gains.filter;
      derivative =
          (filterS * derivative - gains.gain * gains.derivativeS * (measured - measuredBefore))
              / (filterS + stepS);
    }
    measuredBefore = measured;
    output = gains.gain * (gains.setpointWeight * setpoint - measured) + integral + derivative;
    pending =
        gains.integralS > 0.0 ? gains.gain * stepS / gains.integralS * (setpoint - measured) : 0.0;
    return output;
  }

  /**
   * Takes note of what became of the output, once after each {@link #step}: where actuators
   * saturate, the integral follows them, with a tracking time of √(T_i T_d), or T_i / 2 without a
   * derivative.
   *
   * @param attained what the actuators do of the output, in its unit
   */
  public void attained(double attained, double stepS) {
    integral += pending;
    pending = 0.0;
    if (gains.gain > 0.0 && gains.integralS > 0.0) {
      double trackingS =
          gains.derivativeS > 0.0
              ? Math.sqrt(gains.integralS * gains.derivativeS)
              : 0.5 * gains.integralS;
      integral += Math.min(1.0, stepS / trackingS) * (attained - output);
    } else {
      integral = 0.0;
    }
  }

  /**
   * Chooses the integral so that the next output is this one: takes over without a bump. Without an
   * integral, only the next output is.
   */
  public void takeOver(double wantedOutput, double setpoint, double measured) {
    derivative = 0.0;
    pending = 0.0;
    measuredBefore = measured;
    double proportional = gains.gain * (gains.setpointWeight * setpoint - measured);
    integral = gains.gain > 0.0 ? wantedOutput - proportional : 0.0;
  }

  /** Forgets all. */
  public void reset() {
    integral = 0.0;
    derivative = 0.0;
    pending = 0.0;
    measuredBefore = Double.NaN;
  }

  /** Writes down what was learnt, under a name. */
  public void handOver(HandOver state, String name) {
    state.number(name + " INTEGRAL", integral).number(name + " DERIVATIVE", derivative);
    if (!Double.isNaN(measuredBefore)) {
      state.number(name + " MEASURED", measuredBefore);
    }
  }

  /** Goes on from what {@link #handOver} wrote. */
  public void takeOver(HandOver state, String name) {
    integral = state.number(name + " INTEGRAL").orElse(0.0);
    derivative = state.number(name + " DERIVATIVE").orElse(0.0);
    measuredBefore = state.number(name + " MEASURED").orElse(Double.NaN);
    forgetSwitchedOff();
  }
}
