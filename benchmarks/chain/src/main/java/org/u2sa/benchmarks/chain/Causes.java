package org.u2sa.benchmarks.chain;

import org.u2sa.messages.schema.U2SAData;

/** Which measurement the newest messages go back to. For all threads. */
final class Causes {
  /** Of a message that goes back to no measurement of the sensor that is timed. */
  static final long NONE = 0L;

  private static final int REMEMBERED = 256;

  private final U2SAData[] messages = new U2SAData[REMEMBERED];
  private final long[] sentNanos = new long[REMEMBERED];
  private int next;

  /** Takes note that a message goes back to the measurement that was sent then [ns]. */
  synchronized void put(U2SAData message, long nanos) {
    messages[next] = message;
    sentNanos[next] = nanos;
    next = (next + 1) % REMEMBERED;
  }

  /** When the measurement was sent that the very message goes back to [ns]; or {@link #NONE}. */
  synchronized long of(U2SAData message) {
    for (int back = 1; back <= REMEMBERED; back++) {
      int at = (next - back + REMEMBERED) % REMEMBERED;
      if (messages[at] == message) {
        return sentNanos[at];
      }
    }
    return NONE;
  }
}
