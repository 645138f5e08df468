package org.u2sa.core.communication;

import io.netty.channel.ChannelHandlerContext;
import io.netty.handler.codec.mqtt.MqttMessage;
import io.netty.handler.codec.mqtt.MqttMessageBuilders;
import io.netty.handler.codec.mqtt.MqttPubAckMessage;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.handler.codec.mqtt.MqttQoS;
import io.netty.handler.codec.mqtt.MqttSubscribeMessage;
import io.netty.handler.codec.mqtt.MqttUnsubscribeMessage;
import java.util.Optional;
import org.u2sa.core.communication.access.Refusals;
import org.u2sa.core.communication.access.SourceNames;

/**
 * Filters the packets of an admitted client. Confined to its connection's thread.
 *
 * @param who client description for the log
 */
record PacketFilter(
    BrokerState broker,
    PacketRules rules,
    ClientSubscriptions subscriptions,
    String who,
    Client session) {
  /**
   * Checks a packet and, if allowed, executes it or passes it to Moquette.
   *
   * @return whether it was passed on; otherwise the caller still owns it
   */
  boolean examine(ChannelHandlerContext ctx, MqttMessage packet) {
    switch (packet.fixedHeader().messageType()) {
      case PUBLISH -> examine((MqttPublishMessage) packet);
      case SUBSCRIBE -> subscribe((MqttSubscribeMessage) packet);
      case UNSUBSCRIBE -> {
        MqttUnsubscribeMessage unwanted = (MqttUnsubscribeMessage) packet;
        subscriptions.unsubscribe(unwanted);
        int id = unwanted.variableHeader().messageId();
        session.answer(MqttMessageBuilders.unsubAck().packetId(id).build());
      }
      case PUBACK ->
          session.acknowledged(((MqttPubAckMessage) packet).variableHeader().messageId());
      case PINGREQ -> session.answer(MqttMessage.PINGRESP);
      case DISCONNECT -> {
        ctx.fireChannelRead(packet);
        return true;
      }
      default -> // QoS 2, a second CONNECT, or a packet only brokers send
          session.putOut("unexpected packet", packet.fixedHeader().messageType().toString());
    }
    return false;
  }

  /** Answers first, as clients expect; newer messages follow. */
  private void subscribe(MqttSubscribeMessage wanted) {
    Optional<String> refused = subscriptions.refusalOf(wanted);
    session.answer(ClientSubscriptions.answerTo(wanted, refused.isPresent()));
    if (refused.isPresent()) {
      broker.refusals.add("subscription refused, " + refused.get(), who);
    } else {
      subscriptions.sendRetained(wanted, session);
    }
  }

  private void examine(MqttPublishMessage publish) {
    MqttQoS qos = publish.fixedHeader().qosLevel();
    if (qos == MqttQoS.EXACTLY_ONCE) {
      session.putOut("unexpected packet", "QoS 2, which no channel of U2SA uses");
      return;
    }
    if (broker.isEnding()) { // unacknowledged, so the client knows that it is lost
      broker.refusals.add("message not accepted, the broker is shutting down", who);
      return;
    }
    Optional<String> refused = rules.refusalOf(publish);
    boolean eachMatters = qos == MqttQoS.AT_LEAST_ONCE;
    if (refused.isPresent()) {
      String topic = Refusals.shown(publish.variableHeader().topicName());
      String source =
          refused.get().equals(SourceNames.TAKEN)
              ? ", name " + Refusals.shown(rules.sourceOf(publish))
              : "";
      broker.refusals.add("message refused, " + refused.get(), who + ", topic " + topic + source);
    } else {
      if (eachMatters) {
        broker.keep(publish.content().readableBytes());
      }
      broker.router.route(
          publish.variableHeader().topicName(), publish.content(), eachMatters, session);
    }
    if (eachMatters) { // even for refused messages: MQTT 3.1.1 has no other answer
      session.acknowledge(publish.variableHeader().packetId());
    }
  }
}
