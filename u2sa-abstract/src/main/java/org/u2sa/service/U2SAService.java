package org.u2sa.service;

import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import org.u2sa.interfaces.Clock;
import org.u2sa.interfaces.LogLevelEnum;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;

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
public abstract class U2SAService extends CommunicatingService {
  /** Identifies the service's thread in the log (thesis 8.2.3.1). */
  protected final int threadID;

  /**
   * Whether the service's loop should go on (thesis 8.2.3.1). Cleared by {@link #kill} and the stop
   * command.
   */
  protected volatile boolean running;

  private final ServiceRole role;
  private final ServiceInbox inbox;
  private final ContractResponder contract;
  private final ServiceHealth health = new ServiceHealth();
  private final Succession succession = new Succession();
  private final int maxErrorsInARow;
  private final long healthIntervalMicros;
  private final long createdMicros;
  private final AtomicBoolean ended = new AtomicBoolean();
  private volatile boolean askedToStop; // also before the start, which then does not happen
  private volatile ServiceStatus status = ServiceStatus.CREATED;
  private volatile Clock.Waiter waiter; // null until started
  private long healthDueMicros; // touched by the service's thread only

  /**
   * Reads the common variables, opens the log file and connects to the Communication Manager.
   *
   * @param serviceName the name, unless the variable SERVICE NAME says another
   * @throws org.u2sa.interfaces.ConfigurationException if a variable is wrong
   * @throws CommunicationException if the Communication Manager cannot be reached
   */
  protected U2SAService(ServiceContext context, ServiceRole role, String serviceName) {
    super(context, role, serviceName);
    this.role = role;
    threadID = (int) getId();
    createdMicros = clock().micros();
    maxErrorsInARow = getVariable(ServiceVariables.MAX_ERRORS_IN_A_ROW);
    healthIntervalMicros = Clock.micros(getVariable(ServiceVariables.HEALTH_INTERVAL));
    inbox = new ServiceInbox(getVariable(ServiceVariables.INBOX_CAPACITY));
    contract = new ContractResponder(this, context.configuration(), wiring());
    setUncaughtExceptionHandler((thread, error) -> die(error));
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

  /**
   * Ends the service: its loop stops, its resources are closed, its actuators left neutral. Safe to
   * call twice and from any thread; returns when the service has ended.
   */
  public abstract void kill();

  /** Logs a message that the service has no use for (thesis 8.2.4). */
  protected final void unexpected(U2SAData data) {
    log(LogLevelEnum.DEBUG, "unexpected message: " + data);
  }

  /** The service's life; called by {@link #start} on the new thread. */
  @Override
  public abstract void run();

  /**
   * Closes what the subclass opened and leaves its actuators neutral. Called once when the service
   * ends.
   */
  protected void release() {}

  /**
   * Takes note that variables were changed from outside, by {@link #setVariable}'s rules: once for
   * all that were changed together. Called on the service's thread.
   *
   * @param variableNames those that have another value than before; at least one
   */
  protected void configurationChanged(Set<String> variableNames) {}

  /**
   * Writes down what a service of another class needs to know to take this one's place without a
   * bump: what was learnt since the start, such as the goal pursued or an integrator. Called on the
   * service's thread between two messages; this service goes on if the other one refuses.
   */
  protected void handOver(HandOver state) {}

  /**
   * Takes over what the service before it wrote down, which may be of any class of the same role.
   * Called once, before {@link #start} and only in a {@link ServiceSwap}. Nothing can be published
   * yet.
   *
   * @throws RuntimeException if the service cannot go on from there: the one before stays
   */
  protected void takeOver(HandOver state) {}

  /**
   * Starts the thread. A service that was told to stop before ends without having run.
   *
   * @throws org.u2sa.interfaces.ConfigurationException if the configuration holds a variable that
   *     the service does not know
   * @throws IllegalThreadStateException if it was started or killed before
   */
  @Override
  public void start() {
    context().configuration().refuseUndeclared();
    if (!startUnlessAskedToStop()) {
      end();
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
    healthDueMicros = clock().micros();
    running = true;
    status = ServiceStatus.RUNNING;
    super.start();
    return true;
  }

  /**
   * Hands waiting messages to {@link #callback} and reports health, until the deadline or the end
   * of the service. Messages that already wait are handled even if the deadline has passed.
   *
   * @param untilMicros time of the run's clock [µs], or {@link Clock#NEVER}
   * @throws InterruptedException if the service's thread was interrupted
   */
  protected final void handleMessages(long untilMicros) throws InterruptedException {
    int first = inbox.depth();
    while (running) {
      if (succession.carryOut()) {
        running = false;
        return;
      }
      long now = clock().micros();
      if (now >= healthDueMicros) {
        reportHealth();
        healthDueMicros = now + healthIntervalMicros;
      }
      boolean mayHandle = first-- > 0 || now < untilMicros;
      ServiceInbox.Delivery delivery = mayHandle ? inbox.poll() : null;
      if (delivery != null) {
        handle(delivery);
      } else if (now >= untilMicros) {
        return;
      } else {
        waiter.await(Math.min(untilMicros, healthDueMicros));
      }
    }
  }

  private void handle(ServiceInbox.Delivery delivery) throws InterruptedException {
    U2SAData message = delivery.message();
    succession.note(delivery);
    guarded(
        () -> {
          if (contract.concerns(message)) {
            Set<String> changed = contract.answer(message);
            if (!changed.isEmpty()) {
              configurationChanged(changed);
            }
          }
          if (wiring().isSubscribed(delivery.channel()) && isInTime(delivery)) {
            callback(message);
          }
        });
  }

  /** Whether a message has not outlived the deadline that the author set; otherwise counts it. */
  private boolean isInTime(ServiceInbox.Delivery delivery) {
    long deadlineMicros = wiring().deadlineMicros(delivery.channel());
    if (deadlineMicros == Clock.NEVER) {
      return true;
    }
    OptionalLong saidMicros = delivery.message().timestamp();
    long ageMicros = clock().micros() - saidMicros.orElse(0L);
    if (saidMicros.isPresent() && ageMicros <= deadlineMicros) {
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
    if (health.run(code)) {
      return;
    }
    String what = health.lastError().orElse("");
    String inRow = " (exception " + health.exceptionsInRow() + " in a row)";
    boolean where = Long.bitCount(health.exceptions()) == 1; // 1, 2, 4…: no flood of stack traces
    logFile().log(LogLevelEnum.ERROR, what + inRow, where ? health.lastException() : null);
    if (health.exceptionsInRow() >= maxErrorsInARow) {
      log(LogLevelEnum.ERROR, "kills itself after " + maxErrorsInARow + " exceptions in a row");
      status = ServiceStatus.FAILED;
      running = false;
    }
  }

  /**
   * Waits for this thread's first turn, so that services begin in the order in which they were
   * started.
   */
  final void awaitTurn() throws InterruptedException {
    waiter.await(clock().micros());
  }

  /** Asks the loop to stop, without waiting for it. */
  final void askToStop() {
    askedToStop = true;
    running = false;
    wake();
    succession.successor().ifPresent(U2SAService::askToStop); // which may take over just now
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

  /**
   * Releases everything, once: the last act of {@link #run} and of a direct subclass's {@link
   * #kill}.
   */
  protected final void end() {
    if (!ended.compareAndSet(false, true)) {
      return;
    }
    running = false;
    if (succession.successor().isPresent()) {
      status = ServiceStatus.STOPPED;
      stopWaiting(); // everything else is the successor's now
      return;
    }
    succession.serviceEnds();
    boolean failed = status == ServiceStatus.FAILED;
    status = failed ? ServiceStatus.FAILED : ServiceStatus.STOPPING;
    atLast("closing", this::release);
    status = failed ? ServiceStatus.FAILED : ServiceStatus.STOPPED;
    atLast("the last health report", this::reportHealth);
    log(LogLevelEnum.INFO, "ended: " + status);
    atLast("ending the communication", wiring()::close);
    stopWaiting();
    logFile().close();
  }

  /**
   * Closes what the subclass opened, but leaves actuators as they are: a successor moves them on.
   */
  final void releaseAsPredecessor() {
    atLast("closing", this::releaseSilently);
  }

  /** {@link #release} where nothing can be published. */
  void releaseSilently() {
    release();
  }

  /** Takes note of whose place it takes. */
  void succeeds(U2SAService predecessor) {
    context().forgetPredecessor();
  }

  /** Starts; should that fail, it is over as if it had died. */
  final void startAsSuccessor() {
    try {
      start();
    } catch (RuntimeException | Error e) {
      die(e);
    }
  }

  /** Ends without ever having run, because its predecessor goes on. */
  final void discard() {
    if (ended.compareAndSet(false, true)) {
      status = ServiceStatus.STOPPED;
      wiring().silence();
      releaseAsPredecessor();
      context().forgetPredecessor();
    }
  }

  /** Does one of the last things; should it fail, the others are done all the same. */
  private void atLast(String what, Runnable last) {
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
      health.error(error.toString());
      logFile().log(LogLevelEnum.ERROR, "the thread died", error);
      status = ServiceStatus.FAILED;
    }
    end();
  }

  private void reportHealth() {
    HealthReport report =
        new HealthReport()
            .serviceName(getName())
            .status(status)
            .inboxDepth(inbox.depth())
            .dropped(inbox.dropped())
            .refused(wiring().refused());
    publish(Channels.HEALTH, health.addTo(report));
  }

  @Override
  final ServiceReceiver receiver() {
    return new ServiceReceiver(this);
  }

  final ContractResponder contract() {
    return contract;
  }

  final Succession succession() {
    return succession;
  }

  final ServiceInbox inbox() {
    return inbox;
  }

  /** Whether the service's loop goes on. */
  public final boolean isRunning() {
    return running;
  }

  /** {@link #threadID}. */
  public final int getThreadID() {
    return threadID;
  }

  /** What the service is for. */
  public final ServiceRole role() {
    return role;
  }

  /** Where the service is in its life. */
  public final ServiceStatus status() {
    return status;
  }

  /** Time since the service was made [s]. */
  final double uptimeS() {
    return Clock.seconds(clock().micros() - createdMicros);
  }

  final ServiceHealth health() {
    return health;
  }
}
