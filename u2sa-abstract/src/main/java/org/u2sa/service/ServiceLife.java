package org.u2sa.service;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ServiceStatus;

/** Life cycle of a service: starts, waits on the run's clock, and ends exactly once. */
final class ServiceLife {
  private static final long ENDS_BY_ITSELF_WITHIN_MS = 200;
  private static final long ENDS_AFTER_KILL_WITHIN_MS = 2_000;
  private static final long RELEASES_WITHIN_MS = 2_000;
  private static final long MESSAGES_END_WITHIN_MS = 4_000; // includes waiting for the loop

  private final Thread thread;
  private final ServiceConfiguration configuration;
  private final ServiceHealth health;
  private final AuthoredLoop loop; // null: the thread runs the default loop
  private final Host host;
  private final Clock clock;
  private final long createdMicros;
  private final AtomicBoolean ended = new AtomicBoolean();
  private volatile boolean askedToStop; // may precede the start, which is then skipped
  private volatile String endReason = "";
  private volatile ServiceStatus status = ServiceStatus.CREATED;
  private volatile Clock.Waiter waiter; // null until started
  private volatile long startedMicros;
  private volatile boolean keepsToOwnThread;
  private volatile boolean patient;
  private volatile ServiceLife successor; // null until one has taken over

  /**
   * The service as its life cycle sees it.
   *
   * @param refuseSwap refuses a pending swap
   * @param release closes what its author opened
   */
  record Host(
      BooleanSupplier isRunning,
      Consumer<Boolean> setRunning,
      Runnable startThread,
      Runnable refuseSwap,
      Runnable release,
      Runnable reportLast,
      Runnable disconnect) {}

  /**
   * @param thread not started
   * @param loop null if the thread runs the default loop
   */
  ServiceLife(
      Thread thread,
      ServiceConfiguration configuration,
      ServiceHealth health,
      AuthoredLoop loop,
      Host host) {
    this.thread = thread;
    this.configuration = configuration;
    this.health = health;
    this.loop = loop;
    this.host = host;
    clock = configuration.clock();
    createdMicros = clock.micros();
    thread.setUncaughtExceptionHandler((dead, error) -> die(error));
  }

  /** {@link U2SAService#start}, for a service whose state is restored. */
  void start() {
    configuration.variables().refuseUndeclared();
    if (!startUnlessAskedToStop()) {
      end();
    }
  }

  /** Excludes {@link #stopWaiting}: a kill either precedes the start or finds the waiter. */
  private synchronized boolean startUnlessAskedToStop() {
    if (thread.getState() != Thread.State.NEW || ended.get()) {
      throw new IllegalThreadStateException(
          "service "
              + configuration.name()
              + " was started or killed before; create a new "
              + "instance");
    }
    if (askedToStop) {
      return false;
    }
    waiter = clock.newWaiter(configuration.name(), (long) configuration.settings().spin());
    startedMicros = clock.micros();
    host.setRunning.accept(true);
    status = ServiceStatus.RUNNING;
    if (loop != null) {
      loop.begin(startedMicros);
    }
    host.startThread.run();
    return true;
  }

  boolean isRunning() {
    return host.isRunning.getAsBoolean();
  }

  void endLoops() {
    host.setRunning.accept(false);
  }

  /** Waits for this thread's first turn, so that services run in start order. */
  void awaitTurn() throws InterruptedException {
    waiter.await(clock.micros());
  }

  /**
   * Runs all turns on the calling service thread, unless it {@linkplain #keepToOwnThread keeps to
   * itself}.
   */
  void takeAll(Clock.Turns turns) throws InterruptedException {
    if (!keepsToOwnThread) {
      waiter.lend(turns);
      return;
    }
    for (long next = turns.take(); next != Clock.Turns.OVER; next = turns.take()) {
      waiter.await(next);
    }
  }

  /** {@link U2SAService#keepToOwnThread}. */
  void keepToOwnThread() {
    keepsToOwnThread = true;
  }

  /** Defers non-urgent messages until the service's next scheduled wake-up. */
  void bePatient() {
    patient = true;
  }

  /**
   * Waits on the service's thread for the condition, the deadline or the end of the service. The
   * condition is re-evaluated at each {@link #wake}.
   */
  void awaitUntil(BooleanSupplier condition, long deadlineMicros) throws InterruptedException {
    while (isRunning() && !condition.getAsBoolean() && clock.micros() < deadlineMicros) {
      waiter.await(deadlineMicros);
    }
  }

  /** Wakes the message-handling thread. */
  void wake() {
    Clock.Waiter waiting = waiter;
    if (waiting != null) {
      waiting.signal();
    }
  }

  /** {@link #wake} for a message on the channel, unless it can wait. */
  void wakeFor(Channel<?> channel) {
    if (channel.isUrgent() || !patient) {
      wake();
    }
  }

