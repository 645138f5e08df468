package org.u2sa.recorder.execution;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.recorder.execution.ExecutionEntry.Kind;
import org.u2sa.service.EventDrivenService;
import org.u2sa.service.Execution;
import org.u2sa.service.PeriodicService;
import org.u2sa.service.ServiceInstance;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.inbox.ServiceInbox;

/**
 * Records the interactions of a service and passes them on in parts, without altering them. Except
 * for its clock and {@link #outlet}, use only on the thread that executes the service.
 */
public final class KeptExecution implements Execution {
  private final Clock clock;
  private final PartBuilder part;
  private final Consumer<KeptExecution> onBegin;
  private final boolean awaitsPlace;
  private final AtomicLong elsewhere = new AtomicLong(); // messages published by other threads
  private ServiceInstance service;
  private volatile String instance = "";
  private int threadId;
  private volatile Thread owner; // null while the service is not executed
  private boolean kept = true;
  private long elsewhereNoted;
  private Inheritance inherited; // null if the service replaced none

  /**
   * Creates an execution that starts on the calling thread, which constructs the service.
   *
   * @param clock the run's clock
   * @param awaitsPlace whether the service is to replace another, which may be refused
   * @param onBegin called when it is certain that the service will run; may call {@link #keepAs} to
   *     keep the execution
   * @param parts receives the parts, on the service's thread
   */
  KeptExecution(
      Clock clock,
      boolean awaitsPlace,
      Consumer<KeptExecution> onBegin,
      Consumer<ExecutionPart> parts) {
    this.clock = clock;
    this.awaitsPlace = awaitsPlace;
    this.onBegin = onBegin;
    part = new PartBuilder(clock, parts);
    owner = Clock.runningThread();
  }

  /** The service; null before it is constructed. */
  public ServiceInstance service() {
    return service;
  }

  /** Instance ID of the service's connection; empty before it connects. */
  public String instance() {
    return instance;
  }

  /** State inherited from the replaced service, if any. */
  Optional<Inheritance> inherited() {
    return Optional.ofNullable(inherited);
  }

  /** Keeps the execution under this name, which must be unique in the recording. */
  void keepAs(String executionName) {
    part.name(executionName);
    kept = true;
  }

  /**
   * Whether a service depends only on messages, time and its configuration, as far as can be
   * determined: services with a custom loop do not qualify, because it runs beside message
   * handling.
   */
  static boolean isRepeatable(ServiceInstance service) {
    return (service instanceof EventDrivenService || service instanceof PeriodicService)
        && isRepeatable(service.role());
  }

  /** Same check by role only: sensors and actuators use devices. */
  static boolean isRepeatable(ServiceRole role) {
    return switch (role) {
      case PROPRIOCEPTIVE_SENSOR, EXTEROCEPTIVE_SENSOR, ACTUATOR, LAUNCHER, OBSERVER -> false;
      default -> true;
    };
  }

  @Override
  public Clock clock(Clock run) {
    return new NotingClock();
  }

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
  public void made(ServiceInstance made) {
    service = made;
    note(Kind.MADE, 0);
    owner = null;
    if (!awaitsPlace) {
      begin();
    }
  }

  private void begin() {
    kept = false; // until it is given a name
    onBegin.accept(this);
  }

  @Override
  public void onBehalf(Runnable code) {
    Thread before = owner;
    owner = Clock.runningThread();
    try {
      code.run();
    } finally {
      owner = before;
    }
  }

  @Override
  public void succeeds(Inheritance inheritance, String connection) {
    inherited = inheritance;
    instance = connection;
    begin();
  }

  @Override
  public boolean apart(BooleanSupplier code) {
    Thread before = owner;
    owner = null;
    try {
      return code.getAsBoolean();
    } finally {
      owner = before;
    }
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
  public ServiceInbox.Delivery receives(ServiceInbox.Delivery waiting) {
    if (waiting != null && kept) {
      part.add(Kind.RECEIVED, waiting.arrivedMicros(), waiting.channel(), waiting.message());
    }
    return waiting;
  }

  @Override
  public boolean takesTime() {
    return true;
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
  public Outlet outlet(Outlet connection) {
    return (channel, message) -> publish(connection, channel, message);
  }

  private boolean publish(Outlet connection, Channel<?> channel, U2SAData message) {
    boolean taken;
    try {
      taken = connection.publish(channel, message);
    } catch (CommunicationException e) {
      if (Clock.runningThread() == owner) {
        ends(); // disconnected: no later message reaches anybody
      }
      throw e;
    }
    if (!kept) {
      return taken;
    }
    if (Clock.runningThread() == owner) {
      part.add(taken ? Kind.PUBLISHED : Kind.REFUSED, 0, channel, message);
    } else if (!channel.equals(Channels.HEALTH)) { // the last may come from the ending thread
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
    if (kept) {
      part.add(kind, micros);
    }
  }

  private void noteWait(long deadlineMicros) {
    note(Kind.WAIT, deadlineMicros);
    if (kept && part.isFull()) {
      handOn();
    }
  }

  private void handOn() {
    long others = elsewhere.get();
    if (kept && others != elsewhereNoted) {
      elsewhereNoted = others;
      part.add(Kind.ELSEWHERE, 0);
    }
    if (kept) {
      part.handOn();
    }
  }

  /** The run's clock; records the readings of the service's thread. */
  private final class NotingClock implements Clock {
    @Override
    public long micros() {
      long now = clock.micros();
      if (kept && Clock.runningThread() == owner) {
        part.addReading(now);
      }
      return now;
    }

    @Override
    public boolean isSimulated() {
      return clock.isSimulated();
    }

    @Override
    public Waiter newWaiter(String waiterName) {
      return new NotingWaiter(clock.newWaiter(waiterName));
    }

    @Override
    public Waiter newWaiter(String waiterName, long spinMicros) {
      return new NotingWaiter(clock.newWaiter(waiterName, spinMicros));
    }

    @Override
    public Waiter newWaiter(Thread thread, Runnable outOfStep) {
      return clock.newWaiter(thread, outOfStep); // for a loop that is not recorded
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
