package org.u2sa.core.launch;

import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Predicate;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.U2SAData;

/** Who commands the boat, and what was heard of it. */
final class BoatOperator implements AutoCloseable {
  final List<U2SAData> heard = new CopyOnWriteArrayList<>();
  private final Connection connection;

  BoatOperator(int port) {
    Receiver receiver =
        new Receiver() {
          @Override
          public void receive(Channel<?> channel, U2SAData message) {
            heard.add(message);
          }

          @Override
          public void trouble(String what) {
            throw new AssertionError(what);
          }
        };
    connection =
        new MqttTransport("127.0.0.1", port, "boat", new MessageCodec(StandardTypes.registry()))
            .connect("Operator", receiver);
    for (Channel<?> channel :
        List.of(
            Channels.STATE,
            Channels.HEALTH,
            Channels.DISCOVERY,
            Channels.FUNCTIONALITY,
            Channels.CONFIGURATION)) {
      connection.subscribe(channel);
    }
  }

  void send(Channel<?> channel, U2SAData message) {
    message.systemId("boat");
    message.freeze();
    connection.publish(channel, message);
  }

  /** How many messages could not be sent. */
  long refused() {
    return connection.refused();
  }

  <T extends U2SAData> T awaited(Class<T> type, Predicate<T> wanted) {
    return await()
        .atMost(Duration.ofSeconds(30))
        .until(
            () ->
                heard.stream().filter(type::isInstance).map(type::cast).filter(wanted).findFirst(),
            Optional::isPresent)
        .orElseThrow();
  }

  /** Has the compass change its declination. */
  ConfigurationTransactionResult changed(String request, String value) {
    ConfigurationAssignment wanted =
        new ConfigurationAssignment().variableName("DECLINATION").value(value);
    send(
        Channels.CONFIGURATION,
        new ConfigurationTransaction()
            .requestId(request)
            .serviceName("Compass")
            .assignments(List.of(wanted))
            .author("test"));
    return result(request);
  }

  ConfigurationTransactionResult result(String request) {
    return awaited(ConfigurationTransactionResult.class, each -> each.requestId().equals(request));
  }

  @Override
  public void close() {
    connection.close();
  }
}
