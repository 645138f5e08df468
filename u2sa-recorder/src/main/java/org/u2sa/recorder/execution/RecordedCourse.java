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
 * Replay position of a re-executed service in its recorded execution: its next inputs and expected
 * outputs.
 *
 * <p>An unchanged service makes the same requests in the same order. A changed one may diverge
 * ("stray"). Messages then still arrive where they did in the recording, with recorded times in
 * between; a wait that ends earlier than the recorded one ends at its own deadline.
 */
final class RecordedCourse {
  private static final int VAIN_WAITS = 3;

  private final ExecutionReader recorded;
  private final Outputs outputs;
  private final Runnable atEnd;
  private volatile long micros;
  private volatile long passed; // number of entries; written by one thread only
  private long readingsLeft; // of the current entry
  private long heldUntilMicros = Clock.NEVER; // replay paused until then; NEVER if not paused
  private final List<Next> unpublished = new ArrayList<>(); // outputs before the anchor
  private boolean over;
  private int vainWaits;
  private IOException failure;
  private boolean elsewhere;
  private boolean strayed;

  /** Receives a service's output paired with its recorded output. */
  interface Outputs {
    /**
     * Called for a message published in the recording, now, or both.
     *
     * @param micros publication time [µs of the run's clock]
     * @param recorded recorded message; null if published only now
     * @param now new message; null if only in the recording
     * @throws IOException if the recorded message cannot be read
     */
    void published(long micros, Channel<?> channel, RecordedMessage recorded, U2SAData now)
        throws IOException;
  }

  /** Calls {@code atEnd} at the end of the recording. */
  RecordedCourse(ExecutionReader recorded, Outputs outputs, Runnable atEnd) {
    this.recorded = recorded;
    this.outputs = outputs;
    this.atEnd = atEnd;
  }

  /** Error reading the recording, or empty. */
  Optional<IOException> failure() {
    return Optional.ofNullable(failure);
  }

  /** Whether the recorded service also published from other threads, which cannot be repeated. */
  boolean publishedElsewhere() {
    return elsewhere;
  }

  /** Whether the service's requests differed from the recording, in content or order. */
  boolean hasStrayed() {
    return strayed;
  }

  /** Current replay time [µs of the run's clock]. */
  long micros() {
    return micros;
  }

  /** Progress counter; grows while the service advances. */
  long passed() {
    return passed;
  }

  boolean isOver() {
    return over;
  }

  /** Passes the next anchor if it is of this kind; otherwise the service has diverged. */
  void passIf(Kind kind) {
    if (nextAnchor() == kind) {
      pass();
    } else {
      strayed |= !over;
    }
  }

  /** Next message to handle; null if something else is next. */
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

  /** Whether a configuration change is to be applied now. */
  boolean takesWritten() {
    Next next = isHolding() || readingsLeft > 0 ? null : peek();
    if (next == null || next.entry().kind() != Kind.WRITTEN) {
      return false;
    }
    pass();
    return true;
  }

  /** Handles a message of the service. Returns whether it counts as accepted. */
  boolean publish(Channel<?> channel, U2SAData message) {
    Next counterpart = isHolding() ? null : counterpart(channel);
    if (over) {
      return true;
    }
    strayed |= counterpart == null;
    tell(channel, counterpart == null ? null : counterpart.message(), message);
    return counterpart == null || counterpart.entry().kind() == Kind.PUBLISHED;
  }

  /** Recorded output on the channel at this point; null if none. */
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

  /** Called when the service's loop ends. */
  void end() {
    strayed |= !over && nextAnchor() != null;
    leaveOut();
  }

  /** Next entry; null at the end. */
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

  /** Skips to the next anchor, collecting recorded outputs this service has not published yet. */
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

  /** Kind of the next anchor; null at the end and while replay is paused. */
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

  /** Next clock reading [µs]. */
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

  /** Advances to the end of a wait. */
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

  /** Ends a wait at its own deadline if the recorded one ended later, pausing replay until then. */
  private void holdUntil(long recordedMicros, long deadlineMicros) {
    if (deadlineMicros < recordedMicros) {
      micros = Math.max(micros, deadlineMicros);
      heldUntilMicros = recordedMicros;
    } else {
      heldUntilMicros = Clock.NEVER;
    }
  }

  /**
   * Reports the remaining recorded outputs after a service ended early.
   *
   * @throws IOException if the recording cannot be read
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
