package org.u2sa.service;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.ServiceStatus;

/**
 * A service's life: it is started, waits on the run's clock, and ends exactly once, however it
 * ends.
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
  private volatile boolean askedToStop; // also before the start, which then does not happen
  private volatile String endReason = "";
  private volatile ServiceStatus status = ServiceStatus.CREATED;
  private volatile Clock.Waiter waiter; // null until started
  private volatile long startedMicros;
  private volatile boolean keepsToOwnThread;

  /**
   * @param spinMicros how long the service's thread looks out before it sleeps [µs]
   */
  ServiceLife(U2SAService service, Clock clock, long spinMicros) {
    this.service = service;
    this.clock = clock;
    this.spinMicros = spinMicros;
    createdMicros = clock.micros();
    service.setUncaughtExceptionHandler((thread, error) -> die(error));
  }

  /** {@link U2SAService#start}, of a service that has its state. */
  void start() {
    service.context().configuration().refuseUndeclared();
    if (!startUnlessAskedToStop()) {
      end();
    }
  }

  /** Excludes {@link #stopWaiting}: a kill comes either before the start or finds the waiter. */
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

  /** Starts; should that fail, it is over as if it had died. */
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

  /**
   * Waits for this thread's first turn, so that services begin in the order in which they were
   * started.
   */
  void awaitTurn() throws InterruptedException {
    waiter.await(clock.micros());
  }

  /**
   * Takes all turns on the calling thread, the service's, and waits on the run's clock between
   * them.
   */
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
   * Waits until the condition holds, the deadline comes or the service is to end; for the service's
   * own thread, inside of its code. Asked again at each {@link #wake}.
   */
  void awaitUntil(BooleanSupplier condition, long deadlineMicros) throws InterruptedException {
    while (service.running && !condition.getAsBoolean() && clock.micros() < deadlineMicros) {
      waiter.await(deadlineMicros);
    }
  }

  /** Ends the present wait of the thread that handles messages. */
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
    service.succession.successor().ifPresent(next -> next.life.askToStop()); // just now
  }

  /** {@link #askToStop} for a reason that the log and {@link #endReason} are to give. */
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
   * {@link U2SAService#run} of a service whose author writes only what happens in its loop.
   *
   * @param begin called once, before anything else
   * @param loop makes, after that, the turns that are over when the service no longer runs
   */
  void run(ServiceHealth.CallbackCode begin, Supplier<Clock.Turns> loop) {
    Optional<Execution> execution = service.context().execution();
    try {
      execution.ifPresent(Execution::begins);
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
      execution.ifPresent(Execution::ends);
      end();
    }
  }

  /** {@link U2SAService#kill} of such a service. */
  void kill() {
    stopWaiting();
    if (Clock.runningThread() == service) {
      return; // the loop ends after the present callback and closes everything
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

  /** Ends the waits of the service's threads for good, wherever they wait. */
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

  /** Lets the loop end as failed. */
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
      stopWaiting(); // everything else is the successor's now
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

  /** Ends without any shutdown step. Returns false if it has ended already. */
  boolean endsNow() {
    if (!ended.compareAndSet(false, true)) {
      return false;
    }
    status = ServiceStatus.STOPPED;
    return true;
  }

  /** Runs one step of the shutdown; if it fails, the others still run. */
  void atLast(String what, Runnable last) {
    try {
      last.run();
    } catch (Exception | Error e) { // also undeclared checked ones
      service.health.error(e.toString());
      service.logFile().log(LogLevelEnum.ERROR, what + " failed", e);
    }
  }

  /** Ends after what the thread cannot survive, as failed. */
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
      helper("-abandoned", this::end).join(RELEASES_WITHIN_MS); // release may hang as well
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      service.wiring.close();
    }
  }

  ServiceStatus status() {
    return status;
  }

  /** Time since the service was made [s]. */
  double uptimeS() {
    return Clock.seconds(clock.micros() - createdMicros);
  }

  /** When the thread was started [µs of the run's clock]. */
  long startedMicros() {
    return startedMicros;
  }
}
