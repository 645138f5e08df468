package org.u2sa.service;

import java.util.OptionalLong;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.time.Clock;

/**
 * A service that runs at a fixed rate: its author writes {@link #step} and one handler per
 * {@linkplain #subscribe subscribed} channel.
 *
 * <p>Steps are due on a fixed time grid; messages are handled in between. A step more than one
 * period late is counted as an overrun in the health report; missed steps are skipped.
 */
public abstract class PeriodicService extends U2SAService {
  private static final double FASTEST_HZ = 10_000.0;
  private static final double SLOWEST_HZ = 0.001;

  private final long periodMicros;
  private int maxErrorsInSteps; // in a row
  private int failedSteps; // likewise
  private long dueMicros; // used by the service's thread, and before its start by the predecessor's
  private boolean hasSucceeded;

  /** See {@link U2SAService#U2SAService}; the variable RATE overrides {@code defaultRateHz}. */
  protected PeriodicService(
      ServiceContext context, ServiceRole role, String serviceName, double defaultRateHz) {
    this(context, role, serviceName, defaultRateHz, SLOWEST_HZ);
  }

  /**
   * For a service that protects others.
   *
   * @param slowestHz lowest RATE at which it still does
   */
  protected PeriodicService(
      ServiceContext context,
      ServiceRole role,
      String serviceName,
      double defaultRateHz,
      double slowestHz) {
    super(context, role, serviceName);
    periodMicros = Math.max(1, Clock.micros(1.0 / getVariable(rate(defaultRateHz, slowestHz))));
    maxErrorsInSteps = handling.maxErrorsInARow();
  }

  private static VariableDeclaration<Double> rate(double defaultRateHz, double slowestHz) {
    return VariableDeclaration.number("RATE", "Hz")
        .range(Range.of(slowestHz, FASTEST_HZ))
        .ifAbsent(defaultRateHz)
        .describedAs("Steps per second.");
  }

  /** Performs one step at {@code nowS} of the run's clock [s]. */
  protected abstract void step(double nowS);

  /**
   * Defers all but urgent messages to the next step: for a service that receives many and acts
   * rarely. Called in the constructor.
   */
  protected final void handleMessagesAtSteps() {
    life.bePatient();
  }

  /**
   * Ends the service as failed at the first step that throws, so that it is restarted immediately.
   * Called in the constructor.
   */
  protected final void failAtFirstError() {
    maxErrorsInSteps = 1;
  }

  @Override
  final void succeeds(U2SAService predecessor) {
    super.succeeds(predecessor);
    if (predecessor instanceof PeriodicService before) { // neither an extra step nor a gap
      firstStepAt(Math.min(before.dueMicros, clock().micros() + periodMicros));
    }
  }

  @Override
  final void firstStepAt(long micros) {
    hasSucceeded = true;
    dueMicros = micros;
  }

  @Override
  final OptionalLong firstStepMicros() {
    return hasSucceeded ? OptionalLong.of(dueMicros) : OptionalLong.empty();
  }

  /** Time between two steps [s]. */
  protected final double periodS() {
    return Clock.seconds(periodMicros);
  }

  /** Called once on the service's thread before its first message or step. */
  protected void begin() {}

  @Override
  public final void run() {
    handling.run(threadID, this::begin, this::stepByStep);
  }

  @Override
  final boolean hasReadyMadeLoop() {
    return true;
  }

  @Override
  public final void kill() {
    life.kill();
  }

  private Clock.Turns stepByStep() {
    if (!hasSucceeded) {
      dueMicros = clock().micros();
    }
    return new Steps();
  }

  /** Runs each step when due and handles messages in between. */
  private final class Steps implements Clock.Turns {
    private Clock.Turns messages = handling.until(dueMicros);

    @Override
    public long take() throws InterruptedException {
      while (isRunning()) {
        long next = messages.take();
        if (next != OVER) {
          return next;
        }
        if (isRunning()) {
          context().execution().steps();
          count(handling.guarded(() -> step(nowS()), maxErrorsInSteps));
          scheduleNext();
          messages = handling.until(dueMicros);
        }
      }
      return OVER;
    }
  }

  /** Counts steps only: messages handled in between do not show that the service works. */
  private void count(boolean succeeded) {
    failedSteps = succeeded ? 0 : failedSteps + 1;
    if (failedSteps >= maxErrorsInSteps && isRunning()) {
      handling.stopAfter(failedSteps + " consecutive steps that threw");
    }
  }

  private void scheduleNext() {
    dueMicros += periodMicros;
    long lateMicros = clock().micros() - dueMicros;
    if (lateMicros > periodMicros) {
      long missed = lateMicros / periodMicros;
      health.overrun(missed);
      dueMicros += missed * periodMicros;
    }
  }
}
