package org.u2sa.core.communication.limit;

import java.util.function.LongSupplier;
import org.u2sa.interfaces.time.Clock;

/** A part of a thread's time, given in small slices. Confined to that thread. */
public final class TimeShare {
  private final LongSupplier nowMicros;
  private final Allowance time; // [s]

  /**
   * Starts with a full slice.
   *
   * @param part of the time [0…1]
   * @param pieceS longest slice [s]; the work that exceeds it is finished
   */
  public TimeShare(double part, double pieceS, LongSupplier nowMicros) {
    this.nowMicros = nowMicros;
    time = Allowance.ofTime(part, pieceS, nowMicros.getAsLong());
  }

  /** Whether there is time now. */
  public boolean isOpen() {
    return time.isOpen(nowMicros.getAsLong());
  }

  /** Charges time that was used [s]. */
  public void take(double seconds) {
    time.take(seconds);
  }

  /** Runs work and charges its time, whether there is some or not. */
  public void run(Runnable work) {
    long before = nowMicros.getAsLong();
    try {
      work.run();
    } finally {
      take(Clock.seconds(nowMicros.getAsLong() - before));
    }
  }
}
