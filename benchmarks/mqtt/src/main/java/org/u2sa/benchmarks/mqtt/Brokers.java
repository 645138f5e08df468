package org.u2sa.benchmarks.mqtt;

import io.moquette.BrokerConstants;
import io.moquette.broker.Server;
import io.moquette.broker.config.IConfig;
import io.moquette.broker.config.MemoryConfig;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.Map;
import java.util.Properties;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.registry.StandardTypes;

/** The brokers of this process: ours, as a vehicle has it, and a bare Moquette; and Mosquitto. */
final class Brokers implements AutoCloseable {
  private static final int NONE = 0;

  private final CommunicationManager manager;
  private final Server moquette = new Server();
  private final int oursPort = freePort();
  private final int moquettePort = freePort();
  private final int mosquittoPort;
  private final ProcessHandle mosquitto; // null: not known

  /**
   * @param limit packets a second that our broker reads from one client; 0: as it is by default
   * @param mosquittoPort 0: there is none
   */
  Brokers(int limit, int mosquittoPort, long mosquittoPid) throws IOException {
    this.mosquittoPort = mosquittoPort;
    mosquitto = ProcessHandle.of(mosquittoPid).orElse(null);
    Map<String, Object> port = Map.of("COMMUNICATION MANAGER PORT", oursPort);
    Map<String, Object> limited =
        Map.of("COMMUNICATION MANAGER PORT", oursPort, "CLIENT MESSAGES PER SECOND", limit);
    manager =
        CommunicationManager.start(
            Contents.SYSTEM,
            XmlConfiguration.inMemory(Contents.SYSTEM, limit == 0 ? port : limited),
            StandardTypes.registry(),
            System.err::println);
    Properties properties = new Properties();
    properties.setProperty(IConfig.HOST_PROPERTY_NAME, "127.0.0.1");
    properties.setProperty(IConfig.PORT_PROPERTY_NAME, String.valueOf(moquettePort));
    properties.setProperty(IConfig.PERSISTENCE_ENABLED_PROPERTY_NAME, "false");
    properties.setProperty(IConfig.ENABLE_TELEMETRY_NAME, "false");
    properties.setProperty(IConfig.BUFFER_FLUSH_MS_PROPERTY_NAME, "0");
    properties.setProperty( // HiveMQ's client leaves naming itself to the broker
        BrokerConstants.ALLOW_ZERO_BYTE_CLIENT_ID_PROPERTY_NAME, "true");
    moquette.startServer(new MemoryConfig(properties));
  }

  static int freePort() throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      return socket.getLocalPort();
    }
  }

  /** The port for a way. Empty broker: a free one. */
  int port(String broker) throws IOException {
    return switch (broker) {
      case "ours" -> oursPort;
      case "moquette" -> moquettePort;
      case "mosquitto" -> mosquittoPort;
      default -> freePort();
    };
  }

  boolean has(String broker) {
    return !broker.equals("mosquitto") || mosquittoPort != NONE;
  }

  /** Processor time of Mosquitto so far, as exact as the system says: to 10 ms. */
  long mosquittoCpuNanos() {
    return mosquitto == null
        ? 0
        : mosquitto.info().totalCpuDuration().map(Duration::toNanos).orElse(0L);
  }

  @Override
  public void close() {
    manager.close();
    moquette.stopServer();
  }
}
