package org.u2sa.sim.ioio;

/**
 * Pulse input of a motor controller or servo: 1000 to 2000 µs, centred at 1500, with a fail-safe
 * after 0.1 s without pulses. A new width takes effect with its next pulse. Not thread-safe.
 */
public final class ServoInput {
  private static final double LOWEST_S = 1.0e-3;
  private static final double NEUTRAL_S = 1.5e-3;
  private static final double RANGE_S = 1.0e-3;
  private static final double HALF_RANGE_S = 0.5e-3;
  private static final double SHORTEST_S = 0.8e-3; // shorter pulses are noise
  private static final double LONGEST_S = 2.2e-3;
  private static final long FAILSAFE_US = 100_000;
  private static final double US_PER_S = 1e6;

  private final boolean isOneWay;
  private PulseTrain pulses = PulseTrain.NONE;
  private boolean seen;
  private long lastUs;
  private long nextUs;
  private double command = Double.NaN;

  /**
   * @param isOneWay whether commands are 0…1, with 0 at 1000 µs; otherwise −1…1
   */
  public ServoInput(boolean isOneWay) {
    this.isOneWay = isOneWay;
  }

  /** Sets the pulses from the given time on [µs]. */
  public void take(PulseTrain train, long nowUs) {
    if (!pulses.present() && train.present()) {
      nextUs = nowUs + Math.round(train.widthS() * US_PER_S);
    }
    pulses = train;
  }

  /** Current command; NaN without pulses. */
  public double command(long nowUs) {
    if (pulses.present() && nowUs >= nextUs) {
      nextUs = nowUs + Math.round(pulses.periodS() * US_PER_S);
      if (pulses.widthS() >= SHORTEST_S && pulses.widthS() <= LONGEST_S) {
        command = valueOf(pulses.widthS());
        seen = true;
        lastUs = nowUs;
      }
    }
    if (!seen || nowUs - lastUs > FAILSAFE_US) {
      seen = false;
      command = Double.NaN;
    }
    return command;
  }

  private double valueOf(double widthS) {
    double value = isOneWay ? (widthS - LOWEST_S) / RANGE_S : (widthS - NEUTRAL_S) / HALF_RANGE_S;
    return Math.max(isOneWay ? 0.0 : -1.0, Math.min(1.0, value));
  }
}
