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
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.log.LogLevelEnum;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** A service's connection: publishes, subscribes, and is handed to a successor. */
final class ServiceConnection {
  private record ManagerAddress(
      @Variable(name = "COMMUNICATION MANAGER IP", ifAbsentText = "localhost")
          @Description("Host of the Communication Manager, if it runs in another process.")
          String host,
      @Variable(name = "COMMUNICATION MANAGER PORT", min = 1, max = 65_535, ifAbsent = 1883)
          @Description("TCP port of the Communication Manager, if it runs in another process.")
          int port) {

    Transport transport(ServiceContext context) {
      return new MqttTransport(
          host,
          port,
          context.systemId(),
          new MessageCodec(context.messageTypes()),
          BrokerAccess.configured(context.configuration()));
    }
  }

  private final ServiceContext context;
  private final ServiceConfiguration configuration;
  private final Registrations registrations;
  private final AuthoredLoop loop; // null: the service runs the default loop
  private final Transport transport;
  private final Execution.Outlet unconnected; // connects, or throws if that is not possible
  private final List<Channel<?>> prepared = new CopyOnWriteArrayList<>(); // on predecessor's
  private ServiceReceiver receiver; // the connection's
  private volatile Connection connection; // open or null; writes guarded by this
  private volatile Execution.Outlet
      outlet; // the connection's if it is open; writes guarded by this
  private volatile boolean staged; // waits for the predecessor's connection
  private volatile boolean silent; // the successor owns the connection, or it never existed
  private volatile long refused; // final count of the closed connection
  private volatile long missed; // likewise
  private volatile String instance; // of the connection, even after closing
  private final AtomicLong notAccepted = new AtomicLong(); // the service's messages
  private final AtomicLong published = new AtomicLong(); // without contract messages
  private final AtomicLong publishedMicros = new AtomicLong(); // time of the last one
  private boolean closed;

  /**
   * @param service gets the messages
   * @param loop null if the service runs the default loop
   */
  ServiceConnection(ServiceContext context, ServiceReceiver.Recipient service, AuthoredLoop loop) {
    this.context = context;
    configuration = service.configuration();
    registrations = service.registrations();
    this.loop = loop;
    receiver = new ServiceReceiver(service);
    staged = context.predecessor().isPresent();
    unconnected =
        context.execution().outlet((channel, message) -> connection().publish(channel, message));
    outlet = unconnected;
    transport =
        context
            .transport()
            .orElseGet(
                () ->
                    context
                        .configuration()
                        .settings(ManagerAddress.class)
                        .get()
                        .transport(context));
  }

  /**
   * The connection, opened at the first call.
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

  private synchronized Connection connect() {
    if (staged) {
      throw new CommunicationException(
          "service \"" + configuration.name() + "\" has not yet taken over from its predecessor");
    }
    if (closed) {
      throw new CommunicationException(
          "service \"" + configuration.name() + "\" has ended its communication");
    }
    if (connection == null) {
      Connection made = transport.connect(configuration.name(), receiver);
      instance = made.instance();
      context.execution().connects(instance);
      open(made);
      for (Channel<?> channel : ServiceContract.CHANNELS) {
        made.subscribe(channel);
      }
    }
    return connection;
  }

  private void open(Connection made) {
    connection = made;
    outlet = context.execution().outlet(made::publish);
  }

  private void leave() {
    connection = null;
    outlet = unconnected;
  }

  /** {@link U2SAService#publish(Channel, U2SAData)}. */
  boolean publish(Channel<?> channel, U2SAData data) {
    if (silent) {
      return false; // the successor has replaced this service
    }
    if (loop != null) {
      loop.awaitTurn();
    }
    long nowMicros = context.clock().micros();
    if (!data.isFrozen()) {
      if (data.systemId().isEmpty()) {
        data.systemId(context.systemId());
      }
      if (data.timestamp().isEmpty()) {
        data.timestamp(nowMicros);
      }
      data.freeze();
    }
    try {
      if (!outlet.publish(channel, data)) {
        if (Long.bitCount(notAccepted.incrementAndGet()) == 1) { // 1, 2, 4, 8…: limits the log
          refuse("publishing on " + channel + " was refused: " + data);
        }
        return false;
      }
    } catch (CommunicationException e) {
      return refuse("publishing on " + channel + " failed: " + e.getMessage());
    }
    if (!ServiceContract.CHANNELS.contains(channel) && !channel.equals(Channels.HEALTH)) {
      publishedMicros.lazySet(nowMicros); // visible before the following count
      published.incrementAndGet();
    }
    return true;
  }

