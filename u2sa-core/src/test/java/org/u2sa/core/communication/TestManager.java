package org.u2sa.core.communication;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.testkit.FreePort;

/** A Communication Manager of system cessna on a free port, and clients that end with it. */
final class TestManager implements AutoCloseable {
  /** How long a client tries [s]: one attempt may take longer than it may where much else runs. */
  static final double PATIENCE_S = 30.0;

  private static final MessageTypes TYPES = StandardTypes.registry();

  final List<String> log = new CopyOnWriteArrayList<>();
  final int port = FreePort.find();
  private final Deque<Connection> clients = new ArrayDeque<>(); // the latest first
  private CommunicationManager manager;

  TestManager() {
    this(Map.of());
  }

  TestManager(Map<String, Object> variables) {
    manager = another(variables);
  }

  CommunicationManager manager() {
    return manager;
  }

  /** Starts one more, at the same port unless the variables say another; the test closes it. */
  CommunicationManager another(Map<String, Object> variables) {
    Map<String, Object> all = new HashMap<>(variables);
    all.putIfAbsent("COMMUNICATION MANAGER PORT", port);
    all.putIfAbsent("LOCAL COMMANDS", "everybody"); // raw clients know no token
    return CommunicationManager.start(
        "cessna", XmlConfiguration.inMemory("test", all), TYPES, log::add);
  }

  /** Ends it, if that is still to be done, and starts its successor. */
  void replace(Map<String, Object> variables) {
    manager.close();
    manager = another(variables);
  }

  /** A client within the manager's process. */
  Connection local(String name, Receiver receiver) {
    return keep(manager.transport().connect(name, receiver));
  }

  /** A client by TCP. */
  Connection remote(String name, Receiver receiver) {
    return keep(transport(port).connect(name, receiver));
  }

  /** A client's way to the manager, or to what stands before it at another port. */
  static MqttTransport transport(int port) {
    return new MqttTransport("127.0.0.1", port, "cessna", new MessageCodec(TYPES))
        .waiting(PATIENCE_S);
  }

  /** Has the manager end a client before itself. */
  Connection keep(Connection client) {
    clients.push(client);
    return client;
  }

  @Override
  public void close() {
    clients.forEach(Connection::close);
    manager.close();
  }
}
