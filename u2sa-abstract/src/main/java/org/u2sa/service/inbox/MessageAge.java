package org.u2sa.service.inbox;

import org.u2sa.messages.schema.U2SAData;

/**
 * Age of a received message, counted from its timestamp, or from its arrival if that is earlier: a
 * silent source whose clock is ahead must not appear fresh.
 */
public final class MessageAge {
  private MessageAge() {}

  /**
   * Age of a message with a timestamp [µs], at least 0.
   *
   * @param arrivedMicros time of arrival, by the clock of {@code nowMicros}
   * @throws java.util.NoSuchElementException without a timestamp
   */
  public static long micros(U2SAData message, long arrivedMicros, long nowMicros) {
    return nowMicros - Math.min(message.timestamp().orElseThrow(), arrivedMicros);
  }
}
