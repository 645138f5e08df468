package org.u2sa.vision.ground;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;

/** Recent roll and pitch of the vehicle, for looking up the attitude at exposure. */
public final class AttitudeHistory {
  private static final int LENGTH = 64;
  private static final long STALE_MICROS = Clock.micros(1.0);

  private final long[] micros = new long[LENGTH];
  private final double[] rolls = new double[LENGTH];
  private final double[] pitches = new double[LENGTH];
  private long count; // an int would overflow after eight months at 100 Hz

  /**
   * Adds a state; ignored if it lacks time, roll or pitch, or is older than the last. If a state is
   * older by more than a second, the clock was set back, and the history starts over.
   */
  public void add(StateInformation state) {
    if (!state.timestamp().isPresent()
        || state.referenceFrame().isBody()
        || !state.phi().isPresent()
        || !state.theta().isPresent()) {
      return;
    }
    long at = state.timestamp().orElseThrow();
    if (count > 0 && at <= micros[slot(count - 1)]) {
      if (micros[slot(count - 1)] - at <= STALE_MICROS) {
        return;
      }
      count = 0;
    }
    boolean isNoseDown = state.referenceFrame().equals(ReferenceFrame.LOCAL_ENU);
    int here = slot(count);
    micros[here] = at;
    rolls[here] = state.phi().getAsDouble();
    pitches[here] = (isNoseDown ? -1.0 : 1.0) * state.theta().getAsDouble();
    count++;
  }

  /** Roll, right side down positive [rad]; 0 if unknown at that time. */
  public double roll(long atMicros) {
    return at(rolls, atMicros);
  }

  /** Pitch, front up positive [rad]; 0 if unknown at that time. */
  public double pitch(long atMicros) {
    return at(pitches, atMicros);
  }

  /** Interpolates between the states around a time; clamps to the first and last. */
  private double at(double[] values, long atMicros) {
    long oldest = Math.max(0L, count - LENGTH);
    for (long i = count - 1; i >= oldest; i--) {
      int here = slot(i);
      if (micros[here] <= atMicros) {
        if (i == count - 1) {
          return atMicros - micros[here] > STALE_MICROS ? 0.0 : values[here];
        }
        int next = slot(i + 1);
        double share = (double) (atMicros - micros[here]) / (micros[next] - micros[here]);
        return values[here] + share * (values[next] - values[here]);
      }
    }
    return count == 0 || micros[slot(oldest)] - atMicros > STALE_MICROS
        ? 0.0
        : values[slot(oldest)];
  }

  private static int slot(long number) {
    return (int) (number % LENGTH);
  }
}
