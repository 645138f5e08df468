package org.u2sa.service;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.schema.U2SAData;

/**
 * A service: one thread that knows no other service and talks in messages (thesis 3.2.2.1, 4.6.1,
 * 8.2.3.1).
 *
 * <p>Most authors extend {@link EventDrivenService} or {@link PeriodicService} and write no loop. A
 * direct subclass writes {@link #run} as thesis 8.2.4 says: a loop while {@link #isRunning}, which
 * calls {@link #handleMessages} to be handed its messages, and a {@link #kill} that calls {@link
 * #end}.
 *
 * <pre>
 *   CREATED ──start()──▶ RUNNING ──kill(), stop command──▶ STOPPING ──▶ STOPPED
 *                           └──── too many errors in a row ───────────▶ FAILED
 * </pre>
 *
 * <p>Registering, reading variables and logging work from the constructor on. Discovery, stop,
 * configuration and health are answered for every service here.
 */
public abstract class U2SAService extends ReplaceableService {
  private final ServiceRole role;
  private final ServiceInbox inbox;
  private final ContractResponder contract;
  private final HealthReporter reporter;
  private final int maxErrorsInARow;

  /**
   * Reads the common variables, opens the log file and connects to the Communication Manager.
   *
   * @param serviceName the name, unless the variable SERVICE NAME says another
   * @throws org.u2sa.interfaces.configuration.ConfigurationException if a variable is wrong
   * @throws CommunicationException if the Communication Manager cannot be reached
   */
  protected U2SAService(ServiceContext context, ServiceRole role, String serviceName) {
    super(context, role, serviceName);
    this.role = role;
    maxErrorsInARow = getVariable(ServiceVariables.MAX_ERRORS_IN_A_ROW);
    reporter = new HealthReporter(this, getVariable(ServiceVariables.HEALTH_INTERVAL));
    inbox = new ServiceInbox(getVariable(ServiceVariables.INBOX_CAPACITY));
    contract = new ContractResponder(this, context.configuration(), wiring());
    try {
      wiring().begin();
    } catch (CommunicationException e) {
      log(LogLevelEnum.ERROR, e.getMessage());
      context.abandon();
      throw e;
    }
  }

  /**
   * Handles one message, on the service's thread, one at a time. What is not expected goes to
   * {@link #unexpected}.
   */
  public abstract void callback(U2SAData data);

  /** Logs a message that the service has no use for (thesis 8.2.4). */
  protected final void unexpected(U2SAData data) {
    log(LogLevelEnum.DEBUG, "unexpected message: " + data);
  }

  /**
   * Says in the log, and as the last error in the health report, what is wrong with something that
   * the service works with, such as a lost device; the service goes on. From any thread.
   */
  public final void trouble(String what) {
    health().error(what);
    log(LogLevelEnum.WARN, what);
  }

  /**
   * Takes note that variables were changed from outside, by {@link #setVariable}'s rules: once for
   * all that were changed together. Called on the service's thread.
   *
   * @param variableNames those that have another value than before; at least one
   */
  protected void configurationChanged(Set<String> variableNames) {}

  /**
   * Hands waiting messages to {@link #callback} and reports health, until the deadline or the end
   * of the service. Messages that already wait are handled even if the deadline has passed.
   *
   * @param untilMicros time of the run's clock [µs], or {@link Clock#NEVER}
   * @throws InterruptedException if the service's thread was interrupted
   */
  protected final void handleMessages(long untilMicros) throws InterruptedException {
    health().busy(false);
    int first = inbox.depth();
    while (running) {
      if (succession().carryOut()) {
        running = false;
        return;
      }
      if (contract.configurationWriter().hasWritten()) {
        guarded(contract.configurationWriter()::handOver);
        continue;
      }
      long now = clock().micros();
      reporter.reportIfDue(now);
      boolean mayHandle = first-- > 0 || now < untilMicros;
      ServiceInbox.Delivery delivery = mayHandle ? inbox.poll() : null;
      if (delivery != null) {
        handle(delivery);
      } else if (now >= untilMicros) {
        break;
      } else {
        await(Math.min(untilMicros, reporter.dueMicros()));
      }
    }
    health().busy(true);
  }

