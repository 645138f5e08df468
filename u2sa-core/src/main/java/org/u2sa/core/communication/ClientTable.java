package org.u2sa.core.communication;

import io.netty.handler.codec.mqtt.MqttConnectReturnCode;
import java.util.Collection;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.core.communication.limit.BrokerLimits;

/** The admitted clients by ID and by connection. Thread-safe. */
final class ClientTable {
  private final BrokerLimits limits;
  private final boolean hasUsers;
  private final Map<String, Client> clients = new ConcurrentHashMap<>();
  private final Map<String, Client> connections = new ConcurrentHashMap<>(); // Moquette's view
  private final AtomicLong connectionsSoFar = new AtomicLong();

  /**
   * @param hasUsers whether clients belong to users, each with a limited number of connections, of
   *     which some are reserved for operators
   */
  ClientTable(BrokerLimits limits, boolean hasUsers) {
    this.limits = limits;
    this.hasUsers = hasUsers;
  }

  enum Entry {
    FREE("", MqttConnectReturnCode.CONNECTION_ACCEPTED),
    FULL("too many connections", MqttConnectReturnCode.CONNECTION_REFUSED_SERVER_UNAVAILABLE),
    FULL_FOR_USER(
        "too many connections of one user",
        MqttConnectReturnCode.CONNECTION_REFUSED_SERVER_UNAVAILABLE),
    ANOTHERS_ID(
        "the client ID belongs to another user",
        MqttConnectReturnCode.CONNECTION_REFUSED_IDENTIFIER_REJECTED);

    private final String reason;
    private final MqttConnectReturnCode answer;

    Entry(String reason, MqttConnectReturnCode answer) {
      this.reason = reason;
      this.answer = answer;
    }

    String reason() {
      return reason;
    }

    /** Return code for the client; a temporary one where retrying may help. */
    MqttConnectReturnCode answer() {
      return answer;
    }
  }

  String newConnection() {
    return "connection-" + connectionsSoFar.incrementAndGet();
  }

  /** Registers a client under its ID, replacing an older connection of the same client. */
  synchronized Entry enter(String clientId, Client client) {
    Client before = clients.get(clientId);
    if (before != null && !before.name().equals(client.name())) {
      return Entry.ANOTHERS_ID;
    }
    int others = clients.size() - (before == null ? 0 : 1);
    boolean keepFree = hasUsers && !client.isOperator();
    if (others >= (keepFree ? limits.clientsBesidesOperators() : limits.maxClients())) {
      return Entry.FULL;
    }
    if (hasUsers && ofUser(client.name()) - (before == null ? 0 : 1) >= limits.clientsPerUser()) {
      return Entry.FULL_FOR_USER;
    }
    clients.put(clientId, client);
    connections.put(client.connection(), client);
    if (before != null) { // reconnected before its old connection was detected as dead
      before.replaced();
    }
    return Entry.FREE;
  }

  private long ofUser(String name) {
    return clients.values().stream().filter(other -> other.name().equals(name)).count();
  }

  /** Called when Moquette is ready for a connection's packets. */
  void connected(String connection) {
    Client client = connections.get(connection);
    if (client != null) {
      client.connected();
    }
  }

  /** The client of a connection, or null. */
  Client of(String connection) {
    return connections.get(connection);
  }

  void leave(String clientId, Client client) {
    clients.remove(clientId, client);
    connections.remove(client.connection());
  }

  /** All clients, as they come and go. */
  Collection<Client> all() {
    return clients.values();
  }
}
