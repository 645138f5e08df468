package org.u2sa.recorder.execution;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.recorder.execution.ExecutionEntry.Kind;
import org.u2sa.service.Execution;
import org.u2sa.service.ServiceInstance;
import org.u2sa.service.ServiceRole;
import org.u2sa.service.inbox.ServiceInbox;

/**
 * Replays a recorded execution to a service: clock readings, messages and the end. Its messages go
 * to the course's outputs.
 */
final class RepeatedExecution implements Execution {
  private static final long WRITES_WITHIN_MICROS = 10 * Clock.MICROS_PER_SECOND;
  private static final long LOOKS_EVERY_MICROS = 1_000;

  private final RecordedCourse course;
  private final Clock machine;
  private final int threadId;
  private final Optional<Inheritance> inheritance;
  private volatile Thread owner;
  private ServiceInstance service;

  /**
   * @param outputs receives the service's messages
   * @param machine real-time clock, for waiting for the disk
   * @param recordedThreadId thread ID of the service in the recording
   * @param inheritance state inherited from the replaced service, if any
   */
  RepeatedExecution(
      ExecutionReader recorded,
      RecordedCourse.Outputs outputs,
      Clock machine,
      int recordedThreadId,
      Optional<Inheritance> inheritance) {
    course = new RecordedCourse(recorded, outputs, this::stop);
    threadId = recordedThreadId;
    this.inheritance = inheritance;
    this.machine = machine;
    owner = Thread.currentThread();
  }

  RecordedCourse course() {
    return course;
  }

  private void stop() {
    if (Thread.currentThread() == service) {
      service.kill(); // its loop ends after the current step
    }
  }

  /** Sensors, actuators, launchers and observers act outside the execution. */
  @Override
  public void requireRole(ServiceRole role) {
    if (!KeptExecution.isRepeatable(role)) {
      throw new BadInputException(
          "a service of role "
              + role
              + " is not re-executed: it may open devices, connections or files chosen by the "
              + "recording");
    }
  }

  @Override
  public boolean writesNamedFiles() {
    return false;
  }

  @Override
  public Clock clock(Clock run) {
    return new RepeatedClock();
  }

  @Override
  public int threadId(int own) {
    return threadId;
  }

  @Override
  public void made(ServiceInstance made) {
    service = made;
    course.passIf(Kind.MADE);
    owner = null;
  }

  @Override
  public Optional<Inheritance> inheritance() {
    return inheritance;
  }

  @Override
  public void onBehalf(Runnable code) {
    owner = Thread.currentThread();
    try {
      code.run();
    } finally {
      owner = null;
    }
  }

  @Override
  public void succeeds(Inheritance inherited, String connection) {
    throw new IllegalStateException("no running service to replace");
  }

  @Override
  public void begins() {
    owner = Thread.currentThread();
  }

  @Override
  public void steps() {
    course.passIf(Kind.STEP);
  }

  @Override
  public ServiceInbox.Delivery receives(ServiceInbox.Delivery waiting) {
    RecordedMessage.Handled next = course.receive();
    return next == null
        ? null
        : new ServiceInbox.Delivery(next.channel(), next.message(), next.arrivedMicros());
  }

  @Override
  public boolean takesTime() {
    return true;
  }

  @Override
  public boolean takesWritten(BooleanSupplier isWritten) throws InterruptedException {
    if (!course.takesWritten()) {
      return false;
    }
    long until = machine.micros() + WRITES_WITHIN_MICROS;
    try (Clock.Waiter waiter = machine.newWaiter("repeat")) {
      while (!isWritten.getAsBoolean() && machine.micros() < until) {
        waiter.await(machine.micros() + LOOKS_EVERY_MICROS);
      }
    }
    return isWritten.getAsBoolean();
  }

  @Override
  public Outlet outlet(Outlet connection) {
    // Work at a service's end or on its own threads is not repeated.
    return (channel, message) ->
        Thread.currentThread() != owner || course.isOver() || course.publish(channel, message);
  }

  @Override
  public void ends() {
    course.end();
    owner = null;
  }

  /** Clock that returns the recorded readings. */
  private final class RepeatedClock implements Clock {
    @Override
    public long micros() {
      return Thread.currentThread() == owner ? course.read() : course.micros();
    }

    @Override
    public boolean isSimulated() {
      return true;
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
        course.await(deadlineMicros);
      }
    }

    @Override
    public void signal() {
      // the recording determines when a wait ends
    }

    @Override
    public void close() {
      // no thread waits
    }
  }
}