  private void handle(ServiceInbox.Delivery delivery) throws InterruptedException {
    U2SAData message = delivery.message();
    succession().note(delivery);
    guarded(
        () -> {
          if (contract.concerns(delivery.channel(), message)) {
            contract.answer(message);
          }
          if (wiring().registrations().isSubscribed(delivery.channel()) && isInTime(delivery)) {
            callback(message);
          }
        });
  }

  /** Whether a message has not outlived the deadline that the author set; otherwise counts it. */
  private boolean isInTime(ServiceInbox.Delivery delivery) {
    long deadlineMicros = wiring().registrations().deadlineMicros(delivery.channel());
    if (deadlineMicros == Clock.NEVER) {
      return true;
    }
    OptionalLong saidMicros = delivery.message().timestamp();
    long ageMicros =
        saidMicros.isPresent()
            ? MessageAge.micros(delivery.message(), delivery.arrivedMicros(), clock().micros())
            : Clock.NEVER;
    if (ageMicros <= deadlineMicros) {
      return true;
    }
    long expired = health().expired();
    if (Long.bitCount(expired) == 1) { // 1, 2, 4, 8…: a flood does not fill the log
      String age = saidMicros.isPresent() ? Clock.seconds(ageMicros) + " s old" : "of unknown age";
      String deadline = Clock.seconds(deadlineMicros) + " s (" + expired + " so far): ";
      log(
          LogLevelEnum.WARN,
          delivery.channel()
              + ": message "
              + age
              + " counts as absent after "
              + deadline
              + delivery.message());
    }
    return false;
  }

  /**
   * Runs author's code; an exception is logged, counted and survived, until there are too many in a
   * row.
   */
  final void guarded(ServiceHealth.CallbackCode code) throws InterruptedException {
    if (health().run(code)) {
      return;
    }
    String what = health().lastError().orElse("");
    String inRow = " (exception " + health().exceptionsInRow() + " in a row)";
    boolean where = Long.bitCount(health().exceptions()) == 1; // 1, 2, 4…: no flood of stack traces
    logFile().log(LogLevelEnum.ERROR, what + inRow, where ? health().lastException() : null);
    if (health().exceptionsInRow() >= maxErrorsInARow) {
      log(LogLevelEnum.ERROR, "kills itself after " + maxErrorsInARow + " exceptions in a row");
      fail();
    }
  }

  /**
   * Says in health reports from now on, the next of them at once, which emergency stops hold here:
   * an operator's stop counts when all that heed stops have said that it holds. Called on the
   * service's thread, and in its constructor with an empty list to say that it heeds stops.
   *
   * @param identities as {@link EmergencyLatch#identities} says
   */
  public final void heedsEmergencyStops(List<String> identities) {
    if (health().emergencyStops(identities)) {
      reporter.reportSoon();
    }
  }

  @Override
  final ServiceReceiver receiver() {
    return new ServiceReceiver(this);
  }

  final ContractResponder contract() {
    return contract;
  }

  final ServiceInbox inbox() {
    return inbox;
  }

  /** What the service is for. */
  public final ServiceRole role() {
    return role;
  }

  /**
   * What is to be said on behalf of the service because its own health report is overdue, on {@link
   * org.u2sa.interfaces.communication.Channels#HEALTH}; empty if it speaks for itself or has ended.
   * For whoever hosts the service; from any thread.
   */
  public final Optional<HealthReport> overdueHealth() {
    return reporter.onBehalf(clock().micros());
  }

  @Override
  final void reportLast() {
    contract.configurationWriter().close();
    reporter.reportLast();
  }

  @Override
  boolean endsSurely() {
    return false; // a direct subclass writes its own run
  }
}
