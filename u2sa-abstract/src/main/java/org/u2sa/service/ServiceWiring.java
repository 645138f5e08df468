package org.u2sa.service;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.interfaces.communication.BrokerAccess;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.MqttTransport;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** A service's side of its communication: the connection and what was registered on it. */
final class ServiceWiring {
  private final Registrations registrations = new Registrations();
  private final Transport transport;
  private final String serviceName;
  private final List<Channel<?>> prepared = new CopyOnWriteArrayList<>(); // on the predecessor's
  private ServiceReceiver receiver; // the connection's
  private volatile Connection connection; // open or null; written under this
  private volatile boolean staged; // waits for the predecessor's connection
  private volatile boolean silent; // the connection is a successor's, or never was
  private volatile long refused; // by the connection, when it was closed
  private volatile long missed; // likewise
  private volatile String instance; // of the connection, also after it was closed
  private final Clock clock;
  private final Execution execution; // null if nobody keeps it
  private final AtomicLong published = new AtomicLong(); // without what the contract makes it say
  private final AtomicLong publishedMicros = new AtomicLong(); // the last of them
  private boolean closed;

  ServiceWiring(ServiceContext context, String serviceName, ServiceReceiver receiver) {
    this.serviceName = serviceName;
    this.receiver = receiver;
    staged = context.predecessor().isPresent();
    clock = context.clock();
    execution = context.execution().orElse(null);
    this.transport = context.transport().orElseGet(() -> remote(context));
  }

  /** Where the Communication Manager is, if in another process. */
  private record ManagerAddress(
      @Variable(
              name = "COMMUNICATION MANAGER IP",
              ifAbsentText = "localhost",
              text = "Host of the Communication Manager, if it runs in another process.")
          String host,
      @Variable(
              name = "COMMUNICATION MANAGER PORT",
              min = 1,
              max = 65_535,
              ifAbsent = 1883,
              text = "TCP port of the Communication Manager, if it runs in another process.")
          int port) {}

  private static Transport remote(ServiceContext context) {
    ManagerAddress address = context.configuration().settings(ManagerAddress.class).get();
    return new MqttTransport(
        address.host(),
        address.port(),
        context.systemId(),
        new MessageCodec(context.messageTypes()),
        BrokerAccess.configured(context.configuration()));
  }

  /**
   * The connection, made at the first call, with the service contract's subscriptions.
   *
   * @throws CommunicationException if the Communication Manager cannot be reached
   */
  Connection connection() {
    Connection open = connection;
    return open != null ? open : connect();
  }

  /** Connects, unless the connection will be a predecessor's. */
  void begin() {
    if (!staged) {
      connection();
    }
  }

  /** {@link #begin}, for those who want to hear that it worked. */
  boolean isReady() {
    begin();
    return true;
  }

  private synchronized Connection connect() {
    if (staged) {
      throw new CommunicationException(
          "service \"" + serviceName + "\" has not yet taken over from its predecessor");
    }
    if (closed) {
      throw new CommunicationException(
          "service \"" + serviceName + "\" has ended its communication");
    }
    if (connection == null) {
      Connection made = transport.connect(serviceName, receiver);
      instance = made.instance();
      if (execution != null) {
        execution.connects(instance);
      }
      connection = made;
      for (Channel<?> channel : ContractResponder.CHANNELS) {
        made.subscribe(channel);
      }
    }
    return connection;
  }

  boolean publish(Channel<?> channel, U2SAData message, long nowMicros) {
    boolean taken =
        execution == null
            ? connection().publish(channel, message)
            : execution.publishes(channel, message, () -> connection().publish(channel, message));
    if (!taken) {
      return false;
    }
    if (!ContractResponder.CHANNELS.contains(channel) && !channel.equals(Channels.HEALTH)) {
      publishedMicros.lazySet(nowMicros); // whoever sees the count that follows sees this too
      published.incrementAndGet();
    }
    return true;
  }

  /** What tells this connection from others of the same service; empty before the first. */
  Optional<String> instance() {
    return Optional.ofNullable(instance);
  }

