package org.u2sa.recorder.execution;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.execution.ExecutionEntry.Kind;
import org.u2sa.recorder.execution.ExecutionReader.Next;
import org.u2sa.service.Execution;
import org.u2sa.service.U2SAService;

/**
 * Gives a service what it was given when its execution was recorded, in the same order: readings of
 * the clock, messages, the end. What it publishes goes to an {@link Outputs}.
 *
 * <p>A service that is the same asks for the same in the same order. One that was changed may not.
 * Then messages still come where they came in the recording, and between them time is what the
 * recording has; a wait that would end earlier than the recorded one ends when it would.
 */
final class RepeatedExecution implements Execution {
  private static final long WRITES_WITHIN_MICROS = 10 * Clock.MICROS_PER_SECOND;
  private static final long LOOKS_EVERY_MICROS = 1_000;
  private static final int VAIN_WAITS = 3;

  private final ExecutionReader recorded;
  private final Outputs outputs;
  private final Clock machine;
  private final int threadId;
  private volatile Thread owner;
  private volatile long micros;
  private volatile long passed; // entries; written by the owner only
  private long readingsLeft; // of the present entry
  private long heldUntilMicros = Clock.NEVER; // where the recording goes on; NEVER: it does
  private final List<Next> unpublished = new ArrayList<>(); // before the next anchor
  private boolean over;
  private int vainWaits;
  private U2SAService service;
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
   * @param machine real time, to wait for a disk by
   * @param recordedThreadId which thread the service was in the recording
   */
  RepeatedExecution(
      ExecutionReader recorded, Outputs outputs, Clock machine, int recordedThreadId) {
    threadId = recordedThreadId;
    this.recorded = recorded;
    this.outputs = outputs;
    this.machine = machine;
    owner = Thread.currentThread();
  }

  /** What could not be read of the recording; empty if nothing. For when the service has ended. */
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

  @Override
  public Clock clock() {
    return new RepeatedClock();
  }

  @Override
  public int threadId(int own) {
    return threadId;
  }

  @Override
  public void connects(String instance) {
    // it is given the recorded one
  }

  @Override
  public void made(U2SAService made) {
    service = made;
    if (nextAnchor() == Kind.MADE) {
      pass();
    }
    owner = null;
  }

  @Override
  public void begins() {
    owner = Thread.currentThread();
  }

  @Override
  public void steps() {
    if (nextAnchor() == Kind.STEP) {
      pass();
    } else {
      strayed = true;
    }
  }

  @Override
  public Arrival receives(Arrival waiting) {
    if (nextAnchor() != Kind.RECEIVED) {
      return null;
    }
    Next next = pass();
    try {
      return new Arrival(next.message().channel(), next.message().decoded(), next.entry().micros());
    } catch (IOException e) {
      failure = e;
      stop();
      return null;
    }
  }

  @Override
  public boolean takesWritten(BooleanSupplier isWritten) throws InterruptedException {
    Next next = isHolding() || readingsLeft > 0 ? null : peek();
    if (next == null || next.entry().kind() != Kind.WRITTEN) {
      return false;
    }
    pass();
    long until = machine.micros() + WRITES_WITHIN_MICROS;
    try (Clock.Waiter waiter = machine.newWaiter("repeat")) {
      while (!isWritten.getAsBoolean() && machine.micros() < until) {
        waiter.await(machine.micros() + LOOKS_EVERY_MICROS);
      }
    }
    return isWritten.getAsBoolean();
  }

  @Override
  public boolean publishes(Channel<?> channel, U2SAData message, BooleanSupplier publish) {
    if (Thread.currentThread() != owner || over) {
      return true; // as in the recording: what services do at their end is not repeated
    }
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

  @Override
  public void ends() {
    strayed |= !over && nextAnchor() != null;
    leaveOut();
    owner = null;
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
      failure = e;
      stop();
      return null;
    }
  }

  private void stop() {
    over = true;
    if (Thread.currentThread() == service) {
      service.kill(); // its loop ends after what it is doing
    }
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
      failure = e;
      stop();
    }
  }

  private boolean isHolding() {
    return heldUntilMicros != Clock.NEVER;
  }

  private long read() {
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

  private void await(long deadlineMicros) {
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

  /** The run's clock as it was read in the recording. */
  private final class RepeatedClock implements Clock {
    @Override
    public long micros() {
      return Thread.currentThread() == owner ? read() : micros;
    }

    @Override
    public Waiter newWaiter(String name) {
      return new RepeatedWaiter();
    }
  }

  private final class RepeatedWaiter implements Clock.Waiter {
    @Override
    public void await(long deadlineMicros) throws InterruptedException {
      if (Thread.currentThread() == owner) {
        RepeatedExecution.this.await(deadlineMicros);
      }
    }

    @Override
    public void signal() {
      // the recording says when a wait ends
    }

    @Override
    public void close() {
      // nobody waits
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
