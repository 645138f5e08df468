package org.u2sa.recorder.execution;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.execution.ExecutionEntry.Kind;
import org.u2sa.service.Execution;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.U2SAService;

/**
 * Notes what passes between a service and the world, and hands it on in parts. Changes nothing of
 * it. All but its clock and {@link #publishes} belongs to the thread that executes the service.
 */
public final class KeptExecution implements Execution {
  private static final long PART_MICROS = 250_000;
  private static final int PART_MESSAGES = 64;
  private static final int PART_BYTES = 1 << 12;
  private static final int LARGEST_PART = 16; // as many times: of a service that never waits

  private final Clock clock;
  private final Consumer<ExecutionPart> parts;
  private final Consumer<KeptExecution> onMade;
  private final PackedWriter entries = new PackedWriter();
  private final List<ExecutionPart.Passed> messages = new ArrayList<>();
  private final AtomicLong elsewhere = new AtomicLong(); // published by other threads
  private String name = ""; // of the execution; empty: not kept
  private U2SAService service;
  private volatile String instance = "";
  private int threadId;
  private volatile Thread owner; // null: nobody executes the service
  private boolean kept = true;
  private long elsewhereNoted;
  private long number;
  private long partBeganMicros;
  private long baseMicros; // what the next reading is written relative to
  private long readingMicros;
  private long readings; // of the same time, not yet written

  /**
   * An execution that begins on the calling thread, which makes the service.
   *
   * @param clock of the run
   * @param onMade asked when the service is made; is to {@link #keepAs} it, or to leave it
   * @param parts takes what was noted, on the service's thread
   */
  public KeptExecution(Clock clock, Consumer<KeptExecution> onMade, Consumer<ExecutionPart> parts) {
    this.clock = clock;
    this.onMade = onMade;
    this.parts = parts;
    owner = Clock.runningThread();
    partBeganMicros = clock.micros();
  }

  /** The service; null before it is made. */
  public U2SAService service() {
    return service;
  }

  /** Which connection the service has; empty before it has one. */
  public String instance() {
    return instance;
  }

  /** Sets the name under which the execution is kept, unique in the recording. */
  public void keepAs(String executionName) {
    name = executionName;
  }

  /**
   * Whether a service of that role depends on nothing but messages, time and its configuration, as
   * far as a role can tell: sensors and actuators have devices.
   */
  public static boolean isRepeatable(ServiceRole role) {
    return switch (role) {
      case PROPRIOCEPTIVE_SENSOR, EXTEROCEPTIVE_SENSOR, ACTUATOR, LAUNCHER, OBSERVER -> false;
      default -> true;
    };
  }

  @Override
  public Clock clock() {
    return new NotingClock();
  }

  /** Which thread the service is. */
  int threadId() {
    return threadId;
  }

  @Override
  public int threadId(int own) {
    threadId = own;
    return own;
  }

  @Override
  public void connects(String connectionInstance) {
    instance = connectionInstance;
  }

  @Override
  public void made(U2SAService made) {
    service = made;
    onMade.accept(this);
    kept = !name.isEmpty();
    note(Kind.MADE, 0);
    owner = null;
  }

  @Override
  public void begins() {
    owner = Clock.runningThread();
  }

  @Override
  public void steps() {
    note(Kind.STEP, 0);
  }

  @Override
  public Arrival receives(Arrival waiting) {
    if (waiting != null && kept) {
      note(Kind.RECEIVED, waiting.arrivedMicros());
      messages.add(new ExecutionPart.Passed(waiting.channel(), waiting.message()));
    }
    return waiting;
  }

  @Override
  public boolean takesWritten(BooleanSupplier isWritten) {
    boolean taken = isWritten.getAsBoolean();
    if (taken) {
      note(Kind.WRITTEN, 0);
    }
    return taken;
  }

