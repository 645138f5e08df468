package org.u2sa.service;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Communicator;
import org.u2sa.interfaces.communication.Publisher;
import org.u2sa.interfaces.communication.Subscriber;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.log.LogFile;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.log.Logger;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.schema.U2SAData;

/**
 * A service: one thread that knows no other service and talks in messages (thesis 3.2.2.1, 4.6.1,
 * 8.2.3.1).
 *
 * <p>A direct subclass is written as thesis 8.2.4 says: {@link #run} loops while {@link #running}
 * is true and waits by {@link #sleep}, {@link #callback} handles messages, and {@link #kill} closes
 * what the service opened and clears {@link #running}. Messages are handled on a thread of their
 * own beside the loop. Most authors extend {@link EventDrivenService} or {@link PeriodicService}
 * instead, which have one thread and no loop to write.
 *
 * <pre>
 *   CREATED ──start()──▶ RUNNING ──kill(), stop command──▶ STOPPING ──▶ STOPPED
 *                           └──── too many errors in a row ───────────▶ FAILED
 * </pre>
 *
 * <p>Registering, reading variables and logging work from the constructor on. Discovery, stop,
 * configuration and health are answered for every service here.
 */
public abstract class U2SAService extends Thread
    implements Communicator, Publisher, Subscriber, Logger {
  /** Identifies the service's thread in the log (thesis 8.2.3.1). */
  protected final int threadID;

  /**
   * Whether the service's loop should go on (thesis 8.2.3.1). Cleared by {@link #kill} and the stop
   * command.
   */
  protected volatile boolean running;

  final ServiceWiring wiring;
  final ServiceHealth health;
  final ServiceLife life;
  final Succession succession;
  final MessageHandling handling;
  final AuthoredLoop loop; // null: run() is a ready-made loop

  private final ServiceContext context;
  private final ServiceRole role;
  private final ServiceConfiguration configuration;
  private final ServiceMessaging messaging;

  /**
   * Reads the common variables, opens the log file and connects to the Communication Manager.
   *
   * @param serviceName the name, unless the variable SERVICE NAME says another
   * @throws org.u2sa.interfaces.configuration.ConfigurationException if a variable is wrong
   * @throws CommunicationException if the Communication Manager cannot be reached
   */
  protected U2SAService(ServiceContext context, ServiceRole role, String serviceName) {
    context.execution().ifPresent(execution -> execution.requireRole(role));
    this.context = context;
    this.role = role;
    health = new ServiceHealth(new CallbackStopwatch(context.clock()));
    int own = (int) getId();
    threadID = context.execution().map(execution -> execution.threadId(own)).orElse(own);
    configuration = new ServiceConfiguration(context, serviceName);
    setName(configuration.name());
    wiring = new ServiceWiring(context, getName(), new ServiceReceiver(this));
    context.onAbandon(wiring::close);
    messaging = new ServiceMessaging(this, wiring);
    life = new ServiceLife(this, context.clock(), (long) configuration.variables().spin());
    succession = new Succession(this, context);
    handling = new MessageHandling(this, configuration.variables());
    loop = hasReadyMadeLoop() ? null : new AuthoredLoop(this);
    try {
      wiring.begin();
    } catch (CommunicationException e) {
      log(LogLevelEnum.ERROR, e.getMessage());
      context.abandon();
      throw e;
    }
  }

  /**
   * What the service does continuously, on its own thread: a loop while {@link #running}. A loop
   * that returns earlier has failed. If there is nothing to do continuously, it returns at once,
   * and the service handles messages.
   */
  @Override
  public abstract void run();

  /**
   * Ends the service: closes what it opened and clears {@link #running}. Also called by the service
   * itself when it ends for another reason, such as a stop command. Safe to call twice and from any
   * thread. That of {@link EventDrivenService} and {@link PeriodicService} returns when the service
   * has ended; a direct subclass ends within 0.25 s, or in {@link #shutDown}.
   */
  public abstract void kill();

  /** {@linkplain #kill Kills} the service and returns when it has ended, or hangs for seconds. */
  public final void shutDown() {
    kill();
    if (loop != null) {
      loop.finish();
    }
  }

  /** Waits until the service has ended; returns at once if it was never started. */
  public final void awaitEnd() throws InterruptedException {
    join();
    if (loop != null) {
      loop.messages().join();
    }
  }

  /**
   * Waits on the run's clock, in a loop that a direct subclass wrote as {@link #run}: in simulated
   * time if the run is simulated, which {@link Thread#sleep} does not. Returns early when the
   * service is to end. On any other thread it is {@link Thread#sleep}.
   *
   * @param millis how long [ms], not negative
   * @throws InterruptedException if the thread was interrupted
   */
  public static void sleep(long millis) throws InterruptedException {
    if (Thread.currentThread() instanceof U2SAService service && service.loop != null) {
      service.loop.sleep(millis);
    } else {
      Thread.sleep(millis);
    }
  }

  /**
   * Handles one message that no {@linkplain #subscribe handler} takes, one at a time. What is not
   * expected goes to {@link #unexpected}. Called on the service's thread; in a direct subclass on
   * another one beside {@link #run}, so fields that both touch are volatile.
   */
  public void callback(U2SAData data) {
    unexpected(data);
  }

  /** Logs a message that the service has no use for (thesis 8.2.4). */
  protected final void unexpected(U2SAData data) {
    log(LogLevelEnum.DEBUG, "unexpected message: " + data);
  }

  // Configuration and log (thesis 3.2.1.1, 3.2.1.5)

  @Override
  public final Object getVariable(String variableName) {
    return context.configuration().getVariable(variableName);
  }

  @Override
  public final <T> T getVariable(VariableDeclaration<T> variable) {
    return context.configuration().getVariable(variable);
  }

  @Override
  public final <T> Settings<T> settings(Class<T> record, String prefix) {
    return context.configuration().settings(record, prefix);
  }

  @Override
  public final boolean setVariable(String variableName, Object value) {
    return configuration.setVariable(variableName, value, this::configurationRefusal);
  }

  @Override
  public final ArrayList<Map.Entry<String, Object>> enumerateFields() {
    return context.configuration().enumerateFields();
  }

  /**
   * Why these values would not do together, though each is allowed; empty if they would. Asked
   * before a change or an undo is written, which is refused with this reason. May be asked from any
   * thread that calls {@link #setVariable}: judges its argument alone.
   *
   * @param values every variable of this service as it would be, in the declared units
   */
  protected Optional<String> configurationRefusal(Map<String, Object> values) {
    return Optional.empty();
  }

  /**
   * Takes note that variables were changed from outside, by {@link #setVariable}'s rules: once for
   * all that were changed together. Called on the service's thread.
   *
   * @param variableNames those that have another value than before; at least one
   */
  protected void configurationChanged(Set<String> variableNames) {}

  /** Writes a line of level INFO to the service's log file (thesis 8.2.3.1). */
  public final void log(String message) {
    log(LogLevelEnum.INFO, message);
  }

  @Override
  public final void log(LogLevelEnum level, String logMessage) {
    configuration.log().log(level, logMessage);
  }

  /**
   * Logs a problem that the service survives, such as a lost device, and reports it as the last
   * error in the health report. From any thread.
   */
  public final void trouble(String what) {
    health.error(what);
    log(LogLevelEnum.WARN, what);
  }

  /**
   * Says in every health report from now on how a part of the service is, such as one of its
   * sources or algorithms: counters, or what is wrong. From any thread.
   *
   * @param part its name; a later remark on the same part replaces this one
   * @param what in words and numbers; empty: no more remark
   */
  public final void remark(String part, String what) {
    health.remark(part, what);
  }

  // Messages (thesis 3.2.1.2–3.2.1.4)

  @Override
  public final boolean beginCommunication() {
    return messaging.begin();
  }

  @Override
  public final boolean registerPublisher(Class<? extends U2SAData> dataType) {
    return messaging.toPublish(dataType).filter(messaging::registerPublisher).isPresent();
  }

  /** {@link #registerPublisher(Class)} on the channel of that name (thesis 8.2.3.1). */
  public final boolean registerPublisher(String channelName) {
    return messaging.named(channelName).filter(messaging::registerPublisher).isPresent();
  }

  /** {@link #registerPublisher(Class)} on a channel. */
  public final boolean registerPublisher(Channel<?> channel) {
    return messaging.registerPublisher(channel);
  }

  @Override
  public final boolean unregisterPublisher(Class<? extends U2SAData> dataType) {
    return messaging.toPublish(dataType).filter(wiring::unregisterPublisher).isPresent();
  }

  @Override
  public final boolean registerSubscriber(Class<? extends U2SAData> dataType) {
    return messaging.toSubscribe(dataType).filter(messaging::registerSubscriber).isPresent();
  }

  /** {@link #registerSubscriber(Class)} on the channel of that name (thesis 8.2.3.1). */
  public final boolean registerSubscriber(String channelName) {
    return messaging.named(channelName).filter(messaging::registerSubscriber).isPresent();
  }

  /** {@link #registerSubscriber(Class)} on a channel. */
  public final boolean registerSubscriber(Channel<?> channel) {
    return messaging.registerSubscriber(channel);
  }

  /**
   * {@link #registerSubscriber(Channel)} with a deadline: a message that is older when its turn
   * comes, or that does not say its time, counts as absent. It is not handed over, but counted as
   * expired in health. A further call sets another deadline.
   *
   * @param deadlineS age at which a message counts as absent [s], positive
   */
  public final boolean registerSubscriber(Channel<?> channel, double deadlineS) {
    wiring.registrations().deadline(channel, Clock.micros(deadlineS));
    return registerSubscriber(channel);
  }

  /**
   * {@link #registerSubscriber(Channel)} with a handler: the channel's messages go to it instead of
   * {@link #callback}, on the service's thread. A further call sets another handler.
   */
  public final <T extends U2SAData> boolean subscribe(
      Channel<T> channel, Consumer<? super T> handler) {
    wiring.registrations().handler(channel, handler);
    return registerSubscriber(channel);
  }

  /**
   * {@link #subscribe(Channel, Consumer)} with a {@linkplain #registerSubscriber(Channel, double)
   * deadline}.
   */
  public final <T extends U2SAData> boolean subscribe(
      Channel<T> channel, double deadlineS, Consumer<? super T> handler) {
    wiring.registrations().handler(channel, handler);
    return registerSubscriber(channel, deadlineS);
  }

  @Override
  public final boolean unregisterSubscriber(Class<? extends U2SAData> dataType) {
    return messaging.toSubscribe(dataType).filter(messaging::unregisterSubscriber).isPresent();
  }

  @Override
  public final boolean publish(U2SAData data) {
    return messaging.publish(data);
  }

  /** Publishes on the channel of that name (thesis 8.2.3.1). */
  public final boolean publish(String channelName, U2SAData data) {
    return messaging.named(channelName).filter(channel -> publish(channel, data)).isPresent();
  }

  /**
   * Publishes on a channel. Missing system ID and timestamp are filled in; the message is frozen.
   */
  public final boolean publish(Channel<?> channel, U2SAData data) {
    return messaging.publish(channel, data);
  }

  /**
   * Says in health reports from now on, the next of them at once, which emergency stops hold here:
   * an operator's stop counts when all that heed stops have said that it holds. Called on the
   * service's thread, and in its constructor with an empty list to say that it heeds stops.
   *
   * @param identities as {@link EmergencyLatch#identities} says
   */
  public final void heedsEmergencyStops(List<String> identities) {
    if (health.emergencyStops(identities)) {
      handling.reporter().reportSoon();
    }
  }

  // Life (thesis 8.2.3.1)

  /**
   * Starts the thread. A service that was told to stop before ends without having run. One that was
   * started anew goes on where it was.
   *
   * @throws org.u2sa.interfaces.configuration.ConfigurationException if the configuration holds a
   *     variable that the service does not know
   * @throws IllegalThreadStateException if it was started or killed before
   */
  @Override
  public void start() {
    succession.resume();
    life.start();
  }

  /**
   * Has handlers and steps called on this service's own thread and no other, also in a simulation,
   * where a thread of the run's clock calls them as a rule: for libraries that know the thread that
   * calls them. That costs the simulation time. Called in the constructor.
   */
  protected final void keepToOwnThread() {
    life.keepToOwnThread();
  }

  /** Whether {@link #run} is a ready-made loop that handles messages, too. */
  boolean hasReadyMadeLoop() {
    return false;
  }

  final void startThread() {
    super.start();
  }

  /**
   * Closes what the subclass opened and leaves its actuators neutral. Called once when the service
   * ends.
   */
  protected void release() {}

  /**
   * Closes what the subclass opened in a service whose place another one takes: in place of {@link
   * #release}, where nothing can be published. What moves is to be left as it is, because the
   * successor moves it on.
   */
  protected void releaseToSuccessor() {
    release();
  }

  /**
   * Abandons a service whose code does not return: Java cannot end its thread. It is interrupted;
   * if that does not help, its actuators are left neutral from another thread and it is cut off:
   * what it still publishes is refused, nothing reaches it any more, and its name is free. Returns
   * within a few seconds in any case.
   */
  public final void abandon() {
    life.abandon();
  }

  /** Whether the service's loop goes on. */
  public final boolean isRunning() {
    return running;
  }

  /** Where the service is in its life. */
  public final ServiceStatus status() {
    return life.status();
  }

  /** Why the service ends or has ended, if a message made it end; otherwise empty. */
  public final Optional<String> endReason() {
    return life.endReason();
  }

  /**
   * What is to be said on behalf of the service because its own health report is overdue, on {@link
   * org.u2sa.interfaces.communication.Channels#HEALTH}; empty if it speaks for itself or has ended.
   * For whoever hosts the service; from any thread.
   */
  public final Optional<HealthReport> overdueHealth() {
    return handling.reporter().onBehalf(clock().micros());
  }

  // Succession (thesis 5.1, user story 8)

  /**
   * Writes down what a service of another class needs to know to take this one's place without a
   * bump: what was learnt since the start, such as the goal pursued or an integrator. Called on the
   * service's thread between two messages; this service goes on if the other one refuses.
   */
  protected void handOver(HandOver state) {}

  /**
   * Takes over what the service before it wrote down, which may be of any class of the same role.
   * Or what this service {@linkplain #remember remembered} before it was started anew. Called once,
   * before its thread runs, and not at a first start. Nothing can be published yet.
   *
   * @throws RuntimeException if the service cannot resume from there: in a {@link ServiceSwap} the
   *     one before stays; a restart fails, and the next one starts without saved state
   */
  protected void takeOver(HandOver state) {}

  /**
   * Keeps what {@link #handOver} writes at this moment, in a file beside the log. Should the
   * service be started anew in this run, in the same process or after its process was killed,
   * {@link #takeOver} gets it. Called on the service's thread at each change of what must not be
   * lost.
   */
  protected final void remember() {
    succession.remember();
  }

  /** Takes note of whose place it takes, before it starts. */
  void succeeds(U2SAService predecessor) {
    succession.succeeds();
  }

  /** Sets when the first step is due [µs of the run's clock], of a service that steps. */
  void firstStepAt(long micros) {}

  /** When the first step is due [µs of the run's clock]; empty if at once, or without steps. */
  OptionalLong firstStepMicros() {
    return OptionalLong.empty();
  }

  // What it is

  /** The name under which others find this service. */
  public final String getServiceName() {
    return getName();
  }

  /** {@link #threadID}. */
  public final int getThreadID() {
    return threadID;
  }

  /** What the service is for. */
  public final ServiceRole role() {
    return role;
  }

  /** The channels on which the service publishes. */
  public final List<Channel<?>> publishedChannels() {
    return List.copyOf(wiring.registrations().published());
  }

  /** The channels that the service hears, those of the service contract left out. */
  public final List<Channel<?>> subscribedChannels() {
    return List.copyOf(wiring.registrations().subscribed());
  }

  /** What the service was given at its construction. */
  protected final ServiceContext context() {
    return context;
  }

  /** The time of the run. */
  protected final Clock clock() {
    return context.clock();
  }

  /** The time now [s] of the run's clock. */
  protected final double nowS() {
    return Clock.seconds(context.clock().micros());
  }

  final LogFile logFile() {
    return configuration.log();
  }
}
