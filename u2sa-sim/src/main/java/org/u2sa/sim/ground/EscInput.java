package org.u2sa.sim.ground;

import org.u2sa.sim.ioio.PulseTrain;

/**
 * Where a motor controller, or a servo, takes its pulses: 1000 to 2000 µs about 1500, and a
 * fail-safe after 0.1 s without any. A new width counts from its next pulse on.
 */
final class EscInput {
  private static final double NEUTRAL_S = 1.5e-3;
  private static final double HALF_RANGE_S = 0.5e-3;
  private static final double SHORTEST_S = 0.8e-3; // others are noise
  private static final double LONGEST_S = 2.2e-3;
  private static final long FAILSAFE_US = 100_000;
  private static final double US_PER_S = 1e6;

  private PulseTrain pulses = PulseTrain.NONE;
  private boolean seen;
  private long lastUs;
  private long nextUs;
  private double command = Double.NaN;

  /** Pulses that come from now on. */
  void take(PulseTrain train, long nowUs) {
    if (!pulses.present() && train.present()) {
      nextUs = nowUs + Math.round(train.widthS() * US_PER_S);
    }
    pulses = train;
  }

  /** The command that holds now, −1…1; NaN if pulses are missing. */
  double command(long nowUs) {
    if (pulses.present() && nowUs >= nextUs) {
      nextUs = nowUs + Math.round(pulses.periodS() * US_PER_S);
      if (pulses.widthS() >= SHORTEST_S && pulses.widthS() <= LONGEST_S) {
        double wanted = (pulses.widthS() - NEUTRAL_S) / HALF_RANGE_S;
        command = Math.max(-1.0, Math.min(1.0, wanted));
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
}
