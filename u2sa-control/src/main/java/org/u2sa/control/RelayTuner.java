package org.u2sa.control;

import java.util.Locale;
import java.util.Optional;

/**
 * Finds a loop's ultimate gain and period by relay feedback: a relay with hysteresis makes the loop
 * oscillate with a bounded amplitude, K_u = 4 d / (π √(a² − ε²)).
 *
 * <p>Åström &amp; Hägglund: Automatic tuning of simple regulators with specifications on phase and
 * amplitude margins, Automatica 20 (1984) 5. Not thread-safe.
 */
public final class RelayTuner {
  private static final int AGREEING = 3; // consecutive periods that must agree
  private static final double ALIKE = 0.1; // tolerance of their agreement

  private final double amplitude;
  private final double hysteresis;
  private final double limitS;
  private double setpoint = Double.NaN;
  private boolean high = true;
  private double timeS;
  private double switchedUpS = Double.NaN;
  private double highest = Double.NEGATIVE_INFINITY;
  private double lowest = Double.POSITIVE_INFINITY;
  private double periodS = Double.NaN;
  private double swing = Double.NaN;
  private int agreeing;
  private Optional<Found> found = Optional.empty();

  /**
   * The loop at its limit of stability.
   *
   * @param gain K_u, output per measurement
   * @param periodS T_u [s]
   */
  public record Found(double gain, double periodS) {
    /** PI gains by Tyreus &amp; Luyben, Ind. Eng. Chem. Res. 31 (1992): smooth and robust. */
    public Pid.Gains tyreusLuybenPi() {
      return Pid.Gains.of(gain / 3.2, 2.2 * periodS, 0.0);
    }

    /** PID gains by Tyreus &amp; Luyben. */
    public Pid.Gains tyreusLuybenPid() {
      return Pid.Gains.of(gain / 2.2, 2.2 * periodS, periodS / 6.3);
    }

    /** PID gains by Ziegler &amp; Nichols, Trans. ASME 64 (1942): fast, quarter-amplitude decay. */
    public Pid.Gains zieglerNicholsPid() {
      return Pid.Gains.of(0.6 * gain, 0.5 * periodS, 0.125 * periodS);
    }

    /** Human-readable summary. */
    @Override
    public String toString() {
      return String.format(Locale.ROOT, "ultimate gain %.4g, period %.3g s", gain, periodS);
    }
  }

  /**
   * @param amplitude relay amplitude d of the output, above 0
   * @param hysteresis hysteresis ε of the measurement, 0 or more: choose it above the noise
   * @param limitS timeout [s]
   */
  public RelayTuner(double amplitude, double hysteresis, double limitS) {
    if (!(amplitude > 0.0) || !(hysteresis >= 0.0) || !(limitS > 0.0)) {
      throw new IllegalArgumentException(
          "relay: amplitude "
              + amplitude
              + ", hysteresis "
              + hysteresis
              + ", limit "
              + limitS
              + " s: expected numbers above 0");
    }
    this.amplitude = amplitude;
    this.hysteresis = hysteresis;
    this.limitS = limitS;
  }

  /**
   * Computes the relay output: ± the amplitude.
   *
   * @param measured controlled variable; oscillates about its first value
   */
  public double step(double measured, double stepS) {
    setpoint = Double.isNaN(setpoint) ? measured : setpoint;
    timeS += stepS;
    double error = setpoint - measured;
    highest = Math.max(highest, measured);
    lowest = Math.min(lowest, measured);
    if (high && error < -hysteresis) {
      high = false;
    } else if (!high && error > hysteresis) {
      high = true;
      endOfPeriod();
    }
    return high ? amplitude : -amplitude;
  }

  private void endOfPeriod() {
    double period = timeS - switchedUpS;
    double nowSwing = 0.5 * (highest - lowest);
    boolean isAlike =
        Math.abs(period - periodS) < ALIKE * period
            && Math.abs(nowSwing - swing) < ALIKE * nowSwing;
    agreeing = isAlike ? agreeing + 1 : 0;
    if (agreeing >= AGREEING && found.isEmpty()) {
      double meanPeriod = 0.5 * (period + periodS);
      double size = 0.5 * (nowSwing + swing);
      double beyond = Math.sqrt(Math.max(1e-12, size * size - hysteresis * hysteresis));
      found = Optional.of(new Found(4.0 * amplitude / (Math.PI * beyond), meanPeriod));
    }
    periodS = period;
    swing = nowSwing;
    switchedUpS = timeS;
    highest = Double.NEGATIVE_INFINITY;
    lowest = Double.POSITIVE_INFINITY;
  }

  /** Result; empty until enough consecutive periods agree. */
  public Optional<Found> found() {
    return found;
  }

  /** Whether it timed out without a result. */
  public boolean hasFailed() {
    return found.isEmpty() && timeS >= limitS;
  }
}
