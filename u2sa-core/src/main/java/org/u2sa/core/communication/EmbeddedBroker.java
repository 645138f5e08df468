package org.u2sa.core.communication;

import io.moquette.BrokerConstants;
import io.moquette.broker.Server;
import io.moquette.broker.config.IConfig;
import io.moquette.broker.config.MemoryConfig;
import io.moquette.broker.security.PermitAllAuthorizatorPolicy;
import io.moquette.interception.AbstractInterceptHandler;
import io.moquette.interception.messages.InterceptConnectMessage;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.util.List;
import java.util.Optional;
import java.util.Properties;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.communication.web.WebConnection;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.schema.MessageCodec;

/**
 * The in-process broker, bridged to the direct path: remote messages go onto the bus, and copies of
 * local ones go out.
 */
final class EmbeddedBroker implements AutoCloseable {
  private static final String BACKLOG = "1024"; // listen backlog

  private final LocalBus bus;
  private final Consumer<String> log;
  private final InetSocketAddress address;
  private final Server server = new Server();
  private final IncomingCopies incoming;
  private final AtomicLong notTaken = new AtomicLong(); // undelivered at shutdown
  private final OutgoingCopies copies;
  private final ConnectionFilter filter;
  private final Runnable died;
  private volatile boolean closing;

  private EmbeddedBroker(
      LocalBus bus,
      MessageCodec codec,
      InetSocketAddress address,
      ConnectionFilter filter,
      Consumer<String> log,
      Runnable died) {
    this.filter = filter;
    this.died = died;
    this.bus = bus;
    incoming = new IncomingCopies(bus, codec, log);
    this.address = address;
    this.log = log;
    copies = new OutgoingCopies(bus.systemId(), codec, filter.broker, log);
  }

  /**
   * Starts a broker and bridges it to the bus.
   *
   * @param died called when the broker can no longer serve; must return immediately
   * @throws PortTakenException if it cannot listen
   */
  static EmbeddedBroker start(
      LocalBus bus,
      MessageCodec codec,
      InetSocketAddress address,
      Optional<WebPort> web,
      BrokerSecurity security,
      BrokerLimits limits,
      Consumer<String> log,
      Runnable died) {
    refuseTakenPort(address, ManagerVariables.PORT);
    web.ifPresent(port -> refuseTakenPort(port.address(), ManagerVariables.WEB_PORT));
    ConnectionFilter filter =
        new ConnectionFilter(
            limits, codec, new SystemClock(), security.users(log), security.encryption(), log);
    web.ifPresent(filter::serve);
    EmbeddedBroker broker = new EmbeddedBroker(bus, codec, address, filter, log, died);
    try {
      broker.server.startServer(
          new MemoryConfig(properties(address, web)),
          List.of(broker.new Listener()),
          () -> null, // the connection filter encrypts
          (clientId, user, password) -> filter.letIn(password),
          new PermitAllAuthorizatorPolicy()); // the connection filter has checked each packet
      FilterInstaller.install(filter, broker.server);
    } catch (IOException | RuntimeException e) {
      FilterInstaller.takeDown(
          broker.server); // another program may have been faster than the probe
      filter.close();
      throw cannotListen(address, ManagerVariables.PORT, e);
    }
    filter.broker.router.join(broker.incoming);
    filter.broker.sources.join(bus);
    broker.copies.start();
    bus.attach(broker.copies);
    return broker;
  }

  private static Properties properties(InetSocketAddress address, Optional<WebPort> web) {
    Properties properties = new Properties();
    properties.setProperty(IConfig.HOST_PROPERTY_NAME, address.getHostString());
    properties.setProperty(IConfig.PORT_PROPERTY_NAME, String.valueOf(address.getPort()));
    properties.setProperty(BrokerConstants.NETTY_SO_BACKLOG_PROPERTY_NAME, BACKLOG);
    properties.setProperty(
        IConfig.ALLOW_ANONYMOUS_PROPERTY_NAME, "false"); // clients get names from the filter
    properties.setProperty(IConfig.PERSISTENCE_ENABLED_PROPERTY_NAME, "false");
    properties.setProperty(IConfig.ENABLE_TELEMETRY_NAME, "false"); // would report to its makers
    properties.setProperty(
        IConfig.NETTY_MAX_BYTES_PROPERTY_NAME, String.valueOf(BrokerLimits.LONGEST_PACKET));
    properties.setProperty(
        IConfig.BUFFER_FLUSH_MS_PROPERTY_NAME, "0"); // flush immediately for low latency
    if (web.isPresent()) {
      properties.setProperty(
          IConfig.WEB_SOCKET_PORT_PROPERTY_NAME, String.valueOf(web.get().address().getPort()));
      properties.setProperty(IConfig.WEB_SOCKET_PATH_PROPERTY_NAME, WebConnection.MQTT_PATH);
      properties.setProperty(
          BrokerConstants.WEB_SOCKET_MAX_FRAME_SIZE_PROPERTY_NAME,
          String.valueOf(WebConnection.LONGEST_FRAME));
    }
    return properties;
  }

  /**
   * Probes the port first, because Moquette reports a taken one only in its own log with a stack
   * trace.
   */
  private static void refuseTakenPort(InetSocketAddress address, String variable) {
    try (ServerSocket probe = new ServerSocket()) {
      probe.bind(address);
    } catch (IOException | IllegalArgumentException e) {
      throw cannotListen(address, variable, e);
    }
  }

  private static PortTakenException cannotListen(
      InetSocketAddress address, String variable, Exception e) {
    return new PortTakenException(
        String.format(
            "the Communication Manager cannot listen on %s:%s: %s; is the port taken by"
                + " another system or broker? %s sets another",
            address.getHostString(), address.getPort(), e.getMessage(), variable),
        e);
  }

  InetSocketAddress address() {
    return address;
  }

  /** Whether the name is one of a service of this process or of a process that this one started. */
  boolean isOfVehicle(String serviceName) {
    return filter.broker.sources.isOfVehicle(bus.systemId(), serviceName);
  }

  long dropped() {
    return copies.dropped() + filter.broker.dropped() + notTaken.get();
  }

  @Override
  public void close() {
    bus.detach(copies);
    copies.close();
    int owed = filter.drain();
    if (owed > 0) {
      notTaken.addAndGet(owed);
      log.accept(owed + " or more messages were undelivered to remote subscribers at shutdown");
    }
    closing = true;
    FilterInstaller.takeDown(server);
    server.stopServer();
    filter.close();
  }

  /**
   * Called by Moquette sequentially on its own thread. Moquette's client ID is the unique {@link
   * ClientSession#connection}, so no event refers to another connection.
   */
  private final class Listener extends AbstractInterceptHandler {
    @Override
    public String getID() {
      return "CommunicationManager";
    }

    @Override
    public void onSessionLoopError(Throwable error) {
      if (closing) {
        return; // threads end in any order and may find others already closed
      }
      log.accept("the broker failed: " + error);
      died.run();
    }

    @Override
    public void onConnect(InterceptConnectMessage message) {
      filter.broker.clients.connected(message.getClientID());
    }
  }
}
