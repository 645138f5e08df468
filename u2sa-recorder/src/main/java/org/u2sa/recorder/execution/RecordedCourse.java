package org.u2sa.recorder.execution;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.execution.ExecutionEntry.Kind;
import org.u2sa.recorder.execution.ExecutionReader.Next;

/**
 * Where in a recorded execution a service has come that is executed again: what it is given next,
 * and what it has to publish.
 *
 * <p>A service that is the same asks for the same in the same order. One that was changed may not:
 * it strays. Then messages still come where they came in the recording, and between them time is
 * what the recording has; a wait that would end earlier than the recorded one ends when it would.
 */
final class RecordedCourse {
  private static final int VAIN_WAITS = 3;

  private final ExecutionReader recorded;
  private final Outputs outputs;
  private final Runnable atEnd;
  private volatile long micros;
  private volatile long passed; // entries; written by one thread only
  private long readingsLeft; // of the present entry
  private long heldUntilMicros = Clock.NEVER; // where the recording goes on; NEVER: it does
  private final List<Next> unpublished = new ArrayList<>(); // before the next anchor
  private boolean over;
  private int vainWaits;
  private IOException failure;
  private boolean elsewhere;
  private boolean strayed;

  /** Takes what a service publishes, beside what it published in the recording. */
  interface Outputs {
    /**
     * A message that was published in the recording, or is published now, or both.
     *
     * @param micros when it is, or was [µs of the run's clock]
     * @param recorded null: only now
     * @param now null: only in the recording
     * @throws IOException if the recorded one cannot be read
     */
    void published(long micros, Channel<?> channel, RecordedMessage recorded, U2SAData now)
        throws IOException;
  }

  /**
   * @param atEnd called where the recording ends
   */
  RecordedCourse(ExecutionReader recorded, Outputs outputs, Runnable atEnd) {
    this.recorded = recorded;
    this.outputs = outputs;
    this.atEnd = atEnd;
  }

  /** What could not be read of the recording; empty if nothing. */
  Optional<IOException> failure() {
    return Optional.ofNullable(failure);
  }

  /** Whether the recorded service published from threads of its own, which cannot be repeated. */
  boolean publishedElsewhere() {
    return elsewhere;
  }

  /** Whether the service asked for something else, or in another order, than in the recording. */
  boolean hasStrayed() {
    return strayed;
  }

  /** The time at which it has come [µs of the run's clock]. */
  long micros() {
    return micros;
  }

  /** Grows as long as the service goes on. */
  long passed() {
    return passed;
  }

  /** Whether the recording has no more. */
  boolean isOver() {
    return over;
  }

  /** Goes beyond the next anchor if it is of that kind; otherwise the service strays. */
  void passIf(Kind kind) {
    if (nextAnchor() == kind) {
      pass();
    } else {
      strayed |= !over;
    }
  }

  /** The next message to be handled; null if something else is next. */
  RecordedMessage.Handled receive() {
    if (nextAnchor() != Kind.RECEIVED) {
      return null;
    }
    Next next = pass();
    try {
      return new RecordedMessage.Handled(
          next.message().channel(), next.message().decoded(), next.entry().micros());
    } catch (IOException e) {
      fail(e);
      return null;
    }
  }

  /** Whether a change of the configuration is to be taken now. */
  boolean takesWritten() {
    Next next = isHolding() || readingsLeft > 0 ? null : peek();
    if (next == null || next.entry().kind() != Kind.WRITTEN) {
      return false;
    }
    pass();
    return true;
  }

  /** Takes what the service publishes. Returns whether it counts as taken. */
  boolean publish(Channel<?> channel, U2SAData message) {
    Next counterpart = isHolding() ? null : counterpart(channel);
    if (over) {
      return true;
    }
    strayed |= counterpart == null;
    tell(channel, counterpart == null ? null : counterpart.message(), message);
    return counterpart == null || counterpart.entry().kind() == Kind.PUBLISHED;
  }

  /** What was published on the channel in the recording at this point; null if nothing. */
  private Next counterpart(Channel<?> channel) {
    Next next = readingsLeft > 0 || !unpublished.isEmpty() ? null : peek();
    if (next != null
        && next.entry().kind().isOutput()
        && next.message().channel().equals(channel)) {
      recorded.skip();
      return next;
    }
    goToAnchor();
    for (Iterator<Next> all = unpublished.iterator(); all.hasNext(); ) {
      Next one = all.next();
      if (one.message().channel().equals(channel)) {
        all.remove();
        return one;
      }
    }
    next = peek();
    if (next != null && next.entry().kind() == Kind.END) {
      stop();
    }
    return null;
  }

