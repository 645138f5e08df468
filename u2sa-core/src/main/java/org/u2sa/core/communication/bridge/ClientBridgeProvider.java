package org.u2sa.core.communication.bridge;

/** Makes bridges of one protocol; found through {@link java.util.ServiceLoader}. */
public interface ClientBridgeProvider {
  /** Name of the protocol, such as "rosbridge". */
  String protocol();

  /**
   * Starts listening.
   *
   * @throws org.u2sa.interfaces.RunFailedException if the port is taken
   */
  ClientBridge start(ClientBridge.Setting setting);
}