  /** What the service publishes and hears. */
  Registrations registrations() {
    return registrations;
  }

  /** Messages published so far, reports of the contract left out. */
  long published() {
    return published.get();
  }

  /** Time since the last of them [s]; empty before the first. */
  OptionalDouble dataAgeS() {
    return published() == 0
        ? OptionalDouble.empty()
        : OptionalDouble.of(Clock.seconds(Math.max(0, clock.micros() - publishedMicros.get())));
  }

  boolean registerPublisher(Channel<?> channel) {
    begin();
    registrations.publish(channel);
    return true;
  }

  boolean unregisterPublisher(Channel<?> channel) {
    return registrations.published().remove(channel);
  }

  synchronized boolean registerSubscriber(Channel<?> channel) {
    registrations.subscribe(channel);
    return staged || connection().subscribe(channel);
  }

  boolean unregisterSubscriber(Channel<?> channel) {
    boolean contract = ContractResponder.CHANNELS.contains(channel);
    return registrations.subscribed().remove(channel)
        && (contract || staged || connection().unsubscribe(channel));
  }

  /**
   * Subscribes on the predecessor's connection to what only this service wants; it waits in this
   * service's inbox. Done ahead, as a Communication Manager far away takes its time to answer.
   */
  void prepare(ServiceWiring old, U2SAService service) {
    old.receiver().prepare(service);
    for (Channel<?> channel : registrations.subscribed()) {
      if (!old.registrations.listensTo(channel)) {
        prepared.add(channel);
        old.connection().subscribe(channel);
      }
    }
  }

  /** Takes a successor's {@link #prepare} back. */
  void forget(ServiceWiring successor) {
    receiver().forget();
    successor.prepared.forEach(this::unsubscribeUnlessNeeded);
  }

  /**
   * Hands the open connection and its receiver to a successor; this service is silent from here on.
   *
   * @return false if this service's communication has ended
   */
  boolean moveTo(ServiceWiring successor) {
    Connection open;
    synchronized (this) {
      if (closed || connection == null) {
        return false;
      }
      open = connection;
      connection = null;
      closed = true;
      silent = true;
    }
    successor.adopt(open, receiver(), this);
    return true;
  }

  private synchronized void adopt(Connection open, ServiceReceiver its, ServiceWiring old) {
    instance = open.instance();
    connection = open;
    receiver = its;
    staged = false;
    for (Channel<?> channel : registrations.subscribed()) {
      if (!old.registrations.listensTo(channel) && !prepared.contains(channel)) {
        open.subscribe(channel); // registered late, while it took over
      }
    }
    prepared.clear();
  }

  /** Ends what the predecessor had subscribed to and this service has not. */
  void dropSubscriptionsOnlyOf(ServiceWiring old) {
    old.registrations.subscribed().forEach(this::unsubscribeUnlessNeeded);
  }

  private synchronized void unsubscribeUnlessNeeded(Channel<?> channel) {
    Connection open = connection;
    if (open != null && !registrations.listensTo(channel)) {
      open.unsubscribe(channel);
    }
  }

  /** What the connection calls with messages. */
  synchronized ServiceReceiver receiver() {
    return receiver;
  }

  /** Drops what is published from now on, without logging it. */
  void silence() {
    silent = true;
  }

  boolean isSilent() {
    return silent;
  }

  /** Messages that were not taken or could not be read. Never waits for the connection. */
  long refused() {
    Connection open = connection;
    return open == null ? refused : open.refused();
  }

  /** Messages that others sent and that were lost on the way. Never waits for the connection. */
  long missed() {
    Connection open = connection;
    return open == null ? missed : open.missed();
  }

  /** Names of the channels that the broker does not let it hear. */
  Set<String> refusedSubscriptions() {
    Connection open = connection;
    return open == null ? Set.of() : open.refusedSubscriptions();
  }

  synchronized void close() {
    closed = true;
    if (connection != null) {
      connection.close();
      refused = connection.refused();
      missed = connection.missed();
      connection = null;
    }
  }
}
