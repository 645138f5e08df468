package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;

import io.netty.buffer.Unpooled;
import io.netty.handler.codec.mqtt.MqttMessageBuilders;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.handler.codec.mqtt.MqttQoS;
import java.security.SecureRandom;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.User;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.safety.EmergencyStop;

/** What a client may publish and have retained. */
class PublishRulesTest {
  private static final String OWN = "u2sa/cessna/tide/Tide";
  private static final String QUESTION = "u2sa/cessna/discovery/DiscoveryRequest";
  private static final String STOP = "u2sa/cessna/emergency-stop/EmergencyStop";
  private static final String ANNOUNCED = "u2sa/cessna/actuators/ActuatorAnnouncement";
  private static final byte[] MAP = {(byte) 0xa0};

  private final PacketPipeline pipeline = new PacketPipeline().introduced();

  @AfterEach
  void close() {
    pipeline.close();
  }

  private PacketRules rulesOf(AccessRole role) {
    PasswordHash hash = PasswordHash.of("x".toCharArray(), new SecureRandom(), 1_000);
    User user = new User("ann", EnumSet.of(role), List.of("cessna"), hash);
    return new PacketRules(pipeline.broker, user, "client");
  }

  private PacketRules everybodys() {
    return new PacketRules(pipeline.broker, null, "client");
  }

  private static MqttPublishMessage message(
      String topic, byte[] payload, MqttQoS quality, boolean isRetained) {
    return MqttMessageBuilders.publish()
        .topicName(topic)
        .qos(quality)
        .messageId(1)
        .retained(isRetained)
        .payload(Unpooled.wrappedBuffer(payload))
        .build();
  }

  private static Optional<String> refusal(PacketRules rules, String topic, byte[] payload) {
    return rules.refusalOf(message(topic, payload, MqttQoS.AT_LEAST_ONCE, false));
  }

  private static Optional<String> refusalRetained(PacketRules rules, String topic, byte[] payload) {
    return rules.refusalOf(message(topic, payload, MqttQoS.AT_LEAST_ONCE, true));
  }

  private static byte[] stop(boolean active) {
    return frozen(new EmergencyStop().active(active)).serialize();
  }

  @Test
  void refusalOf_longestPayload_mayPassAndOneByteMoreNot() {
    PacketRules rules = everybodys();
    assertThat(refusal(rules, OWN, new byte[BrokerLimits.LONGEST_PAYLOAD])).isEmpty();
    assertThat(refusal(rules, OWN, new byte[BrokerLimits.LONGEST_PAYLOAD + 1]))
        .contains("its payload is too long");
    assertThat(refusal(rules, QUESTION, new byte[4_096])).isEmpty();
    assertThat(refusal(rules, QUESTION, new byte[4_097]))
        .contains("its payload of 4097 bytes is longer than the 4096 of DiscoveryRequest");
  }

  @Test
  void refusalOf_forbiddenTopic_saysWhy() {
    assertThat(refusal(everybodys(), "somewhere/else", MAP))
        .contains("its topic is not a U2SA topic");
    assertThat(refusal(rulesOf(AccessRole.OBSERVER), OWN, MAP)).isPresent();
    assertThat(refusal(rulesOf(AccessRole.SERVICE), "u2sa/boat/tide/Tide", MAP))
        .contains("it belongs to another system");
  }

  @Test
  void refusalOfSystem_ofOnesOwnOrNone_isEmpty() {
    PacketRules rules = rulesOf(AccessRole.SERVICE);
    assertThat(rules.refusalOfSystem("u2sa/boat/tide/Tide"))
        .contains("it belongs to another system");
    assertThat(rules.refusalOfSystem(OWN)).isEmpty();
    assertThat(rules.refusalOfSystem("somewhere/else")).isEmpty();
    assertThat(everybodys().refusalOfSystem("u2sa/boat/tide/Tide")).isEmpty();
  }

  @Test
  void refusalOf_orders_areLimitedAndLongOnesCountAsSeveral() {
    String order = "u2sa/cessna/configuration/ConfigurationUndo";
    PacketRules rules = everybodys();
    int taken = 0;
    while (refusal(rules, order, MAP).isEmpty()) {
      taken++;
    }
    assertThat(taken).isEqualTo(13); // a quarter of 50, the last one overdrawn
    assertThat(refusal(rules, order, MAP)).contains("too many orders of one client");

    PacketRules another = everybodys();
    taken = 0;
    while (refusal(another, order, new byte[4_096]).isEmpty()) {
      taken++;
    }
    assertThat(taken).isEqualTo(7);
  }

