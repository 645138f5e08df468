package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.access.LocalAccount;
import org.u2sa.core.communication.access.Users;
import org.u2sa.interfaces.mqtt.LocalToken;
import org.u2sa.testkit.FreePort;

/** What a client without the account's token may cost one that has it. */
class AnonymousListenerTest {
  private static final String TOPIC = "u2sa/cessna/operator/OperatorHeartbeat";

  private final LocalAccount account = LocalAccount.at("127.0.0.1", FreePort.find(), warning -> {});
  private final PacketPipeline listener =
      new PacketPipeline(Map.of(), new Users(account)).introduced("listener");
  private final PacketPipeline pilot = new PacketPipeline(listener);

  @AfterEach
  void close() {
    pilot.close();
    listener.close();
    account.close();
  }

  @Test
  void publish_anonymousSubscriberReadsNothing_doesNotSlowThePublisherDown() {
    pilot.send(MqttPacketBytes.connectAs(LocalToken.USER, account.own().password(), "pilot"));
    pilot.broker.clients.connected(pilot.session.connection());
    pilot.pass(2);
    listener.send(MqttPacketBytes.subscribe("u2sa/#"));
    listener.block();
    for (int i = 0; i < 100; i++) {
      pilot.send(MqttPacketBytes.publish(TOPIC, 1_000, 1 + i));
      pilot.pass(10);
      listener.pass(10);
    }
    pilot.sent();

    ByteArrayOutputStream burst = new ByteArrayOutputStream();
    for (int i = 0; i < 100; i++) {
      burst.writeBytes(MqttPacketBytes.publish(TOPIC, 10, 1 + i));
    }
    pilot.send(burst.toByteArray());
    assertThat(pilot.sent()).filteredOn("40"::equals).hasSize(100);
  }
}