  boolean refuse(String why) {
    configuration.log(LogLevelEnum.ERROR, why);
    return false;
  }

  /** ID of this connection; empty before the first. */
  Optional<String> instance() {
    return Optional.ofNullable(instance);
  }

  Registrations registrations() {
    return registrations;
  }

  /** Messages published, without contract messages. */
  long published() {
    return published.get();
  }

  OptionalDouble dataAgeS() {
    return published() == 0
        ? OptionalDouble.empty()
        : OptionalDouble.of(
            Clock.seconds(Math.max(0, context.clock().micros() - publishedMicros.get())));
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
    boolean contract = ServiceContract.CHANNELS.contains(channel);
    return registrations.subscribed().remove(channel)
        && (contract || staged || connection().unsubscribe(channel));
  }

  /**
   * Subscribes on the predecessor's connection to channels that only this service uses, whose
   * messages wait in its inbox; in advance, because a remote Communication Manager may answer
   * slowly.
   */
  void prepare(ServiceConnection old, ServiceReceiver.Recipient service) {
    old.receiver().prepare(service);
    for (Channel<?> channel : registrations.subscribed()) {
      if (!old.registrations.listensTo(channel)) {
        prepared.add(channel);
        old.connection().subscribe(channel);
      }
    }
  }

  /** Undoes a successor's {@link #prepare}. */
  void forget(ServiceConnection successor) {
    receiver().forget();
    successor.prepared.forEach(this::unsubscribeUnlessNeeded);
  }

  /**
   * Hands the open connection and its receiver to a successor; false if communication has ended.
   */
  boolean moveTo(ServiceConnection successor) {
    Connection open;
    synchronized (this) {
      if (closed || connection == null) {
        return false;
      }
      open = connection;
      leave();
      closed = true;
      silent = true;
    }
    successor.adopt(open, receiver(), this);
    return true;
  }

  private synchronized void adopt(Connection open, ServiceReceiver its, ServiceConnection old) {
    instance = open.instance();
    open(open);
    receiver = its;
    staged = false;
    for (Channel<?> channel : registrations.subscribed()) {
      if (!old.registrations.listensTo(channel) && !prepared.contains(channel)) {
        open.subscribe(channel); // registered during the takeover
      }
    }
    prepared.clear();
  }

  void dropSubscriptionsOnlyOf(ServiceConnection old) {
    old.registrations.subscribed().forEach(this::unsubscribeUnlessNeeded);
  }

  private synchronized void unsubscribeUnlessNeeded(Channel<?> channel) {
    Connection open = connection;
    if (open != null && !registrations.listensTo(channel)) {
      open.unsubscribe(channel);
    }
  }

  synchronized ServiceReceiver receiver() {
    return receiver;
  }

  void silence() {
    silent = true;
  }

  boolean isSilent() {
    return silent;
  }

  /** Messages refused or unreadable. Does not block on the connection. */
  long refused() {
    Connection open = connection;
    return open == null ? refused : open.refused();
  }

  /** Messages lost in transit. Does not block on the connection. */
  long missed() {
    Connection open = connection;
    return open == null ? missed : open.missed();
  }

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
      leave();
    }
  }
}