  @Override
  public boolean publishes(Channel<?> channel, U2SAData message, BooleanSupplier publish) {
    boolean taken;
    try {
      taken = publish.getAsBoolean();
    } catch (CommunicationException e) {
      if (Clock.runningThread() == owner) {
        ends(); // cut off from all others: nothing of what follows reaches anybody
      }
      throw e;
    }
    if (!kept) {
      return taken;
    }
    if (Clock.runningThread() == owner) {
      note(taken ? Kind.PUBLISHED : Kind.REFUSED, 0);
      messages.add(new ExecutionPart.Passed(channel, message));
    } else if (!channel.equals(Channels.HEALTH)) { // the last report may be by whoever ends it
      elsewhere.incrementAndGet();
    }
    return taken;
  }

  @Override
  public void ends() {
    note(Kind.END, 0);
    handOn();
    kept = false;
    owner = null;
  }

  private void note(Kind kind, long micros) {
    if (!kept) {
      return;
    }
    writeReadings();
    new ExecutionEntry(kind, micros, 1).write(entries, baseMicros);
    if (entries.length() >= LARGEST_PART * PART_BYTES
        || messages.size() >= LARGEST_PART * PART_MESSAGES) {
      handOnLater = true;
    }
  }

  private boolean handOnLater; // once the message of the entry is there too

  private void noteReading(long micros) {
    if (!kept) {
      return;
    }
    if (handOnLater) {
      handOn();
    }
    if (readings > 0 && micros != readingMicros) {
      writeReadings();
    }
    readingMicros = micros;
    readings++;
  }

  private void writeReadings() {
    if (readings > 0) {
      new ExecutionEntry(Kind.READING, readingMicros, readings).write(entries, baseMicros);
      baseMicros = readingMicros;
      readings = 0;
    }
  }

  private void noteWait(long deadlineMicros) {
    if (!kept) {
      return;
    }
    note(Kind.WAIT, deadlineMicros);
    long now = clock.micros();
    if (now - partBeganMicros >= PART_MICROS
        || entries.length() >= PART_BYTES
        || messages.size() >= PART_MESSAGES) {
      handOn();
    }
  }

  private void handOn() {
    if (!kept || name.isEmpty()) {
      return;
    }
    writeReadings();
    long others = elsewhere.get();
    if (others != elsewhereNoted) {
      elsewhereNoted = others;
      new ExecutionEntry(Kind.ELSEWHERE, 0, 1).write(entries, baseMicros);
    }
    partBeganMicros = clock.micros();
    parts.accept(
        new ExecutionPart(
            name, number++, partBeganMicros, entries.toBytes(), new ArrayList<>(messages)));
    entries.clear();
    messages.clear();
    handOnLater = false;
    baseMicros = 0; // each part can be read by itself
  }

  /** The run's clock; what the service's thread reads of it is noted. */
  private final class NotingClock implements Clock {
    @Override
    public long micros() {
      long now = clock.micros();
      if (Clock.runningThread() == owner) {
        noteReading(now);
      }
      return now;
    }

    @Override
    public Waiter newWaiter(String waiterName) {
      return new NotingWaiter(clock.newWaiter(waiterName));
    }
  }

  private final class NotingWaiter implements Clock.Waiter {
    private final Clock.Waiter waiter;

    NotingWaiter(Clock.Waiter waiter) {
      this.waiter = waiter;
    }

    @Override
    public void await(long deadlineMicros) throws InterruptedException {
      if (Clock.runningThread() == owner) {
        noteWait(deadlineMicros);
      }
      waiter.await(deadlineMicros);
    }

    @Override
    public void lend(Clock.Turns turns) throws InterruptedException {
      waiter.lend(
          () -> {
            long next = turns.take();
            if (next != Clock.Turns.OVER) {
              noteWait(next);
            }
            return next;
          });
    }

    @Override
    public void signal() {
      waiter.signal();
    }

    @Override
    public void close() {
      waiter.close();
    }
  }
}
