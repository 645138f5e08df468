package org.u2sa.core.launch;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;

/**
 * A transport that knows all connections made through it: a service whose constructor fails leaves
 * nobody who could close its own.
 */
final class RememberedConnections implements Transport, AutoCloseable {
  private final Transport transport;
  private final List<Connection> connections = new CopyOnWriteArrayList<>();

  RememberedConnections(Transport transport) {
    this.transport = transport;
  }

  @Override
  public Connection connect(String serviceName, Receiver receiver) {
    Connection connection = transport.connect(serviceName, receiver);
    connections.add(connection);
    return connection;
  }

  @Override
  public String systemId() {
    return transport.systemId();
  }

  /** Closes those that are still open. */
  @Override
  public void close() {
    connections.forEach(Connection::close);
    connections.clear();
  }
}
