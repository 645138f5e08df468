package org.u2sa.service;

import java.util.OptionalLong;
import java.util.function.Consumer;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.service.inbox.CallbackStopwatch;
import org.u2sa.service.inbox.MessageAge;
import org.u2sa.service.inbox.ServiceInbox;

/**
 * Message loop of a service: delivers messages one by one, answers those of the service contract,
 * reports health meanwhile, and survives exceptions of the author's code. Confined to the service's
 * thread except {@link #inbox} and {@link #contract}.
 */
final class MessageHandling {
  private final U2SAService service;
  private final Consumer<U2SAData> callback;
  private final Registrations registrations;
  private final ServiceInbox inbox;
  private final ContractResponder contract;
  private final HealthReporter reporter;
  private final int maxErrorsInARow;
  private final CallbackStopwatch stopwatch;
  private final Execution execution; // null if not recorded
  private final ServiceHealth.CallbackCode handled = this::handleNext; // reused for all messages
  private ServiceInbox.Delivery next; // argument of handled
  private volatile boolean patient;

  MessageHandling(U2SAService service, ServiceConfiguration.ServiceVariables variables) {
    this.service = service;
    callback = service::callback;
    registrations = service.wiring.registrations();
    maxErrorsInARow = variables.maxErrorsInARow();
    reporter = new HealthReporter(service, variables.healthInterval());
    inbox = new ServiceInbox(variables.inboxCapacity(), service.clock());
    contract = new ContractResponder(service);
    stopwatch = service.health.stopwatch();
    execution = service.context().execution().orElse(null);
  }

  ServiceInbox inbox() {
    return inbox;
  }

  ContractResponder contract() {
    return contract;
  }

  HealthReporter reporter() {
    return reporter;
  }

  /** Consecutive exceptions after which the service fails. */
  int maxErrorsInARow() {
    return maxErrorsInARow;
  }

  /** Defers non-urgent messages until the service wakes by itself. */
  void bePatient() {
    patient = true;
  }

  /** {@link #bePatient}. */
  boolean isPatient() {
    return patient;
  }

  /** Takes turns until the deadline or the end of the service. */
  Clock.Turns until(long untilMicros) {
    return new Round(untilMicros);
  }

  /** Handles messages until a deadline [µs]. */
  private final class Round implements Clock.Turns {
    private final long untilMicros;
    private int first = inbox.depth(); // handled even if the deadline has passed

    Round(long untilMicros) {
      this.untilMicros = untilMicros;
    }

    @Override
    public long take() throws InterruptedException {
      stopwatch.pause(); // the thread has waited or done other work
      while (service.running) {
        if (service.succession.carryOut()) {
          service.running = false;
          return OVER;
        }
        if (takesWritten()) {
          guarded(contract.configurationWriter()::handOver);
          continue;
        }
        long now = stopwatch.runMicros();
        if (reporter.reportIfDue(now)) {
          stopwatch.pause();
        }
        boolean mayHandle = first-- > 0 || now < untilMicros;
        ServiceInbox.Delivery delivery = mayHandle ? inbox.poll() : null;
        if (execution != null) {
          delivery = asExecuted(delivery);
          stopwatch.pause();
        }
        if (delivery != null) {
          handle(delivery);
        } else if (now >= untilMicros) {
          break;
        } else {
          return Math.min(untilMicros, reporter.dueMicros());
        }
      }
      return OVER;
    }
  }

  private boolean takesWritten() throws InterruptedException {
    ConfigurationWriter writer = contract.configurationWriter();
    return execution == null ? writer.hasWritten() : execution.takesWritten(writer::hasWritten);
  }

  private ServiceInbox.Delivery asExecuted(ServiceInbox.Delivery waiting) {
    Execution.Arrival arrival =
        waiting == null
            ? null
            : new Execution.Arrival(waiting.channel(), waiting.message(), waiting.arrivedMicros());
    Execution.Arrival handled = execution.receives(arrival);
    if (handled == null || handled == arrival) {
      return handled == null ? null : waiting;
    }
    return new ServiceInbox.Delivery(handled.channel(), handled.message(), handled.arrivedMicros());
  }

  private void handle(ServiceInbox.Delivery delivery) throws InterruptedException {
    service.succession.note(delivery);
    next = delivery;
    guarded(handled);
  }

  private void handleNext() {
    ServiceInbox.Delivery delivery = next;
    next = null;
    U2SAData message = delivery.message();
    if (contract.concerns(delivery.channel(), message)) {
      contract.answer(message);
    }
    if (registrations.isSubscribed(delivery.channel()) && isInTime(delivery)) {
      registrations.handlerOr(delivery.channel(), callback).accept(message);
    }
  }

  /** Whether a message meets its channel's deadline; counts it if not. */
  private boolean isInTime(ServiceInbox.Delivery delivery) {
    long deadlineMicros = registrations.deadlineMicros(delivery.channel());
    if (deadlineMicros == Clock.NEVER) {
      return true;
    }
    OptionalLong saidMicros = delivery.message().timestamp();
    long ageMicros =
        saidMicros.isPresent()
            ? MessageAge.micros(
                delivery.message(), delivery.arrivedMicros(), service.clock().micros())
            : Clock.NEVER;
    if (ageMicros <= deadlineMicros) {
      return true;
    }
    long expired = service.health.expired();
    if (Long.bitCount(expired) == 1) { // 1, 2, 4, 8…: limits the log
      String age = saidMicros.isPresent() ? Clock.seconds(ageMicros) + " s old" : "of unknown age";
      String deadline = Clock.seconds(deadlineMicros) + " s (" + expired + " so far): ";
      service.log(
          LogLevelEnum.WARN,
          String.format(
              "%s: message %s counts as absent after %s%s",
              delivery.channel(), age, deadline, delivery.message()));
    }
    return false;
  }

  /**
   * Runs the author's code; exceptions are logged, counted and survived, up to a limit of
   * consecutive ones.
   */
  void guarded(ServiceHealth.CallbackCode code) throws InterruptedException {
    guarded(code, maxErrorsInARow);
  }

  /**
   * @param maxErrors consecutive exceptions after which the service fails
   */
  void guarded(ServiceHealth.CallbackCode code, int maxErrors) throws InterruptedException {
    ServiceHealth health = service.health;
    if (health.run(code)) {
      return;
    }
    stopwatch.pause(); // logging is slow
    String what = health.lastError().orElse("");
    String inRow = " (exception " + health.exceptionsInRow() + " in a row)";
    boolean where = Long.bitCount(health.exceptions()) == 1; // 1, 2, 4…: limits stack traces
    service.logFile().log(LogLevelEnum.ERROR, what + inRow, where ? health.lastException() : null);
    if (health.exceptionsInRow() >= maxErrors) {
      service.log(
          LogLevelEnum.ERROR,
          maxErrors == 1
              ? "stopping after an exception"
              : "stopping after " + maxErrors + " consecutive exceptions");
      service.life.fail();
    }
  }

  /** Publishes the last health report. */
  void reportLast() {
    contract.configurationWriter().close();
    reporter.reportLast();
  }
}
