package org.u2sa.service;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ServiceStatus;

/**
 * Life cycle of a service: starts, waits on the run's clock, and ends exactly once, whatever the
 * cause.
 */
final class ServiceLife {
  private static final long ENDS_BY_ITSELF_WITHIN_MS = 200;
  private static final long ENDS_AFTER_KILL_WITHIN_MS = 2_000;
  private static final long RELEASES_WITHIN_MS = 2_000;

  private final U2SAService service;
  private final Clock clock;
  private final long spinMicros;
  private final long createdMicros;
  private final AtomicBoolean ended = new AtomicBoolean();
  private volatile boolean askedToStop; // may precede the start, which is then skipped
  private volatile String endReason = "";
  private volatile ServiceStatus status = ServiceStatus.CREATED;
  private volatile Clock.Waiter waiter; // null until started
  private volatile long startedMicros;
  private volatile boolean keepsToOwnThread;

  /**
   * @param spinMicros how long the service's thread spins before it sleeps [µs]
   */
  ServiceLife(U2SAService service, Clock clock, long spinMicros) {
    this.service = service;
    this.clock = clock;
    this.spinMicros = spinMicros;
    createdMicros = clock.micros();
    service.setUncaughtExceptionHandler((thread, error) -> die(error));
  }

  /** {@link U2SAService#start}, for a service whose state is restored. */
  void start() {
    service.context().configuration().refuseUndeclared();
    if (!startUnlessAskedToStop()) {
      end();
    }
  }

  /**
   * Mutually exclusive with {@link #stopWaiting}: a kill either precedes the start or finds the
   * waiter.
   */
  private synchronized boolean startUnlessAskedToStop() {
    if (service.getState() != Thread.State.NEW || ended.get()) {
      throw new IllegalThreadStateException(
          "service " + service.getName() + " was started or killed before; make a new one");
    }
    if (askedToStop) {
      return false;
    }
    waiter = clock.newWaiter(service.getName(), spinMicros);
    startedMicros = clock.micros();
    service.running = true;
    status = ServiceStatus.RUNNING;
    if (service.loop != null) {
      service.loop.begin();
    }
    service.startThread();
    return true;
  }

  /** Starts the thread; if that fails, the service ends as if it had died. */
  void startAsSuccessor() {
    try {
      service.start();
    } catch (RuntimeException | Error e) {
      die(e);
    }
  }

  private Thread helper(String suffix, Runnable does) {
    Thread helper = new Thread(does, service.getName() + suffix);
    helper.setDaemon(true);
    helper.start();
    return helper;
  }

  /** Waits for this thread's first turn, so that services run in start order. */
  void awaitTurn() throws InterruptedException {
    waiter.await(clock.micros());
  }

  /** Takes all turns on the calling service thread, waiting on the run's clock in between. */
  void takeAll(Clock.Turns turns) throws InterruptedException {
    for (long next = turns.take(); next != Clock.Turns.OVER; next = turns.take()) {
      waiter.await(next);
    }
  }

  /** {@link U2SAService#keepToOwnThread}. */
  void keepToOwnThread() {
    keepsToOwnThread = true;
  }

