package org.u2sa.control;

/**
 * A PID controller in parallel form, with filtered derivative on measurement, set-point weighting,
 * back-calculation anti-windup and bumpless transfer:
 *
 * <p>u = K (b r − y) + I − K T_d s / (1 + s T_d / N) y, dI/dt = K / T_i (r − y) + (u_attained − u)
 * / T_t
 *
 * <p>Åström &amp; Hägglund: Advanced PID Control (2006), sections 3.3–3.5; the discrete form is
 * that of Åström &amp; Wittenmark: Computer-Controlled Systems (3rd ed.), section 8.4: forward
 * difference for the integral, backward difference for the derivative. Not thread-safe.
 */
public final class Pid {
  /**
   * Gains.
   *
   * @param gain K, output per error; 0 disables the controller
   * @param integralS T_i [s]; 0: no integral
   * @param derivativeS T_d [s]; 0: no derivative
   * @param filter N, ratio of T_d to the time constant of the derivative filter, 2…100
   * @param setpointWeight b, set-point weight of the proportional part, 0…1
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

    /** Gains with the usual filter (N = 10) and full set-point weight. */
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
  private double pending; // error part of I's increment, applied at the next step

  /** Creates a controller at rest. */
  public Pid(Gains gains) {
    this.gains = gains;
  }

  /**
   * Replaces the gains; the integral does not make the output jump. States of disabled parts are
   * reset.
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
   * Computes the output for a measurement.
   *
   * @param setpoint set point
   * @param measured in the same unit
   * @param stepS time since the previous call [s]; 0 on the first call or after a gap: integral and
   *     derivative are held
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
   * Reports the attained output, once after each {@link #step}: when actuators saturate, the
   * integral tracks them with a tracking time of √(T_i T_d), or T_i / 2 without a derivative.
   *
   * @param attained output the actuators achieve, in the unit of the output
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
   * Sets the integral so that the next output is the given one (bumpless transfer). Without an
   * integral, only the next output is affected.
   */
  public void takeOver(double wantedOutput, double setpoint, double measured) {
    derivative = 0.0;
    pending = 0.0;
    measuredBefore = measured;
    double proportional = gains.gain * (gains.setpointWeight * setpoint - measured);
    integral = gains.gain > 0.0 ? wantedOutput - proportional : 0.0;
  }

  /**
   * Takes over the control of a velocity or rate as {@link #takeOver} does, but brakes a motion
   * that is faster than the set point, or leads away from it, at once, in proportion to the error.
   * Otherwise the integral would hold the motion until it has taken in the error.
   */
  public void takeOverMotion(double wantedOutput, double setpoint, double measured) {
    takeOver(wantedOutput, setpoint, measured);
    double error = setpoint - measured;
    if (gains.integralS > 0.0 && error * measured < 0.0) {
      double towards = Math.signum(error);
      double against = Math.max(0.0, -towards * integral);
      integral += towards * Math.min(against, gains.gain * Math.abs(error));
    }
  }

  /** Integral part of the output: the response to a steady disturbance. */
  public double integral() {
    return integral;
  }

  /** Changes the integral by a part of the disturbance that is known to have changed. */
  public void disturb(double change) {
    integral += gains.gain > 0.0 && gains.integralS > 0.0 ? change : 0.0;
  }

  /** Resets all states. */
  public void reset() {
    integral = 0.0;
    derivative = 0.0;
    pending = 0.0;
    measuredBefore = Double.NaN;
  }

  /** Saves or restores the learnt state under a name. */
  public void transfer(Transfer state, String name) {
    integral = state.number(name + " INTEGRAL", integral);
    derivative = state.number(name + " DERIVATIVE", derivative);
    measuredBefore = state.number(name + " MEASURED", measuredBefore, Double.NaN);
    if (state.isRestoring()) {
      forgetSwitchedOff();
    }
  }
}
