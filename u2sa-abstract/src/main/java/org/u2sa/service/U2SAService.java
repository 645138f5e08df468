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
import org.u2sa.service.actuator.EmergencyLatch;
import org.u2sa.service.handover.HandOver;
import org.u2sa.service.inbox.CallbackStopwatch;
import org.u2sa.service.inbox.ServiceInbox;

/**
 * A service: one thread that knows no other service and communicates by messages only (thesis
 * 3.2.2.1, 4.6.1, 8.2.3.1).
 *
 * <p>A direct subclass follows thesis 8.2.4: {@link #run} loops while {@link #running} is true and
 * waits by {@link #sleep}, {@link #callback} handles messages on a separate thread, and {@link
 * #kill} closes what the service opened and clears {@link #running}. Most authors extend {@link
 * EventDrivenService} or {@link PeriodicService} instead, which have one thread and no loop to
 * write.
 *
 * <pre>
 *   CREATED ──start()──▶ RUNNING ──kill(), stop command──▶ STOPPING ──▶ STOPPED
 *                           └──── too many errors in a row ───────────▶ FAILED
 * </pre>
 *
 * <p>Registering, reading variables and logging are available in the constructor. This class
 * handles discovery, stop, configuration and health for every service.
 */
public abstract class U2SAService extends Thread
    implements Communicator, Publisher, Subscriber, Logger, ServiceInstance {
  /** {@link #endReason} of a service that ended with all others of its system. */
  public static final String ALL_STOPPED = "all services were ordered to stop";

  /** Identifies the service's thread in the log (thesis 8.2.3.1). */
  protected final int threadID;

  /**
   * Whether the loop should continue (thesis 8.2.3.1). Cleared by {@link #kill} and the stop
   * command.
   */
  protected volatile boolean running;

  final ServiceHealth health;
  final AuthoredLoop loop; // null: run() is the default loop
  final ServiceLife life;
  final ServiceReceiver.Recipient recipient;
  final ServiceConnection connection;
  final ConfigurationWriter configurationWriter;
  final Succession succession;
  final MessageHandling handling;

  private final ServiceContext context;
  private final ServiceRole role;
  private final ServiceConfiguration configuration;
  private final Registrations registrations = new Registrations();
  private final ServiceRegistration channels;
  private final HealthReporter reporter;

  /**
   * Reads the common variables, opens the log file and connects to the Communication Manager.
   *
   * @param serviceName default name, overridden by the variable SERVICE NAME
   * @throws org.u2sa.interfaces.configuration.ConfigurationException if a variable is invalid
   * @throws CommunicationException if the Communication Manager cannot be reached
   */
  protected U2SAService(ServiceContext context, ServiceRole role, String serviceName) {
    context.execution().requireRole(role);
    this.context = context;
    this.role = role;
    health = new ServiceHealth(new CallbackStopwatch(context.clock()));
    threadID = context.execution().threadId((int) getId());
    configuration = new ServiceConfiguration(context, serviceName);
    setName(configuration.name());
    loop = hasReadyMadeLoop() ? null : authoredLoop();
    life = new ServiceLife(this, configuration, health, loop, host());
    ServiceInbox inbox =
        new ServiceInbox(configuration.settings().inboxCapacity(), configuration.clock());
    succession =
        new Succession(
            context,
            configuration,
            this::takeOver,
            this::firstStepAt,
            what -> remark("STATE", what));
    recipient =
        new ServiceReceiver.Recipient(
            configuration, registrations, inbox, life, succession.orders());
    connection = new ServiceConnection(context, recipient, loop);
    context.onAbandon(connection::close);
    channels = new ServiceRegistration(connection, role);
    configurationWriter = new ConfigurationWriter(configuration, life);
    reporter =
        new HealthReporter(recipient, connection, health, loop == null ? this : loop.messages());
    ConfigurationResponder responder =
        new ConfigurationResponder(
            configuration,
            connection,
            health,
            configurationWriter,
            succession.orders(),
            this::configurationRefusal,
            this::configurationChanged);
    handling =
        new MessageHandling(
            recipient,
            health,
            new ContractResponder(this, life, connection, responder),
            configurationWriter,
            reporter,
            succession,
            this::callback);
    try {
      connection.begin();
    } catch (CommunicationException e) {
      log(LogLevelEnum.ERROR, e.getMessage());
      context.abandon();
      throw e;
    }
  }

  private AuthoredLoop authoredLoop() {
    return new AuthoredLoop(
        this,
        configuration,
        registrations,
        () -> running,
        () -> handling.run(threadID, () -> {}, () -> loop.turns(handling.until(Clock.NEVER))),
        () -> {
          running = false;
          life.atLast("kill()", this::kill);
        });
  }

  private ServiceLife.Host host() {
    return new ServiceLife.Host(
        () -> running,
        continues -> running = continues,
        super::start,
        () -> succession.refuse("it ended before"),
        this::release,
        () -> handling.reportLast(),
        () -> connection.close());
  }

  /**
   * The service's loop, on its own thread, while {@link #running}. A loop that returns earlier has
   * failed. Without continuous work it returns immediately, and the service only handles messages.
   */
  @Override
  public abstract void run();

  /**
   * Ends the service: closes what it opened and clears {@link #running}. Also called when the
   * service ends for another reason, such as a stop command. Safe to call twice and from any
   * thread. In {@link EventDrivenService} and {@link PeriodicService} it returns when the service
   * has ended; a direct subclass ends within 0.25 s, or in {@link #shutDown}.
   */
  @Override
  public abstract void kill();

  /** {@linkplain #kill Kills} the service and waits until it has ended, a few seconds at most. */
  public final void shutDown() {
    kill();
    if (loop != null) {
      life.finishLoop();
    }
  }

  /** Waits until the service has ended; returns immediately if it was never started. */
  public final void awaitEnd() throws InterruptedException {
    join();
    if (loop != null) {
      loop.messages().join();
    }
  }

  /**
   * Sleeps on the run's clock, possibly in simulated time, in a direct subclass's {@link #run}
   * loop, and returns early when the service is told to end. On any other thread it is {@link
   * Thread#sleep}.
   *
   * @param millis duration [ms], not negative
   */
  public static void sleep(long millis) throws InterruptedException {
    if (Thread.currentThread() instanceof U2SAService service && service.loop != null) {
      service.loop.sleep(millis);
    } else {
      Thread.sleep(millis);
    }
  }

  /**
   * Handles one message without a {@linkplain #subscribe handler}, on the service's thread; in a
   * direct subclass on a separate thread, so fields shared with {@link #run} must be volatile.
   */
  public void callback(U2SAData data) {
    unexpected(data);
  }

  /** Logs a message that the service does not use (thesis 8.2.4). */
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
   * Cross-checks individually valid values before a change or an undo is written: the reason to
   * reject them, or empty. Called on any thread, so it must depend on its argument only.
   *
   * @param values proposed values of all variables of this service, in the declared units
   */
  protected Optional<String> configurationRefusal(Map<String, Object> values) {
    return Optional.empty();
  }

  /**
   * Called on the service's thread after variables were changed from outside: once per set of
   * variables changed together.
   *
   * @param variableNames variables whose values changed; at least one
   */
  protected void configurationChanged(Set<String> variableNames) {}

  /** Logs with level INFO (thesis 8.2.3.1). */
  public final void log(String message) {
    log(LogLevelEnum.INFO, message);
  }

  @Override
  public final void log(LogLevelEnum level, String logMessage) {
    configuration.log().log(level, logMessage);
  }

  /**
   * Logs a problem that the service survives, such as a lost device, and reports it as the last
   * error in health. Thread-safe.
   */
  public final void trouble(String what) {
    health.error(what);
    log(LogLevelEnum.WARN, what);
  }

  /**
   * Sets a remark on a part of the service, such as counters or a fault of a source, for all
   * further health reports; empty to remove it. Thread-safe.
   */
  public final void remark(String part, String what) {
    health.remark(part, what);
  }

  // Messages (thesis 3.2.1.2–3.2.1.4)

  @Override
  public final boolean beginCommunication() {
    return channels.begin();
  }

  @Override
  public final boolean registerPublisher(Class<? extends U2SAData> dataType) {
    return channels.toPublish(dataType).filter(channels::registerPublisher).isPresent();
  }

  /** {@link #registerPublisher(Class)} on the channel of that name (thesis 8.2.3.1). */
  public final boolean registerPublisher(String channelName) {
    return channels.named(channelName).filter(channels::registerPublisher).isPresent();
  }

  public final boolean registerPublisher(Channel<?> channel) {
    return channels.registerPublisher(channel);
  }

  @Override
  public final boolean unregisterPublisher(Class<? extends U2SAData> dataType) {
    return channels.toPublish(dataType).filter(connection::unregisterPublisher).isPresent();
  }

  @Override
  public final boolean registerSubscriber(Class<? extends U2SAData> dataType) {
    return channels.toSubscribe(dataType).filter(channels::registerSubscriber).isPresent();
  }

  /** {@link #registerSubscriber(Class)} on the channel of that name (thesis 8.2.3.1). */
  public final boolean registerSubscriber(String channelName) {
    return channels.named(channelName).filter(channels::registerSubscriber).isPresent();
  }

  public final boolean registerSubscriber(Channel<?> channel) {
    return channels.registerSubscriber(channel);
  }

  /**
   * {@link #registerSubscriber(Channel)} with a deadline: a message that is older when it would be
   * handled, or has no timestamp, is dropped and counted as expired in health. Another call
   * replaces the deadline.
   *
   * @param deadlineS maximum age [s], positive
   */
  public final boolean registerSubscriber(Channel<?> channel, double deadlineS) {
    registrations.deadline(channel, Clock.micros(deadlineS));
    return registerSubscriber(channel);
  }

  /** Age beyond which orders are ignored, the variable ORDER EXPIRY [s]; 0: never. */
  public final double orderExpiryS() {
    return configuration.orderExpiryS();
  }

  /**
   * Reason for not obeying an order: it is older than ORDER EXPIRY, so its sender has given it up.
   * A broker may have kept it while a link was down. Empty if the order is in time or has no
   * timestamp.
   */
  public final Optional<String> lateness(U2SAData order) {
    return configuration.lateness(order);
  }

  /**
   * {@link #registerSubscriber(Channel)} with a handler, called on the service's thread instead of
   * {@link #callback}. Another call replaces it.
   */
  public final <T extends U2SAData> boolean subscribe(
      Channel<T> channel, Consumer<? super T> handler) {
    registrations.handler(channel, handler);
    return registerSubscriber(channel);
  }

  /**
   * {@link #subscribe(Channel, Consumer)} with a {@linkplain #registerSubscriber(Channel, double)
   * deadline}.
   */
  public final <T extends U2SAData> boolean subscribe(
      Channel<T> channel, double deadlineS, Consumer<? super T> handler) {
    registrations.handler(channel, handler);
    return registerSubscriber(channel, deadlineS);
  }

  @Override
  public final boolean unregisterSubscriber(Class<? extends U2SAData> dataType) {
    return channels.toSubscribe(dataType).filter(channels::unregisterSubscriber).isPresent();
  }

  @Override
  public final boolean publish(U2SAData data) {
    Optional<Channel<?>> channel = registrations.channelFor(data);
    return channel.isPresent()
        ? connection.publish(channel.get(), data)
        : connection.refuse(
            "not registered as a publisher of " + data.type().name() + ": not published");
  }

  /** Publishes on the channel of that name (thesis 8.2.3.1). */
  public final boolean publish(String channelName, U2SAData data) {
    return channels.named(channelName).filter(channel -> publish(channel, data)).isPresent();
  }

  /**
   * Publishes on a channel. Fills in a missing system ID and timestamp, and freezes the message.
   */
  public final boolean publish(Channel<?> channel, U2SAData data) {
    return connection.publish(channel, data);
  }

  /**
   * Reports the emergency stops active here, immediately and in all further health reports: an
   * operator's stop is confirmed when all services that obey stops have reported it. Called on the
   * service's thread, and in its constructor with an empty list to declare that it obeys stops.
   *
   * @param identities from {@link EmergencyLatch#identities}
   */
  public final void heedsEmergencyStops(List<String> identities) {
    if (health.emergencyStops(identities)) {
      reporter.reportSoon();
    }
  }

  // Life cycle (thesis 8.2.3.1)

  /**
   * Starts the thread. A service already ordered to stop ends without running. A restarted service
   * resumes its saved state.
   *
   * @throws org.u2sa.interfaces.configuration.ConfigurationException if the configuration contains
   *     an unknown variable
   * @throws IllegalThreadStateException if it was started or killed before
   */
  @Override
  public void start() {
    succession.resume();
    life.start();
  }

  /**
   * Calls handlers and steps on this service's own thread even in a simulation, where by default a
   * thread of the run's clock calls them: for libraries with thread affinity. Slows the simulation
   * down. Called in the constructor.
   */
  protected final void keepToOwnThread() {
    life.keepToOwnThread();
  }

  /** Whether {@link #run} is the default loop, which also handles messages. */
  boolean hasReadyMadeLoop() {
    return false;
  }

  /** Closes the subclass's resources and sets its actuators to neutral; called once at the end. */
  protected void release() {}

  /**
   * Called instead of {@link #release} when a successor takes over. Nothing can be published. Leave
   * actuators as they are, because the successor continues to command them.
   */
  protected void releaseToSuccessor() {
    release();
  }

  /**
   * Abandons a hung service: interrupts its thread; if that does not help, sets the actuators to
   * neutral from another thread and disconnects it, which releases its name. Returns within a few
   * seconds.
   */
  public final void abandon() {
    life.abandon();
  }

  /** Whether the service's loop is running. */
  public final boolean isRunning() {
    return running;
  }

  public final ServiceStatus status() {
    return life.status();
  }

  /** Why a message ended the service; empty if none did. */
  public final Optional<String> endReason() {
    return life.endReason();
  }

  /**
   * Substitute health report for the host to publish on {@link
   * org.u2sa.interfaces.communication.Channels#HEALTH} if the service's report is overdue; empty if
   * it is not, or if the service has ended. Thread-safe.
   */
  public final Optional<HealthReport> overdueHealth() {
    return reporter.onBehalf(clock().micros());
  }

  // Succession (thesis 5.1, user story 8)

  /**
   * Saves what a service of another class needs for a bumpless takeover: what was learnt since the
   * start, such as the current goal or an integrator. Called on the service's thread between two
   * messages; this service continues if the successor refuses.
   */
  protected void handOver(HandOver state) {}

  /**
   * Restores the state saved by the predecessor, which may be of any class of the same role, or
   * {@linkplain #remember remembered} before a restart. Called once, before the thread runs, and
   * not at a first start. Nothing can be published yet.
   *
   * @throws RuntimeException if the service cannot resume from that state: a {@link ServiceSwap}
   *     keeps the predecessor; a restart fails, and the next one starts without saved state
   */
  protected void takeOver(HandOver state) {}

  /**
   * Saves the current {@link #handOver} state in the log folder, for {@link #takeOver} after a
   * restart in this run, even if the process was killed. Called on the service's thread whenever
   * state changes that must not be lost.
   */
  protected final void remember() {
    if (running && !connection.isSilent()) { // else abandoned or replaced: its successor saves now
      succession.remember(this::handedOver);
    }
  }

  final HandOver handedOver() {
    HandOver state = new HandOver(getClass().getName());
    handOver(state);
    return state.savedAt(nowS());
  }

  /** Called before the start with the predecessor. */
  void succeeds(U2SAService predecessor) {
    succession.succeeds();
  }

  /** Sets when a periodic service's first step is due [µs of the run's clock]. */
  void firstStepAt(long micros) {}

  /** When the first step is due [µs of the run's clock]; empty if immediately or never. */
  OptionalLong firstStepMicros() {
    return OptionalLong.empty();
  }

  // Properties

  @Override
  public final String getServiceName() {
    return getName();
  }

  public final int getThreadID() {
    return threadID;
  }

  @Override
  public final ServiceRole role() {
    return role;
  }

  /** The channels on which the service publishes. */
  public final List<Channel<?>> publishedChannels() {
    return List.copyOf(registrations.published());
  }

  /** Subscribed channels, except those of the service contract. */
  public final List<Channel<?>> subscribedChannels() {
    return List.copyOf(registrations.subscribed());
  }

  protected final ServiceContext context() {
    return context;
  }

  protected final Clock clock() {
    return context.clock();
  }

  /** Current time of the run's clock [s]. */
  protected final double nowS() {
    return Clock.seconds(context.clock().micros());
  }

  @Override
  public final LogFile logForSuccessor(Clock successors) {
    return configuration.log().forSuccessor(successors);
  }

  final LogFile logFile() {
    return configuration.log();
  }
}
