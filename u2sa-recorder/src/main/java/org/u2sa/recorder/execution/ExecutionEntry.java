package org.u2sa.recorder.execution;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.recorder.mcap.McapException;

/**
 * One thing that passed between a service and the world.
 *
 * @param kind what
 * @param micros the clock's reading, the end of a wait, or when a message arrived [µs of the run's
 *     clock]; 0 for other kinds
 * @param times how many readings; 1 for other kinds
 */
record ExecutionEntry(Kind kind, long micros, long times) {
  /** What passes. The order is that of the numbers in recordings. */
  enum Kind {
    /** The service reads the clock. */
    READING,
    /** A message is handled. */
    RECEIVED,
    /** A message is published, and taken. */
    PUBLISHED,
    /** A message is published, and refused. */
    REFUSED,
    /** The service begins a step. */
    STEP,
    /** The service waits. */
    WAIT,
    /** A written change of the configuration is taken. */
    WRITTEN,
    /** The service is made; what follows is its thread's. */
    MADE,
    /** The service's loop is over. */
    END,
    /** The service published from a thread that is not its own. */
    ELSEWHERE;

    boolean isOfMessage() {
      return this == RECEIVED || this == PUBLISHED || this == REFUSED;
    }

    boolean isOutput() {
      return this == PUBLISHED || this == REFUSED;
    }

    /** Whether only that the service has come this far leads beyond it. */
    boolean isAnchor() {
      return this != READING && this != PUBLISHED && this != REFUSED && this != ELSEWHERE;
    }
  }

  private static final Kind[] KINDS = Kind.values();

  /** Writes an entry. Times are relative to the last reading, which makes them short. */
  void write(PackedWriter out, long lastMicros) {
    out.number(kind.ordinal());
    switch (kind) {
      case READING -> out.signed(micros - lastMicros).number(times);
      case WAIT -> writeOr(out, Clock.NEVER, lastMicros);
      case RECEIVED -> writeOr(out, 0L, lastMicros);
      default -> {
        // the kind says all
      }
    }
  }

  private void writeOr(PackedWriter out, long none, long lastMicros) {
    if (micros == none) {
      out.number(0);
    } else {
      out.number(1).signed(micros - lastMicros);
    }
  }

  static ExecutionEntry read(PackedReader in, long lastMicros) throws McapException {
    long number = in.number();
    if (number < 0 || number >= KINDS.length) {
      throw new McapException("an execution holds an entry of the unknown kind " + number);
    }
    Kind kind = KINDS[(int) number];
    return switch (kind) {
      case READING -> new ExecutionEntry(kind, lastMicros + in.signed(), in.number());
      case WAIT -> new ExecutionEntry(kind, readOr(in, Clock.NEVER, lastMicros), 1);
      case RECEIVED -> new ExecutionEntry(kind, readOr(in, 0L, lastMicros), 1);
      default -> new ExecutionEntry(kind, 0, 1);
    };
  }

  private static long readOr(PackedReader in, long none, long lastMicros) throws McapException {
    return in.number() == 0 ? none : lastMicros + in.signed();
  }
}
