package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.access.ConnectRequest;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.messages.safety.EmergencyStop;

/** Which wills a client may have, and when they are published. */
class WillTest {
  private static final String STOP = "u2sa/cessna/emergency-stop/EmergencyStop";
  private static final String HEALTH = "u2sa/cessna/health/HealthReport";

  private final PacketPipeline listener = new PacketPipeline().introduced();
  private final PacketRules rules = new PacketRules(listener.broker, null, "client");

  @AfterEach
  void close() {
    listener.close();
  }

  private static byte[] stop(boolean active) {
    return BrokerTraffic.frozen(new EmergencyStop().active(active)).serialize();
  }

  private Optional<String> refusal(
      String topic, byte[] payload, boolean eachMatters, boolean isRetained) {
    return rules.refusalOfWill(new ConnectRequest.Will(topic, payload, eachMatters, isRetained));
  }

  @Test
  void refusalOfWill_whatMayBeOne_isEmpty() {
    assertThat(refusal(STOP, stop(true), true, true)).isEmpty();
    assertThat(refusal(STOP, stop(true), false, false)).isEmpty();
    assertThat(refusal(HEALTH, new byte[BrokerLimits.LONGEST_WILL], false, false)).isEmpty();
    assertThat(refusal("u2sa/cessna/own/Tide", new byte[] {(byte) 0xa0}, true, true)).isEmpty();
    assertThat(listener.broker.retained.topics()).as("not yet").isEmpty();
  }

  @Test
  void refusalOfWill_topicThatIsNone_isRefused() {
    assertThat(refusal("somewhere", new byte[0], false, false))
        .contains("its topic is not a U2SA topic");
  }

  @Test
  void refusalOfWill_commands_areRefused() {
    assertThat(refusal("u2sa/cessna/stop/StopCommand", new byte[0], false, false))
        .contains("StopCommand is not a will");
  }

  @Test
  void refusalOfWill_oneByteTooLong_isRefused() {
    assertThat(refusal(HEALTH, new byte[BrokerLimits.LONGEST_WILL + 1], false, false))
        .contains("it is too long");
  }

  @Test
  void refusalOfWill_thatClearsAStopOrIsNone_isRefused() {
    assertThat(refusal(STOP, stop(false), true, false))
        .contains("a will may not clear an emergency stop");
    assertThat(refusal(STOP, stop(false), true, true))
        .contains("a will may not clear an emergency stop");
    assertThat(refusal(STOP, new byte[0], true, true))
        .contains("it is not a readable emergency stop");
  }

  @Test
  void refusalOfWill_retainedAtQualityZero_isRefused() {
    assertThat(refusal(STOP, stop(true), false, true)).contains("retained messages require QoS 1");
  }

  @Test
  void refusalOfWill_retainedWhereNothingIs_isRefused() {
    assertThat(refusal(HEALTH, new byte[1], true, true)).contains("health retains nothing");
  }

  @Test
  void refusalOfWill_retainedAndUnreadable_isRefused() {
    assertThat(refusal("u2sa/cessna/own/Tide", new byte[] {1}, true, true))
        .contains("it is retained but unreadable");
  }

  private PacketPipeline client(boolean isRetained) {
    PacketPipeline client = new PacketPipeline(listener);
    int flags = 0x02 | 0x04 | 0x08 | (isRetained ? 0x20 : 0);
    client.send(MqttPacketBytes.connect("x", flags, STOP, stop(true)));
    client.broker.clients.connected(client.session.connection());
    client.pass(2);
    return client;
  }

  private void subscribe() {
    listener.send(MqttPacketBytes.subscribeToEach("u2sa/#"));
    listener.sent();
  }

  @Test
  void connectionBreaks_willIsPublishedOnce() {
    subscribe();
    PacketPipeline client = client(false);
    assertThat(listener.sent()).isEmpty();

    client.close();
    listener.pass(1);

    assertThat(listener.sent()).hasSize(1).allMatch(packet -> packet.startsWith("32 "));
    assertThat(listener.broker.retained.topics()).isEmpty();
  }

  @Test
  void connectionBreaks_retainedWillIsThereForWhoComesLater() {
    client(true).close();
    listener.send(MqttPacketBytes.subscribeToEach("u2sa/#"));

    assertThat(listener.sent()).hasSize(2).last().asString().startsWith("33 ");
  }

  @Test
  void goodbye_willIsForgotten() {
    subscribe();
    PacketPipeline client = client(true);
    client.send(new byte[] {(byte) 0xe0, 0});
    client.close();
    listener.pass(1);

    assertThat(listener.sent()).isEmpty();
    assertThat(listener.broker.retained.topics()).isEmpty();
  }
}
