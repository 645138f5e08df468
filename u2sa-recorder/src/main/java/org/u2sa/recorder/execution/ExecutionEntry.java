package org.u2sa.recorder.execution;

import org.u2sa.interfaces.time.Clock;
import org.u2sa.recorder.mcap.record.McapException;

/**
 * One interaction between a service and its environment.
 *
 * @param kind kind of interaction
 * @param micros clock reading, deadline of a wait or arrival of a message [µs of the run's clock];
 *     0 for other kinds
 * @param times number of equal readings; 1 for other kinds
 */
record ExecutionEntry(Kind kind, long micros, long times) {
  /** Kind of interaction. Recordings store the ordinal. */
  enum Kind {
    /** The service reads the clock. */
    READING,
    /** A message is handled. */
    RECEIVED,
    /** A message is published and accepted. */
    PUBLISHED,
    /** A message is published and rejected. */
    REFUSED,
    /** The service begins a step. */
    STEP,
    /** The service waits. */
    WAIT,
    /** A changed configuration file is applied. */
    WRITTEN,
    /** The service is constructed; later entries come from its thread. */
    MADE,
    /** The service's loop ends. */
    END,
    /** The service published from another thread. */
    ELSEWHERE;

    boolean isOfMessage() {
      return this == RECEIVED || this == PUBLISHED || this == REFUSED;
    }

    boolean isOutput() {
      return this == PUBLISHED || this == REFUSED;
    }

    /** Whether a replay can only pass this entry when the service reaches the same point. */
    boolean isAnchor() {
      return this != READING && this != PUBLISHED && this != REFUSED && this != ELSEWHERE;
    }
  }

  private static final Kind[] KINDS = Kind.values();

  /** Writes an entry. Times are relative to the last reading, to keep them short. */
  void write(PackedWriter out, long lastMicros) {
    out.number(kind.ordinal());
    switch (kind) {
      case READING -> out.signed(micros - lastMicros).number(times);
      case WAIT -> writeOr(out, Clock.NEVER, lastMicros);
      case RECEIVED -> writeOr(out, 0L, lastMicros);
      default -> {
        // the kind is sufficient
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