  /** Asks the loop to stop, without waiting. */
  void askToStop() {
    askedToStop = true;
    endLoops();
    wake();
    ServiceLife next = successor;
    if (next != null) {
      next.askToStop();
    }
  }

  /** {@link #askToStop} with a reason for the log and {@link #endReason}. */
  void stopFor(String reason) {
    if (!askedToStop) {
      endReason = reason;
      configuration.log(LogLevelEnum.INFO, reason);
    }
    askToStop();
  }

  boolean isAskedToStop() {
    return askedToStop;
  }

  /** Records that another service has taken over with all resources. */
  void succeededBy(ServiceLife next) {
    successor = next;
  }

  /** {@link U2SAService#endReason}. */
  Optional<String> endReason() {
    return Optional.of(endReason).filter(reason -> !reason.isEmpty());
  }

  /** {@link U2SAService#kill} of a service with the default loop. */
  void kill() {
    stopWaiting();
    if (Clock.runningThread() == thread) {
      return; // the loop ends after the current callback and closes everything
    }
    boolean interrupted = false;
    try {
      thread.join(ENDS_AFTER_KILL_WITHIN_MS);
    } catch (InterruptedException e) {
      interrupted = true;
    }
    // A thread that was never started, or that hangs in its callback, cannot close its own
    // resources.
    end();
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  /** Ends a killed service with an authored loop, and returns when it has ended. */
  void finishLoop() {
    Thread caller = Clock.runningThread();
    if (caller == thread || caller == loop.messages()) {
      return; // it ends after the present pass or callback
    }
    stopWaiting();
    try {
      loop.messages().join(MESSAGES_END_WITHIN_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    end(); // if it was never started, or hangs in a callback
  }

  /** Ends all waits of the service's threads permanently. */
  synchronized void stopWaiting() {
    askedToStop = true;
    endLoops();
    Clock.Waiter waiting = waiter;
    if (waiting != null) {
      waiting.close();
    }
    if (loop != null) {
      loop.stopSleeping();
    }
  }

  void fail() {
    status = ServiceStatus.FAILED;
    endLoops();
  }

  /** {@link U2SAService#end}. */
  void end() {
    if (!ended.compareAndSet(false, true)) {
      return;
    }
    endLoops();
    if (loop != null) {
      loop.close();
    }
    if (successor != null) {
      status = ServiceStatus.STOPPED;
      stopWaiting(); // everything else belongs to the successor now
      return;
    }
    host.refuseSwap.run();
    boolean failed = status == ServiceStatus.FAILED;
    status = failed ? ServiceStatus.FAILED : ServiceStatus.STOPPING;
    atLast("closing", host.release);
    status = failed ? ServiceStatus.FAILED : ServiceStatus.STOPPED;
    atLast("the last health report", host.reportLast);
    atLast("the last log line", () -> configuration.log(LogLevelEnum.INFO, "ended: " + status));
    atLast("ending the communication", host.disconnect);
    stopWaiting();
    configuration.log().close();
  }

  /** Ends without any shutdown steps; false if already ended. */
  boolean endsNow() {
    if (!ended.compareAndSet(false, true)) {
      return false;
    }
    status = ServiceStatus.STOPPED;
    return true;
  }

  /** Runs one shutdown step; a failure does not prevent the others. */
  void atLast(String what, Runnable last) {
    try {
      last.run();
    } catch (Exception | Error e) { // including undeclared checked ones
      tell(what, e);
    }
  }

  private void tell(String what, Throwable failure) {
    try {
      health.error(failure.toString());
      configuration.log().log(LogLevelEnum.ERROR, what + " failed", failure);
    } catch (Exception | Error e) { // such as a full heap
      e.printStackTrace();
    }
  }

  /** Ends as failed after a fatal error. */
  void die(Throwable error) {
    if (!ended.get()) {
      health.died(error.toString());
      configuration.log().log(LogLevelEnum.ERROR, "the thread died", error);
      status = ServiceStatus.FAILED;
    }
    end();
  }

  /** {@link U2SAService#abandon}. */
  void abandon() {
    stopWaiting();
    thread.interrupt();
    if (loop != null) {
      loop.messages().interrupt();
    }
    try {
      thread.join(ENDS_BY_ITSELF_WITHIN_MS);
      Thread helper = new Thread(this::end, configuration.name() + "-abandoned");
      helper.setDaemon(true);
      helper.start();
      helper.join(RELEASES_WITHIN_MS); // release may also hang
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      host.disconnect.run();
    }
  }

  ServiceStatus status() {
    return status;
  }

  double uptimeS() {
    return Clock.seconds(clock.micros() - createdMicros);
  }

  long startedMicros() {
    return startedMicros;
  }
}
