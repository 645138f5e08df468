package org.u2sa.service;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** A service's end of its communication: the connection and its registrations. */
final class ServiceWiring {
  private final Registrations registrations = new Registrations();
  private final Transport transport;
  private final String serviceName;
  private final List<Channel<?>> prepared = new CopyOnWriteArrayList<>(); // on predecessor's
  private ServiceReceiver receiver; // the connection's
  private volatile Connection connection; // open or null; writes guarded by this
  private volatile boolean staged; // waits for the predecessor's connection
  private volatile boolean silent; // the connection is the successor's, or never existed
  private volatile long refused; // final count of the closed connection
  private volatile long missed; // likewise
  private volatile String instance; // of the connection, even after closing
  private final Clock clock;
  private final Execution execution;
  private final Outlet outlet;
  private final AtomicLong published = new AtomicLong(); // without contract messages
  private final AtomicLong publishedMicros = new AtomicLong(); // time of the last one
  private boolean closed;

  ServiceWiring(ServiceContext context, String serviceName, ServiceReceiver receiver) {
    this.serviceName = serviceName;
    this.receiver = receiver;
    staged = context.predecessor().isPresent();
    clock = context.clock();
    execution = context.execution();
    outlet = execution.outlet((channel, message) -> connection().publish(channel, message));
    this.transport = context.transport().orElseGet(() -> remote(context));
  }

  /** Address of the Communication Manager, if in another process. */
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
   * The connection, opened at the first call with the service contract's subscriptions.
   *
   * @throws CommunicationException if the Communication Manager cannot be reached
   */
  Connection connection() {
    Connection open = connection;
    return open != null ? open : connect();
  }

  /** Connects, unless the predecessor's connection will be used. */
  void begin() {
    if (!staged) {
      connection();
    }
  }

  /** {@link #begin} with a success result. */
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
      execution.connects(instance);
      connection = made;
      for (Channel<?> channel : ContractResponder.CHANNELS) {
        made.subscribe(channel);
      }
    }
    return connection;
  }

  boolean publish(Channel<?> channel, U2SAData message, long nowMicros) {
    if (!outlet.publish(channel, message)) {
      return false;
    }
    if (!ContractResponder.CHANNELS.contains(channel) && !channel.equals(Channels.HEALTH)) {
      publishedMicros.lazySet(nowMicros); // visible before the following count
      published.incrementAndGet();
    }
    return true;
  }

  /** Unique ID of this connection among those of the same service; empty before the first. */
  Optional<String> instance() {
    return Optional.ofNullable(instance);
  }

  /** The service's publications and subscriptions. */
  Registrations registrations() {
    return registrations;
  }

  /** Number of messages published, without contract messages. */
  long published() {
    return published.get();
  }

  /** Time since the last published message [s]; empty before the first. */
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
   * Subscribes on the predecessor's connection to channels that only this service uses; their
   * messages wait in this service's inbox. Done in advance, because a remote Communication Manager
   * may answer slowly.
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

  /** Undoes a successor's {@link #prepare}. */
  void forget(ServiceWiring successor) {
    receiver().forget();
    successor.prepared.forEach(this::unsubscribeUnlessNeeded);
  }

  /**
   * Hands the open connection and its receiver to a successor; this service no longer publishes.
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
        open.subscribe(channel); // registered during the takeover
      }
    }
    prepared.clear();
  }

  /** Ends subscriptions of the predecessor that this service does not need. */
  void dropSubscriptionsOnlyOf(ServiceWiring old) {
    old.registrations.subscribed().forEach(this::unsubscribeUnlessNeeded);
  }

  private synchronized void unsubscribeUnlessNeeded(Channel<?> channel) {
    Connection open = connection;
    if (open != null && !registrations.listensTo(channel)) {
      open.unsubscribe(channel);
    }
  }

  /** Message callback of the connection. */
  synchronized ServiceReceiver receiver() {
    return receiver;
  }

  /** Silently drops everything published from now on. */
  void silence() {
    silent = true;
  }

  boolean isSilent() {
    return silent;
  }

  /** Number of messages refused or unreadable. Does not block on the connection. */
  long refused() {
    Connection open = connection;
    return open == null ? refused : open.refused();
  }

  /** Number of messages lost in transit. Does not block on the connection. */
  long missed() {
    Connection open = connection;
    return open == null ? missed : open.missed();
  }

  /** Names of the channels whose subscription the broker refused. */
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
