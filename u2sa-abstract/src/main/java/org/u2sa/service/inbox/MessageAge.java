package org.u2sa.service.inbox;

import org.u2sa.messages.schema.U2SAData;

/**
 * Age of a received message, counted from its timestamp, or from its arrival if that is earlier: a
 * source whose clock is ahead must not appear fresh after it has fallen silent.
 */
public final class MessageAge {
  private MessageAge() {}

  /**
   * The age of a message that says its time [µs], at least 0.
   *
   * @param arrivedMicros when it came, by the clock of {@code nowMicros}
   * @throws java.util.NoSuchElementException if it does not say its time
   */
  public static long micros(U2SAData message, long arrivedMicros, long nowMicros) {
    return nowMicros - Math.min(message.timestamp().orElseThrow(), arrivedMicros);
  }
}
