package org.u2sa.gcs.mavlink;

import java.util.Arrays;
import java.util.function.Predicate;
import org.u2sa.mavlink.MavlinkStream;

/**
 * What a station sends, the same for every kind of link: within its allowance, messages are
 * handled; of the rest, only orders to stop, and everything else is dropped. Nothing waits, because
 * old sticks would steer after their time, and a stop would wait behind them.
 */
final class StationInput {
  private static final int SLICE = 64; // few enough bytes to overdraw the allowance by 0.3 s only
  private static final long USUAL_OVERDUE_MICROS = 500_000;

  private final MavlinkStream stream;
  private final Predicate<MavlinkStream.Received> receiver;
  private final ByteAllowance allowance = new ByteAllowance();
  private final ByteAllowance stopAllowance = new ByteAllowance();
  private final StopSearch stops = new StopSearch();
  private long consumed;
  private long consumedMicros = Long.MIN_VALUE;
  private long overdueMicros = USUAL_OVERDUE_MICROS;

  /**
   * @param receiver handles a message; false if it was for others
   */
  StationInput(MavlinkStream stream, Predicate<MavlinkStream.Received> receiver) {
    this.stream = stream;
    this.receiver = receiver;
  }

  /** Sets how long the rest of a packet may take to arrive [µs]. */
  void overdueAfter(long micros) {
    overdueMicros = micros;
  }

  /** Whether messages are handled at present. */
  boolean isOpen(long micros) {
    return allowance.left(micros) > 0;
  }

  /** Takes received bytes. */
  void take(byte[] bytes, int length, long micros) {
    int from = 0;
    while (from < length && isOpen(micros)) {
      int until = Math.min(length, from + SLICE);
      parse(Arrays.copyOfRange(bytes, from, until), until - from, allowance);
      allowance.use(until - from);
      from = until;
    }
    if (from < length) {
      byte[] partial = stream.reset();
      stops.search(partial, partial.length, frame -> stop(frame, micros));
      stops.search(
          Arrays.copyOfRange(bytes, from, length), length - from, frame -> stop(frame, micros));
    }
  }

  /**
   * Handles what looks like a stop. A sender without the key must not use up the allowance for
   * stops, so the signature is checked first: one SHA-256 for each, which takes less time than
   * receiving them, and a link reads a limited number of bytes in a turn.
   */
  private void stop(byte[] frame, long micros) {
    if (stream.isAdmissible(frame) && stopAllowance.left(micros) > 0) {
      parse(frame, frame.length, stopAllowance);
      stream.reset(); // it may look like one and be none
    }
  }

  private void parse(byte[] bytes, int length, ByteAllowance from) {
    long before = stream.malformed();
    stream.accept(bytes, length, received -> count(received, from));
    from.useMessages(stream.malformed() - before);
  }

  private void count(MavlinkStream.Received received, ByteAllowance from) {
    if (receiver.test(received)) {
      from.useMessages(1);
    }
  }

  /** Finds messages that wait behind noise which looks like the start of a longer one. */
  void step(long micros) {
    if (isOpen(micros)) {
      byte[] partial = stops.reset(); // its rest may come now
      parse(partial, partial.length, allowance);
    }
    boolean isNew = consumedMicros == Long.MIN_VALUE || !stream.isPartial();
    if (isNew || stream.consumed() != consumed) {
      consumed = stream.consumed();
      consumedMicros = micros;
    } else if (micros - consumedMicros > overdueMicros) {
      stream.resynchronize(received -> count(received, allowance));
    }
  }
}
