package org.u2sa.core.communication.bridge;

import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.mqtt.MqttTransport;

/** A server of another protocol beside the embedded broker. */
public interface ClientBridge extends AutoCloseable {
  /**
   * Address of a bridge and access to the broker for its clients.
   *
   * @param address address on which it listens
   * @param broker the broker, without any user's rights
   * @param security certificate of a secured broker; empty: none
   * @param operators whether a user may command; an empty name is anonymous. Does not wait
   * @param log receives lines for the operator
   */
  record Setting(
      InetSocketAddress address,
      MqttTransport broker,
      Optional<SecurityDirectory> security,
      Predicate<String> operators,
      Consumer<String> log) {}

  @Override
  void close();

  /**
   * Starts the bridge of a protocol.
   *
   * @throws BadInputException if no bridge for it is on the class path
   */
  static ClientBridge start(String protocol, Setting setting) {
    try {
      for (ClientBridgeProvider provider : ServiceLoader.load(ClientBridgeProvider.class)) {
        if (provider.protocol().equals(protocol)) {
          return provider.start(setting);
        }
      }
    } catch (ServiceConfigurationError e) {
      throw new BadInputException(protocol + " cannot be loaded: " + e, e);
    }
    throw new BadInputException("no server of " + protocol + " found; it is in u2sa-gcs");
  }
}