  /** The service's loop is over. */
  void end() {
    strayed |= !over && nextAnchor() != null;
    leaveOut();
  }

  /** The next entry; null at the end. */
  private Next peek() {
    if (over) {
      return null;
    }
    try {
      passed++;
      Next next = recorded.peek().orElse(null);
      if (next != null && next.entry().kind() == Kind.ELSEWHERE) {
        elsewhere = true;
        recorded.skip();
        return peek();
      }
      return next;
    } catch (IOException e) {
      fail(e);
      return null;
    }
  }

  private void stop() {
    over = true;
    atEnd.run();
  }

  private void fail(IOException e) {
    failure = e;
    stop();
  }

  /** Goes over what the recorded service did before the next anchor and this one did not, yet. */
  private void goToAnchor() {
    strayed |= readingsLeft > 0;
    readingsLeft = 0;
    Next next = peek();
    while (next != null && !next.entry().kind().isAnchor()) {
      strayed = true;
      recorded.skip();
      if (next.entry().kind() == Kind.READING) {
        micros = next.entry().micros();
      } else {
        unpublished.add(next);
      }
      next = peek();
    }
  }

  /** The kind of the next anchor; null at the end, and while time is not the recording's. */
  private Kind nextAnchor() {
    if (isHolding()) {
      return null;
    }
    goToAnchor();
    Next next = peek();
    if (next != null && next.entry().kind() == Kind.END) {
      stop();
      return null;
    }
    return next == null ? null : next.entry().kind();
  }

  /** Passes the next anchor. */
  private Next pass() {
    Next next = peek();
    leaveOut();
    recorded.skip();
    vainWaits = 0;
    return next;
  }

  private void leaveOut() {
    unpublished.forEach(one -> tell(one.message().channel(), one.message(), null));
    unpublished.clear();
  }

  private void tell(Channel<?> channel, RecordedMessage before, U2SAData now) {
    try {
      outputs.published(micros, channel, before, now);
    } catch (IOException e) {
      fail(e);
    }
  }

  private boolean isHolding() {
    return heldUntilMicros != Clock.NEVER;
  }

  /** The clock's next reading [µs]. */
  long read() {
    if (isHolding() || readingsLeft > 0) {
      readingsLeft = Math.max(0, readingsLeft - 1);
      return micros;
    }
    Next next = peek();
    if (next != null && next.entry().kind() == Kind.READING) {
      recorded.skip();
      micros = next.entry().micros();
      readingsLeft = next.entry().times() - 1;
    } else if (next == null || next.entry().kind() == Kind.END) {
      stop();
    } else {
      strayed = true;
    }
    return micros;
  }

  /** Goes to where a wait ends. */
  void await(long deadlineMicros) {
    if (isHolding()) {
      holdUntil(heldUntilMicros, deadlineMicros);
      return;
    }
    Kind anchor = nextAnchor();
    if (anchor == null) {
      stop();
      return;
    }
    if (anchor == Kind.WAIT) {
      Next wait = pass();
      Next after = peek();
      if (wait.entry().micros() != deadlineMicros
          && after != null
          && after.entry().kind() == Kind.READING) {
        strayed = true;
        holdUntil(after.entry().micros(), deadlineMicros);
      }
      return;
    }
    strayed = true;
    if (anchor == Kind.STEP || ++vainWaits >= VAIN_WAITS) {
      pass();
    }
  }

  /** Lets a wait end where it would, if the recorded one ended later. */
  private void holdUntil(long recordedMicros, long deadlineMicros) {
    if (deadlineMicros < recordedMicros) {
      micros = Math.max(micros, deadlineMicros);
      heldUntilMicros = recordedMicros;
    } else {
      heldUntilMicros = Clock.NEVER;
    }
  }

  /**
   * Tells the outputs what the recording has after a service that ended early.
   *
   * @throws IOException if it cannot be read
   */
  void finish() throws IOException {
    for (Optional<Next> next = recorded.peek(); next.isPresent(); next = recorded.peek()) {
      recorded.skip();
      if (next.get().entry().kind() == Kind.READING) {
        micros = next.get().entry().micros();
      } else if (next.get().entry().kind().isOutput()) {
        outputs.published(micros, next.get().message().channel(), next.get().message(), null);
      }
    }
  }
}
