package org.u2sa.service;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ServiceStatus;

/**
 * The part of a service that has a life: it is started, waits on the run's clock, and ends exactly
 * once, however it ends.
 */
abstract class LivingService extends CommunicatingService {
  /** Identifies the service's thread in the log (thesis 8.2.3.1). */
  protected final int threadID;

  /**
   * Whether the service's loop should go on (thesis 8.2.3.1). Cleared by {@link #kill} and the stop
   * command.
   */
  protected volatile boolean running;

  private final ServiceHealth health = new ServiceHealth();
  private final long createdMicros;
  private final AtomicBoolean ended = new AtomicBoolean();
  private volatile boolean askedToStop; // also before the start, which then does not happen
  private volatile String endReason = "";
  private volatile ServiceStatus status = ServiceStatus.CREATED;
  private volatile Clock.Waiter waiter; // null until started
  private volatile long startedMicros;

  LivingService(ServiceContext context, ServiceRole role, String serviceName) {
    super(context, role, serviceName);
    threadID = (int) getId();
    createdMicros = clock().micros();
    setUncaughtExceptionHandler((thread, error) -> die(error));
  }

  /** The service's life; called by {@link #start} on the new thread. */
  @Override
  public abstract void run();

  /**
   * Ends the service: its loop stops, its resources are closed, its actuators left neutral. Safe to
   * call twice and from any thread; returns when the service has ended.
   */
  public abstract void kill();

  /**
   * Closes what the subclass opened and leaves its actuators neutral. Called once when the service
   * ends.
   */
  protected void release() {}

  /** Reports how the service is, for the last time. */
  abstract void reportLast();

  /** Whether another service has its place and all that it holds, so that there is no end. */
  abstract boolean handsOverInsteadOfEnding();

  /** Whether {@link #run} calls {@link #end} whatever happens. */
  abstract boolean endsSurely();

  /**
   * Starts the thread. A service that was told to stop before ends without having run.
   *
   * @throws org.u2sa.interfaces.configuration.ConfigurationException if the configuration holds a
   *     variable that the service does not know
   * @throws IllegalThreadStateException if it was started or killed before
   */
  @Override
  public void start() {
    context().configuration().refuseUndeclared();
    if (!startUnlessAskedToStop()) {
      end();
    } else if (!endsSurely()) {
      new EndKeeper(this).watch();
    }
  }

  /** Excludes {@link #stopWaiting}: a kill comes either before the start or finds the waiter. */
  private synchronized boolean startUnlessAskedToStop() {
    if (getState() != State.NEW || ended.get()) {
      throw new IllegalThreadStateException(
          "service " + getName() + " was started or killed before; make a new one");
    }
    if (askedToStop) {
      return false;
    }
    waiter = clock().newWaiter(getName());
    startedMicros = clock().micros();
    running = true;
    status = ServiceStatus.RUNNING;
    super.start();
    return true;
  }

  /**
   * Waits for this thread's first turn, so that services begin in the order in which they were
   * started.
   */
  final void awaitTurn() throws InterruptedException {
    waiter.await(clock().micros());
  }

  /** Waits on the run's clock until {@link #wake} or the deadline. */
  final void await(long untilMicros) throws InterruptedException {
    waiter.await(untilMicros);
  }

  /** Asks the loop to stop, without waiting for it. */
  void askToStop() {
    askedToStop = true;
    running = false;
    wake();
  }

  /** {@link #askToStop} for a reason that the log and {@link #endReason} are to give. */
  final void stopFor(String reason) {
    if (!askedToStop) {
      endReason = reason;
      log(LogLevelEnum.INFO, reason);
    }
    askToStop();
  }

  /** Why the service ends or has ended, if a message made it end; otherwise empty. */
  public final Optional<String> endReason() {
    return Optional.of(endReason).filter(reason -> !reason.isEmpty());
  }

  final boolean isAskedToStop() {
    return askedToStop;
  }

  /**
   * Waits until the condition holds, the deadline comes or the service is to end; for the service's
   * own thread, inside of its code. Asked again at each {@link #wake}.
   */
  final void awaitUntil(BooleanSupplier condition, long deadlineMicros)
      throws InterruptedException {
    while (running && !condition.getAsBoolean() && clock().micros() < deadlineMicros) {
      waiter.await(deadlineMicros);
    }
  }

  /** Whether messages that are not urgent may wait until the service wakes by itself. */
  boolean isPatient() {
    return false;
  }

  /** Ends the present wait of the service's thread. */
  final void wake() {
    Clock.Waiter waiting = waiter;
    if (waiting != null) {
      waiting.signal();
    }
  }

  /** Ends the wait of the service's thread for good, wherever it waits. */
  final synchronized void stopWaiting() {
    askedToStop = true;
    running = false;
    Clock.Waiter waiting = waiter;
    if (waiting != null) {
      waiting.close();
    }
  }

  /** Lets the loop end as failed. */
  final void fail() {
    status = ServiceStatus.FAILED;
    running = false;
  }

  /**
   * Releases everything, once: the last act of {@link #run} and of a direct subclass's {@link
   * #kill}.
   */
  protected final void end() {
    if (!ended.compareAndSet(false, true)) {
      return;
    }
    running = false;
    if (handsOverInsteadOfEnding()) {
      status = ServiceStatus.STOPPED;
      stopWaiting(); // everything else is the successor's now
      return;
    }
    boolean failed = status == ServiceStatus.FAILED;
    status = failed ? ServiceStatus.FAILED : ServiceStatus.STOPPING;
    atLast("closing", this::release);
    status = failed ? ServiceStatus.FAILED : ServiceStatus.STOPPED;
    atLast("the last health report", this::reportLast);
    log(LogLevelEnum.INFO, "ended: " + status);
    atLast("ending the communication", wiring()::close);
    stopWaiting();
    logFile().close();
  }

  /** Takes the end for itself. Returns false if it has ended already. */
  final boolean endsNow() {
    if (!ended.compareAndSet(false, true)) {
      return false;
    }
    status = ServiceStatus.STOPPED;
    return true;
  }

  /** Does one of the last things; should it fail, the others are done all the same. */
  final void atLast(String what, Runnable last) {
    try {
      last.run();
    } catch (Exception | Error e) { // also undeclared checked ones
      health.error(e.toString());
      logFile().log(LogLevelEnum.ERROR, what + " failed", e);
    }
  }

  /** Ends after what the thread cannot survive, as failed. */
  final void die(Throwable error) {
    if (!ended.get()) {
      health.died(error.toString());
      logFile().log(LogLevelEnum.ERROR, "the thread died", error);
      status = ServiceStatus.FAILED;
    }
    end();
  }

  /**
   * Gives a service up whose code does not return: Java cannot end its thread. It is interrupted;
   * if that does not help, its actuators are left neutral from another thread and it is cut off:
   * what it still publishes is refused, nothing reaches it any more, and its name is free. Returns
   * within a few seconds in any case.
   */
  public final void abandon() {
    new EndKeeper(this).abandon();
  }

  /** Whether the service's loop goes on. */
  public final boolean isRunning() {
    return running;
  }

  /** {@link #threadID}. */
  public final int getThreadID() {
    return threadID;
  }

  /** Where the service is in its life. */
  public final ServiceStatus status() {
    return status;
  }

  /** Time since the service was made [s]. */
  final double uptimeS() {
    return Clock.seconds(clock().micros() - createdMicros);
  }

  /** When the thread was started [µs of the run's clock]. */
  final long startedMicros() {
    return startedMicros;
  }

  final ServiceHealth health() {
    return health;
  }
}
