package org.u2sa.recorder.playback;

import java.io.IOException;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.record.McapChannel;
import org.u2sa.recorder.mcap.record.McapMessage;

/**
 * Plays a recording in real time or at a multiple of it. {@link #play} runs on one thread; pause,
 * step, seek, rate and end may be called from any, and take effect within 50 ms.
 *
 * <p>If the machine cannot keep up, messages are late; none is skipped.
 */
public final class Playback {
  private static final long LOOK_UP_MICROS = 50_000;
  private static final double NANOS_PER_MICRO = 1e3;
  private static final double NANOS_PER_SECOND = 1e9;
  private static final double SLOWEST = 1e-3;
  private static final double FASTEST = 1e6;

  private final McapReader reader;
  private final Predicate<McapChannel> wanted;
  private final RecordedSpan span;
  private final boolean loops;
  private final Clock clock;
  private final Queue<Order> orders = new ConcurrentLinkedQueue<>();
  private McapCursor cursor; // used by the playing thread only, like those below
  private McapMessage next; // null at the end
  private Sink sink;
  private long anchorMicros; // clock time that corresponds to anchorNanos
  private long anchorNanos;
  private long positionNanos;
  private double rate;
  private boolean isPaused;
  private boolean isStepping;
  private boolean isEnded;
  private boolean isToTell;
  private boolean holdsAtEnd;

  private interface Order {
    void obey() throws IOException;
  }

  /** Destination of the messages. */
  public interface Sink {
    /** Receives a due message. */
    void play(McapMessage message) throws IOException;

    /** Receives the position, 20 times a second and after each command. */
    void at(Position position);

    /** Called before the first message from a new position: the start, a seek, a loop. */
    default void sought(long nanos) throws IOException {
      // most destinations need no preparation
    }
  }

  /**
   * Position in a recording.
   *
   * @param nanos log time [ns]
   * @param rate speed relative to the recording
   * @param isPaused whether it is paused
   */
  public record Position(long nanos, double rate, boolean isPaused) {}

  /**
   * @param wanted channels to play
   * @param rate speed relative to the recording, more than 0
   * @param loops whether to restart at the end
   * @param clock real time
   */
  public Playback(
      McapReader reader,
      Predicate<McapChannel> wanted,
      RecordedSpan span,
      double rate,
      boolean loops,
      Clock clock) {
    this.reader = reader;
    this.wanted = wanted;
    this.span = span;
    this.rate = rate;
    this.loops = loops;
    this.clock = clock;
  }

  /** Plays until the end of the span, or until {@link #end} or {@code isOver}. */
  public void play(Sink to, BooleanSupplier isOver) throws IOException, InterruptedException {
    sink = to;
    seek(span.fromNanos());
    if (next == null) {
      return; // nothing selected: a loop would spin
    }
    long toldMicros = Long.MIN_VALUE;
    try (Clock.Waiter waiter = clock.newWaiter("playback")) {
      while (!isEnded && !isOver.getAsBoolean()) {
        obey();
        long now = clock.micros();
        boolean isDue = next != null && (isStepping || !isPaused && dueMicros() <= now);
        if (isDue) {
          positionNanos = next.logTimeNanos();
        } else if (!isPaused) {
          positionNanos = Math.min(span.toNanos(), timeAt(now));
        }
        if (isToTell || toldMicros == Long.MIN_VALUE || now - toldMicros >= LOOK_UP_MICROS) {
          toldMicros = now;
          isToTell = false;
          sink.at(new Position(positionNanos, rate, isPaused));
        }
        if (isDue) {
          sink.play(next);
          advance();
        } else if (next == null && !isPaused && loops) {
          seek(span.fromNanos());
        } else if (next == null && !isPaused && holdsAtEnd) {
          isPaused = true;
          isToTell = true;
        } else if (next == null && !isPaused) {
          return;
        } else {
          long until = now + LOOK_UP_MICROS;
          waiter.await(isPaused ? until : Math.min(until, dueMicros()));
        }
      }
    }
  }

  private void obey() throws IOException {
    for (Order order = orders.poll(); order != null; order = orders.poll()) {
      anchor(positionNanos);
      order.obey();
      isToTell = true;
    }
  }

  private void advance() throws IOException {
    if (isStepping) {
      isStepping = false;
      isToTell = true;
      anchor(positionNanos);
    }
    take(cursor.next());
  }

  private void seek(long nanos) throws IOException {
    positionNanos = Math.max(span.fromNanos(), Math.min(span.toNanos(), nanos));
    cursor = reader.messages(positionNanos, wanted);
    take(cursor.next());
    sink.sought(positionNanos);
    anchor(positionNanos);
  }

  private void take(Optional<McapMessage> message) {
    next = message.filter(m -> m.logTimeNanos() <= span.toNanos()).orElse(null);
  }

  /** Maps the current clock time to this recording time. */
  private void anchor(long nanos) {
    anchorMicros = clock.micros();
    anchorNanos = nanos;
  }

  private long dueMicros() {
    return anchorMicros + Math.round((next.logTimeNanos() - anchorNanos) / rate / NANOS_PER_MICRO);
  }

  private long timeAt(long micros) {
    return anchorNanos + Math.round((micros - anchorMicros) * rate * NANOS_PER_MICRO);
  }

  /** Pauses at the span's end, so that one can go back. Call before {@link #play}. */
  public void holdAtEnd() {
    holdsAtEnd = true;
  }

  /** Pauses or resumes. */
  public void togglePause() {
    orders.add(() -> isPaused = !isPaused);
  }

  /** Plays the next message, then pauses. */
  public void step() {
    orders.add(
        () -> {
          isPaused = true;
          isStepping = true;
        });
  }

  /** Seeks forward, or backward if negative [s of the recording]; limited to the span. */
  public void seekBy(double seconds) {
    orders.add(() -> seek(positionNanos + Math.round(seconds * NANOS_PER_SECOND)));
  }

  /** Seeks to a log time [ns]; limited to the span. */
  public void seekTo(long nanos) {
    orders.add(() -> seek(nanos));
  }

  /** Pauses, or resumes. */
  public void pause(boolean value) {
    orders.add(() -> isPaused = value);
  }

  /** Sets the playback speed. */
  public void rate(double value) {
    orders.add(() -> rate = Math.max(SLOWEST, Math.min(FASTEST, value)));
  }

  /** Multiplies the playback speed by a factor. */
  public void fasterBy(double factor) {
    orders.add(() -> rate = Math.max(SLOWEST, Math.min(FASTEST, rate * factor)));
  }

  public void end() {
    orders.add(() -> isEnded = true);
  }
}
