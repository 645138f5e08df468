package org.u2sa.core.communication;

import java.net.InetSocketAddress;
import java.nio.file.Paths;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.u2sa.core.communication.bridge.ClientBridge;
import org.u2sa.core.communication.discovery.BrokerAnnouncement;
import org.u2sa.core.communication.discovery.BrokerSearch;
import org.u2sa.core.communication.discovery.FoundBroker;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.communication.limit.OpenFiles;
import org.u2sa.core.communication.web.WebSite;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.CommunicationException;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Topic;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;

/**
 * The Communication Manager of the thesis, through which all services of a system communicate
 * (4.5.1.1).
 *
 * <p>By default it embeds a broker. Services of this process receive messages directly; the broker
 * sends copies to remote subscribers. With {@code BROKER} = {@code external} all services use
 * another MQTT broker, and with {@code none} no message leaves the process.
 */
public final class CommunicationManager implements AutoCloseable {
  private static final String LOOPBACK = "127.0.0.1";

  private static final double SEARCH_AT_LEAST_S = 5.0;
  private static final double OWN_BROKER_WITHIN_S = 30.0; // allows for a loaded machine

  private final Transport transport;
  private final Supplier<MqttTransport> remote; // null without a broker
  private final Supplier<MqttTransport> own; // likewise
  private final BrokerSupervisor broker; // null unless embedded
  private final BrokerAnnouncement announcement; // null if none
  private final BrokerSecurity security; // null unless embedded
  private volatile ClientBridge rosbridge; // null if none

  private CommunicationManager(
      Transport transport,
      Supplier<MqttTransport> remote,
      Supplier<MqttTransport> own,
      BrokerSupervisor broker,
      BrokerAnnouncement announcement,
      BrokerSecurity security) {
    this.security = security;
    this.transport = transport;
    this.remote = remote;
    this.own = own;
    this.broker = broker;
    this.announcement = announcement;
  }

  /**
   * Starts the Communication Manager of a system.
   *
   * @param systemId the vehicle
   * @param configuration the Communication Manager's variables
   * @param types the message types that remote clients may publish
   * @param log receives later failures, one line each
   * @throws CommunicationException if the port is taken or the external broker does not answer
   * @throws org.u2sa.interfaces.configuration.ConfigurationException if a variable is wrong
   */
  public static CommunicationManager start(
      String systemId, Configurator configuration, MessageTypes types, Consumer<String> log) {
    return start(systemId, configuration, types, WebSite::discovered, log);
  }

  /** Likewise, with an operator's page of its own. */
  public static CommunicationManager start(
      String systemId,
      Configurator configuration,
      MessageTypes types,
      Supplier<WebSite> page,
      Consumer<String> log) {
    ManagerVariables manager = configuration.settings(ManagerVariables.class).get();
    String bindAddress = manager.bindAddress();
    int port = manager.communicationManagerPort();
    double patienceS = manager.communicationManagerWait();
    BrokerLimits configured = configuration.settings(BrokerLimits.class).get();
    BrokerSecurity.Variables settings =
        configuration.settings(BrokerSecurity.Variables.class).get();
    BrokerAccess.Login login = configuration.settings(BrokerAccess.Login.class).get();
    Supplier<BrokerAccess> access = () -> access(login, settings.securityDirectory());
    MessageCodec codec = new MessageCodec(types, manager.form());
    if (manager.broker().equals("external")) {
      BrokerAccess as = access.get().orAccount();
      InetSocketAddress broker =
          InetSocketAddress.createUnresolved(manager.communicationManagerIp(), port);
      if (manager.communicationManagerIp().equals(BrokerSearch.AUTO)) {
        FoundBroker found = search(systemId, as, Math.max(patienceS, SEARCH_AT_LEAST_S));
        log.accept("broker found by mDNS: " + found);
        broker = new InetSocketAddress(found.host(), found.port());
      }
      MqttTransport transport =
          new MqttTransport(broker.getHostString(), broker.getPort(), systemId, codec, as)
              .waiting(patienceS);
      transport.connect("CommunicationManager", new Probe()).close();
      return new CommunicationManager(
          transport, () -> transport, () -> transport, null, null, null);
    }
    LocalBus bus = new LocalBus(systemId);
    BrokerSupervisor broker = null;
    BrokerAnnouncement announcement = null;
    Supplier<MqttTransport> remote = null;
    Supplier<MqttTransport> own = null;
    BrokerSecurity secured = null;
    if (manager.broker().equals("embedded")) {
      BrokerLimits limits = OpenFiles.fitted(configured, log);
      BrokerSecurity security = BrokerSecurity.of(settings, bindAddress, port, log);
      secured = security;
      Optional<WebPort> web = WebPort.of(manager, page, security.isOn());
      InetSocketAddress address = new InetSocketAddress(bindAddress, port);
      broker =
          security.starting(
              () ->
                  new BrokerSupervisor(
                      died ->
                          EmbeddedBroker.start(
                              bus, codec, address, web, security, limits, log, died),
                      log));
      String reached = address.getAddress().isAnyLocalAddress() ? LOOPBACK : bindAddress;
      remote = () -> new MqttTransport(reached, port, systemId, codec, access.get());
      own =
          () ->
              new MqttTransport(reached, port, systemId, codec, security.ownAccess())
                  .waiting(OWN_BROKER_WITHIN_S);
      web.ifPresent(served -> log.accept(security.loginLine(served.link())));
      if (manager.announces()) {
        announcement =
            BrokerAnnouncement.start(
                bindAddress, systemId, port, security.isOn(), new SystemClock(), log);
      }
    }
    CommunicationManager started =
        new CommunicationManager(bus, remote, own, broker, announcement, secured);
    started.startRosbridge(systemId, manager, codec, log);
    return started;
  }

