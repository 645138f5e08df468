package org.u2sa.service;

import java.util.OptionalLong;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.inbox.CallbackStopwatch;
import org.u2sa.service.inbox.MessageAge;
import org.u2sa.service.inbox.ServiceInbox;

/**
 * Message loop on a service's thread: delivers messages in order, answers requests of the service
 * contract, reports health, and survives exceptions of the author's code.
 */
final class MessageHandling {
  private final ServiceConfiguration configuration;
  private final ServiceReceiver.Recipient service;
  private final ServiceLife life;
  private final ServiceHealth health;
  private final ContractResponder contract;
  private final ConfigurationWriter writer;
  private final HealthReporter reporter;
  private final Succession succession;
  private final Consumer<U2SAData> callback;
  private final Execution execution;
  private final CallbackStopwatch stopwatch;
  private final BooleanSupplier written;
  private final ServiceHealth.CallbackCode handled = this::handleNext; // reused for all messages
  private ServiceInbox.Delivery next; // argument of handled

  /**
   * @param callback handles messages of channels without a handler
   */
  MessageHandling(
      ServiceReceiver.Recipient service,
      ServiceHealth health,
      ContractResponder contract,
      ConfigurationWriter writer,
      HealthReporter reporter,
      Succession succession,
      Consumer<U2SAData> callback) {
    this.service = service;
    configuration = service.configuration();
    life = service.life();
    this.health = health;
    this.contract = contract;
    this.writer = writer;
    this.reporter = reporter;
    this.succession = succession;
    this.callback = callback;
    execution = configuration.execution();
    stopwatch = health.stopwatch();
    written = writer::hasWritten;
  }

  /**
   * Runs the default loop on the calling service thread, then ends the service.
   *
   * @param begin called once, before anything else
   * @param loop then takes turns until the service no longer runs
   */
  void run(int threadId, ServiceHealth.CallbackCode begin, Supplier<Clock.Turns> loop) {
    try {
      execution.begins();
      life.awaitTurn();
      configuration.log(LogLevelEnum.INFO, "running as thread " + threadId);
      guarded(begin, maxErrorsInARow());
      life.takeAll(loop.get());
    } catch (InterruptedException e) {
      configuration.log(LogLevelEnum.INFO, "interrupted, stopping");
    } catch (RuntimeException | Error e) {
      life.die(e);
    } finally {
      execution.ends();
      life.end();
    }
  }

  int maxErrorsInARow() {
    return configuration.settings().maxErrorsInARow();
  }

  /** Takes turns until the deadline or the end of the service. */
  Clock.Turns until(long untilMicros) {
    return new Round(untilMicros);
  }

  /** Handles messages until a deadline [µs]. */
  private final class Round implements Clock.Turns {
    private final long untilMicros;
    private int first = service.inbox().depth(); // handled even if the deadline has passed

    Round(long untilMicros) {
      this.untilMicros = untilMicros;
    }

    @Override
    public long take() throws InterruptedException {
      stopwatch.pause(); // the thread has waited or done other work
      while (life.isRunning()) {
        if (succession.carryOut()) {
          life.endLoops();
          return OVER;
        }
        if (execution.takesWritten(written)) {
          guarded(writer::handOver, maxErrorsInARow());
          continue;
        }
        long now = stopwatch.runMicros();
        if (reporter.reportIfDue(now)) {
          stopwatch.pause();
        }
        boolean mayHandle = first-- > 0 || now < untilMicros;
        ServiceInbox.Delivery delivery =
            execution.receives(mayHandle ? service.inbox().poll() : null);
        if (execution.takesTime()) {
          stopwatch.pause();
        }
        if (delivery != null) {
          succession.note(delivery);
          next = delivery;
          guarded(handled, maxErrorsInARow());
        } else if (now >= untilMicros) {
          break;
        } else {
          return Math.min(untilMicros, reporter.dueMicros());
        }
      }
      return OVER;
    }
  }

  private void handleNext() {
    ServiceInbox.Delivery delivery = next;
    next = null;
    U2SAData message = delivery.message();
    if (ServiceContract.concerns(configuration.name(), delivery.channel(), message)) {
      contract.answer(message);
    }
    if (service.registrations().isSubscribed(delivery.channel()) && isInTime(delivery)) {
      service.registrations().handlerOr(delivery.channel(), callback).accept(message);
    }
  }

  /** Whether a message meets its channel's deadline; counts it if not. */
  private boolean isInTime(ServiceInbox.Delivery delivery) {
    long deadlineMicros = service.registrations().deadlineMicros(delivery.channel());
    if (deadlineMicros == Clock.NEVER) {
      return true;
    }
    OptionalLong saidMicros = delivery.message().timestamp();
    long ageMicros =
        saidMicros.isPresent()
            ? MessageAge.micros(
                delivery.message(), delivery.arrivedMicros(), configuration.clock().micros())
            : Clock.NEVER;
    if (ageMicros <= deadlineMicros) {
      return true;
    }
    long expired = health.expired();
    if (Long.bitCount(expired) == 1) { // 1, 2, 4, 8…: limits the log
      String age =
          saidMicros.isPresent() ? (ageMicros + 999) / 1_000 / 1e3 + " s old" : "of unknown age";
      String deadline = Clock.seconds(deadlineMicros) + " s (" + expired + " so far): ";
      configuration.log(
          LogLevelEnum.WARN,
          String.format(
              "%s: message %s counts as absent after %s%s",
              delivery.channel(), age, deadline, delivery.message()));
    }
    return false;
  }

  /**
   * Runs the author's code; exceptions are logged, counted and survived, up to a limit in a row.
   * Returns false if it threw.
   */
  boolean guarded(ServiceHealth.CallbackCode code, int maxErrors) throws InterruptedException {
    if (health.run(code)) {
      return true;
    }
    stopwatch.pause(); // logging is slow
    String what = health.lastError().orElse("");
    String inRow = " (exception " + health.exceptionsInRow() + " in a row)";
    boolean where = Long.bitCount(health.exceptions()) == 1; // 1, 2, 4…: limits stack traces
    configuration.log().log(
        LogLevelEnum.ERROR, what + inRow, where ? health.lastException() : null);
    if (health.exceptionsInRow() >= maxErrors) {
      stopAfter(maxErrors == 1 ? "an exception" : maxErrors + " consecutive exceptions");
    }
    return false;
  }

  /** Ends the service as failed. */
  void stopAfter(String what) {
    configuration.log(LogLevelEnum.ERROR, "stopping after " + what);
    life.fail();
  }

  void reportLast() {
    writer.close();
    reporter.reportLast();
  }
}