  @Test
  void refusalOf_emergencyStop_everybodyWhoMaySetsItAndAnOperatorClears() {
    assertThat(refusal(rulesOf(AccessRole.SAFETY), STOP, stop(true))).isEmpty();
    assertThat(refusal(rulesOf(AccessRole.SAFETY), STOP, stop(false)))
        .contains("only an operator may clear an emergency stop");
    assertThat(refusal(rulesOf(AccessRole.OPERATOR), STOP, stop(false))).isEmpty();
    assertThat(refusal(everybodys(), STOP, stop(false))).isEmpty();
    assertThat(refusal(everybodys(), STOP, new byte[0]))
        .contains("it is not a readable emergency stop");
    assertThat(refusalRetained(everybodys(), STOP, new byte[0]))
        .contains("it is not a readable emergency stop");
    assertThat(pipeline.broker.retained.topics()).as("none of these was retained").isEmpty();
  }

  @Test
  void refusalOf_retained_keepsItWhereItMay() {
    PacketRules rules = everybodys();
    assertThat(refusalRetained(rules, OWN, MAP)).isEmpty();
    assertThat(refusalRetained(rules, STOP, stop(true))).isEmpty();
    assertThat(pipeline.broker.retained.topics()).containsExactlyInAnyOrder(OWN, STOP);

    assertThat(refusalRetained(rules, OWN, new byte[0])).as("deletes").isEmpty();
    assertThat(pipeline.broker.retained.topics()).containsExactly(STOP);
  }

  @Test
  void refusalOf_retainedWithoutAcknowledgement_isRefused() {
    assertThat(everybodys().refusalOf(message(OWN, MAP, MqttQoS.AT_MOST_ONCE, true)))
        .contains("retained messages require QoS 1");
    assertThat(pipeline.broker.retained.topics()).isEmpty();
  }

  @Test
  void refusalOf_retainedUnderAnotherSourcesTopic_isRefused() {
    byte[] rudder =
        frozen(new ActuatorAnnouncement().actuatorName("RUDDER").minimum(-100.0).maximum(100.0))
            .serialize();
    assertThat(refusalRetained(everybodys(), ANNOUNCED + "/=RUDDER", rudder)).isEmpty();
    assertThat(refusalRetained(everybodys(), ANNOUNCED + "/=AILERON", rudder))
        .contains("it is retained on the topic of another source");
  }

  @Test
  void refusalOf_retainedBytesOfOneClient_areLimited() {
    byte[] half = new byte[BrokerLimits.LONGEST_PAYLOAD / 2];
    half[0] = (byte) 0xa1; // {"x": the rest as bytes}
    half[1] = 0x61;
    half[2] = 'x';
    half[3] = 0x5a;
    int rest = half.length - 8;
    for (int i = 0; i < Integer.BYTES; i++) {
      half[4 + i] = (byte) (rest >>> 8 * (Integer.BYTES - 1 - i));
    }
    for (int i = 0; i < 16; i++) {
      assertThat(refusalRetained(everybodys(), OWN + i, half)).isEmpty();
    }
    assertThat(refusalRetained(everybodys(), OWN, half))
        .contains("too many retained bytes of one client");
  }

  @Test
  void channelRead_refusedMessage_isAcknowledgedButReachesNobody() {
    pipeline.send(MqttPacketBytes.subscribe("#"));
    pipeline.send(MqttPacketBytes.publish("somewhere/else", 1, 1));
    pipeline.send(MqttPacketBytes.publish("somewhere/else", 1));

    assertThat(pipeline.sent()).containsExactly("90", "40");
    assertThat(pipeline.log).anyMatch(line -> line.contains("topic \"somewhere/else\""));
  }

  @Test
  void channelRead_messageOfQualityZero_isNotAcknowledged() {
    pipeline.send(MqttPacketBytes.subscribe("#"));
    pipeline.send(MqttPacketBytes.publish(OWN, 1));

    assertThat(pipeline.sent()).containsExactly("90", "30 \0");
    assertThat(pipeline.broker.kept()).isZero();
    pipeline.send(MqttPacketBytes.publish(OWN, 3, 1));
    assertThat(pipeline.broker.kept()).isEqualTo(3);
  }

  @Test
  void channelRead_secondConnect_putsTheClientOut() {
    pipeline.send(MqttPacketBytes.connect("again", 0));

    assertThat(pipeline.channel.isOpen()).isFalse();
    assertThat(pipeline.log).anyMatch(line -> line.startsWith("unexpected packet"));
  }
}