  /**
   * Waits for the condition, the deadline or the end of the service; called by the author's code on
   * the service's thread. The condition is re-evaluated at each {@link #wake}.
   */
  void awaitUntil(BooleanSupplier condition, long deadlineMicros) throws InterruptedException {
    while (service.running && !condition.getAsBoolean() && clock.micros() < deadlineMicros) {
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

  /** Asks the loop to stop, without waiting for it. */
  void askToStop() {
    askedToStop = true;
    service.running = false;
    wake();
    service.succession.successor().ifPresent(next -> next.life.askToStop()); // a new one
  }

  /** {@link #askToStop} with a reason for the log and {@link #endReason}. */
  void stopFor(String reason) {
    if (!askedToStop) {
      endReason = reason;
      service.log(LogLevelEnum.INFO, reason);
    }
    askToStop();
  }

  boolean isAskedToStop() {
    return askedToStop;
  }

  /** {@link U2SAService#endReason}. */
  Optional<String> endReason() {
    return Optional.of(endReason).filter(reason -> !reason.isEmpty());
  }

  /**
   * {@link U2SAService#run} of a service whose author writes only the loop's body.
   *
   * @param begin called once, before anything else
   * @param loop then takes turns until the service no longer runs
   */
  void run(ServiceHealth.CallbackCode begin, Supplier<Clock.Turns> loop) {
    Execution execution = service.context().execution();
    try {
      execution.begins();
      awaitTurn();
      service.log("running as thread " + service.threadID);
      service.handling.guarded(begin);
      if (keepsToOwnThread) {
        takeAll(loop.get());
      } else {
        waiter.lend(loop.get());
      }
    } catch (InterruptedException e) {
      service.log("interrupted, stopping");
    } catch (RuntimeException | Error e) {
      die(e);
    } finally {
      execution.ends();
      end();
    }
  }

  /** {@link U2SAService#kill} of such a service. */
  void kill() {
    stopWaiting();
    if (Clock.runningThread() == service) {
      return; // the loop ends after the current callback and closes everything
    }
    boolean interrupted = false;
    try {
      service.join(ENDS_AFTER_KILL_WITHIN_MS);
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

  /** Permanently ends all waits of the service's threads. */
  synchronized void stopWaiting() {
    askedToStop = true;
    service.running = false;
    Clock.Waiter waiting = waiter;
    if (waiting != null) {
      waiting.close();
    }
    if (service.loop != null) {
      service.loop.stopSleeping();
    }
  }

  /** Makes the loop end as failed. */
  void fail() {
    status = ServiceStatus.FAILED;
    service.running = false;
  }

  /** {@link U2SAService#end}. */
  void end() {
    if (!ended.compareAndSet(false, true)) {
      return;
    }
    service.running = false;
    if (service.loop != null) {
      service.loop.close();
    }
    if (service.succession.handsOverInsteadOfEnding()) {
      status = ServiceStatus.STOPPED;
      stopWaiting(); // everything else belongs to the successor now
      return;
    }
    boolean failed = status == ServiceStatus.FAILED;
    status = failed ? ServiceStatus.FAILED : ServiceStatus.STOPPING;
    atLast("closing", service::release);
    status = failed ? ServiceStatus.FAILED : ServiceStatus.STOPPED;
    atLast("the last health report", service.handling::reportLast);
    service.log(LogLevelEnum.INFO, "ended: " + status);
    atLast("ending the communication", service.wiring::close);
    stopWaiting();
    service.logFile().close();
  }

  /** Ends without any shutdown steps. Returns false if already ended. */
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
      service.health.error(e.toString());
      service.logFile().log(LogLevelEnum.ERROR, what + " failed", e);
    }
  }

  /** Ends as failed after a fatal error of the thread. */
  void die(Throwable error) {
    if (!ended.get()) {
      service.health.died(error.toString());
      service.logFile().log(LogLevelEnum.ERROR, "the thread died", error);
      status = ServiceStatus.FAILED;
    }
    end();
  }

  /** {@link U2SAService#abandon}. */
  void abandon() {
    stopWaiting();
    service.interrupt();
    if (service.loop != null) {
      service.loop.messages().interrupt();
    }
    try {
      service.join(ENDS_BY_ITSELF_WITHIN_MS);
      helper("-abandoned", this::end).join(RELEASES_WITHIN_MS); // release may also hang
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      service.wiring.close();
    }
  }

  ServiceStatus status() {
    return status;
  }

  /** Time since construction [s]. */
  double uptimeS() {
    return Clock.seconds(clock.micros() - createdMicros);
  }

  /** Start time of the thread [µs of the run's clock]. */
  long startedMicros() {
    return startedMicros;
  }
}
