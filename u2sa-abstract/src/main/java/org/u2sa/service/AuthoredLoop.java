package org.u2sa.service;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;

/**
 * Runs an author's {@link U2SAService#run} loop in parallel to a thread that handles the service's
 * messages (thesis 8.2.4). A simulation waits for each {@link U2SAService#sleep} of the loop, but
 * not where it blocks elsewhere, such as in {@link Thread#sleep}.
 */
final class AuthoredLoop {
  /** Polling period of the field that an author's kill clears. */
  private static final long POLLS_EVERY_MICROS = 250_000;

  private static final long ENDS_WITHIN_MS = 1_000;
  private static final long ENDS_AFTER_INTERRUPT_WITHIN_MS = 200;
  private static final long MICROS_PER_MILLI = 1_000;

  private final Thread thread;
  private final ServiceConfiguration configuration;
  private final Registrations registrations;
  private final BooleanSupplier isRunning;
  private final Runnable kill;
  private final Clock clock;
  private final Thread messages;
  private final AtomicBoolean closed = new AtomicBoolean();
  private volatile Clock.Waiter waiter; // of the loop's thread; null until started
  private long startedMicros; // written before the messages' thread starts
  private boolean hasTurn; // touched by the loop's thread only
  private volatile boolean isLoop; // run() has lasted, or has slept
  private boolean hasReturned; // touched by the messages' thread only

  /**
   * @param handleMessages body of the thread that handles messages; takes {@link #turns}
   * @param kill clears {@code isRunning} and calls the author's kill()
   */
  AuthoredLoop(
      Thread thread,
      ServiceConfiguration configuration,
      Registrations registrations,
      BooleanSupplier isRunning,
      Runnable handleMessages,
      Runnable kill) {
    this.thread = thread;
    this.configuration = configuration;
    this.registrations = registrations;
    this.isRunning = isRunning;
    this.kill = kill;
    clock = configuration.clock();
    messages = new Thread(handleMessages, configuration.name() + "-messages");
    messages.setDaemon(true);
  }

  /** Starts handling messages; the loop's thread starts afterwards. */
  void begin(long nowMicros) {
    startedMicros = nowMicros;
    waiter = clock.newWaiter(thread, this::outOfStep);
    messages.start();
  }

  private void outOfStep() {
    configuration.log(
        LogLevelEnum.WARN,
        "run() waits for something other than the run's clock, so the simulation continues without"
            + " it: with sleep(…) in place of Thread.sleep(…) the simulation waits for it");
  }

  Thread messages() {
    return messages;
  }

  /** Turns of the thread that handles messages, which also watches the loop. */
  Clock.Turns turns(Clock.Turns handling) {
    return () -> {
      checkLoop();
      long next = handling.take();
      return next == Clock.Turns.OVER
          ? Clock.Turns.OVER
          : Math.min(next, clock.micros() + POLLS_EVERY_MICROS);
    };
  }

  /**
   * A loop that returns while the service should continue has failed; a run() that returns
   * immediately is not a loop.
   */
  private void checkLoop() {
    if (hasReturned || !isRunning.getAsBoolean()) {
      return;
    }
    if (thread.getState() != Thread.State.TERMINATED) {
      isLoop |= clock.micros() - startedMicros >= POLLS_EVERY_MICROS;
      return;
    }
    hasReturned = true;
    if (isLoop || registrations.subscribed().isEmpty()) {
      throw new IllegalStateException("run() returned while running was true");
    }
  }

  /** Waits for the loop thread's first turn, so that services run in start order. */
  void awaitTurn() {
    if (Thread.currentThread() != thread || hasTurn) {
      return;
    }
    hasTurn = true;
    try {
      waiter.await(clock.micros());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // for the author's next wait
    }
  }

  /** {@link U2SAService#sleep}, on the loop's thread. */
  void sleep(long millis) throws InterruptedException {
    if (!isRunning.getAsBoolean()) {
      Thread.sleep(millis); // ending: no longer waits on the run's clock
      return;
    }
    hasTurn = true;
    isLoop = true;
    long untilMicros = clock.micros() + Math.multiplyExact(millis, MICROS_PER_MILLI);
    do {
      waiter.await(untilMicros);
    } while (isRunning.getAsBoolean() && clock.micros() < untilMicros);
  }

  void stopSleeping() {
    Clock.Waiter sleeping = waiter;
    if (sleeping != null) {
      sleeping.close();
    }
  }

  /** Calls the author's cleanup and waits for the loop to end; once. */
  void close() {
    if (!closed.compareAndSet(false, true)) {
      return;
    }
    kill.run();
    stopSleeping();
    if (Thread.currentThread() != thread && !hasEnded()) {
      configuration.log(LogLevelEnum.WARN, "run() has not returned although running is false");
    }
  }

  private boolean hasEnded() {
    try {
      thread.join(ENDS_WITHIN_MS);
      if (thread.isAlive()) {
        thread.interrupt();
        thread.join(ENDS_AFTER_INTERRUPT_WITHIN_MS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return !thread.isAlive();
  }
}
