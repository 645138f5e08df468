package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.u2sa.core.communication.BrokerTraffic.command;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import org.awaitility.core.ConditionFactory;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.messages.command.PercentageCommand;

/** An embedded broker of system cessna on a free port, for clients that mean harm. */
final class AttackedBroker implements AutoCloseable {
  static final String STATE = "u2sa/cessna/state/StateInformation";

  final List<String> log;
  final int port;
  final CommunicationManager manager;
  final Connection bus;
  private final TestManager broker;
  private final RecordingReceiver local = new RecordingReceiver();
  private final List<RawClient> pending = new CopyOnWriteArrayList<>();

  AttackedBroker(Map<String, Object> variables) {
    broker = new TestManager(variables);
    log = broker.log;
    port = broker.port;
    manager = broker.manager();
    bus = broker.local("Local", local);
    bus.subscribe(Channels.ACTUATION);
  }

  /** A connection that has said nothing yet; ended with the broker. */
  RawClient stranger() throws IOException {
    RawClient client = new RawClient(port);
    pending.add(client);
    return client;
  }

  /** A client as services have it, which tries again if it is taken for one of the attackers. */
  Connection remote(Receiver receiver) {
    return TestManager.transport(port).connect("Remote", receiver);
  }

  static ConditionFactory soon() {
    return await().atMost(Duration.ofSeconds(40));
  }

  /** Waits until commands arrive both ways at a client that comes now. */
  void servesOn() {
    RecordingReceiver inbox = new RecordingReceiver();
    try (Connection connection = remote(inbox)) {
      connection.subscribe(Channels.ACTUATION);
      PercentageCommand there = command(1.0);
      PercentageCommand back = command(2.0);
      soon()
          .until(
              () -> {
                bus.publish(Channels.ACTUATION, there);
                connection.publish(Channels.ACTUATION, back);
                return inbox.messages.contains(there) && local.messages.contains(back);
              });
    }
  }

  /** Ends all connections of {@link #stranger}. */
  void leaveStrangers() throws IOException {
    for (RawClient client : pending) {
      client.close();
    }
    pending.clear();
  }

  boolean hasLogged(String part) {
    return log.stream().anyMatch(line -> line.contains(part));
  }

  void awaitLog(String part) {
    soon().until(() -> hasLogged(part));
  }

  /** Fails if the broker had to be started again: whoever can bring that about can do it again. */
  @Override
  public void close() throws IOException {
    leaveStrangers();
    broker.close();
    assertThat(log).noneMatch(line -> line.contains("the broker failed"));
  }
}