  /**
   * @throws RuntimeException if it cannot be started; this manager is then closed
   */
  private void startRosbridge(
      String systemId, ManagerVariables manager, MessageCodec codec, Consumer<String> log) {
    if (broker == null || manager.rosbridgePort() == 0) {
      return;
    }
    try {
      InetSocketAddress bound = broker.address();
      String reached =
          bound.getAddress().isAnyLocalAddress() ? LOOPBACK : bound.getAddress().getHostAddress();
      rosbridge =
          ClientBridge.start(
              "rosbridge",
              new ClientBridge.Setting(
                  new InetSocketAddress(manager.bindAddress(), manager.rosbridgePort()),
                  new MqttTransport(reached, bound.getPort(), systemId, codec, security.anonymous())
                      .ofTool(),
                  security.directory(),
                  security::isOperator,
                  log));
    } catch (RuntimeException | Error e) {
      close();
      throw e;
    }
  }

  /**
   * Broker access; with the secured broker's own configuration, its authority is trusted by
   * default.
   */
  private static BrokerAccess access(BrokerAccess.Login login, String directory) {
    String authority =
        login.authority().isEmpty() && !directory.isEmpty()
            ? new SecurityDirectory(Paths.get(directory)).authority().toString()
            : login.authority();
    return BrokerAccess.of(login.user(), login.passwordFile(), login.tls(), authority);
  }

  private static FoundBroker search(String systemId, BrokerAccess access, double timeoutS) {
    try {
      FoundBroker found = BrokerSearch.theOnly(Optional.of(systemId), new SystemClock(), timeoutS);
      if (found.encrypted() && !access.isEncrypted()) {
        throw new BadInputException("the broker " + found + " requires TLS: set CA FILE");
      }
      return found;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CommunicationException("interrupted while looking for the broker", e);
    }
  }

  /** The transport of this process's services. */
  public Transport transport() {
    return transport;
  }

  /**
   * The transport that routes this process's services through the broker by MQTT, even between
   * themselves. They have full access and need no account. Empty without a broker.
   */
  public Optional<Transport> brokerTransport() {
    return Optional.ofNullable(own).map(Supplier::get);
  }

  /** Whether the embedded broker admits the users of a SECURITY DIRECTORY only. */
  public boolean isSecured() {
    return security != null && security.isOn();
  }

  /** Whether the broker runs in another process. */
  public boolean isExternal() {
    return transport instanceof MqttTransport;
  }

  /**
   * The transport to another system on the same broker, which requires user and encryption like any
   * client.
   *
   * @param otherSystemId the system, or {@link Topic#ANY_SYSTEM} to receive all
   * @throws CommunicationException if there is no broker
   */
  public Transport transportOf(String otherSystemId) {
    if (remote == null) {
      throw new CommunicationException(
          "system \"" + otherSystemId + "\" is unreachable: BROKER is none");
    }
    return remote.get().ofSystem(otherSystemId);
  }

  /** Address of the embedded broker. */
  public Optional<InetSocketAddress> address() {
    return Optional.ofNullable(broker).map(BrokerSupervisor::address);
  }

  /**
   * Whether messages under a service's name come from this process or one that it started,
   * according to the embedded broker; true with another broker, which cannot tell.
   */
  public boolean isOwn(String serviceName) {
    return broker == null || broker.isOfVehicle(serviceName);
  }

  /** Number of copies dropped because remote subscribers or the broker were too slow. */
  public long dropped() {
    return broker == null ? 0 : broker.dropped();
  }

  /**
   * Replaces the embedded broker at the same address, as happens automatically when it fails.
   * Services of this process are unaffected; remote ones reconnect. No effect with an external
   * broker.
   *
   * @throws CommunicationException if another program has taken the port
   */
  public void restartBroker() {
    if (broker != null) {
      broker.restart();
    }
  }

  /** Stops the embedded broker once everything queued is sent. Services should end first. */
  @Override
  public void close() {
    if (rosbridge != null) {
      rosbridge.close();
    }
    if (announcement != null) {
      announcement.close();
    }
    if (broker != null) {
      broker.close();
    }
    if (security != null) {
      security.close();
    }
  }

  /** Receives no messages; connects only to probe the broker. */
  private static final class Probe implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      throw new IllegalStateException("subscribed to nothing, but received " + message);
    }

    @Override
    public void trouble(String what) {
      throw new CommunicationException(what);
    }
  }
}
