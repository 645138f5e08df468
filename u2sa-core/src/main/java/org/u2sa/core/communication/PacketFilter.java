package org.u2sa.core.communication;

import io.netty.channel.ChannelHandlerContext;
import io.netty.handler.codec.mqtt.MqttMessage;
import io.netty.handler.codec.mqtt.MqttMessageBuilders;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.handler.codec.mqtt.MqttQoS;
import io.netty.handler.codec.mqtt.MqttSubscribeMessage;
import io.netty.handler.codec.mqtt.MqttUnsubscribeMessage;
import java.util.Optional;

/** Looks at each packet of a client that was let in. Belongs to its connection's thread. */
final class PacketFilter {
  private final ConnectionFilter filter;
  private final PacketRules rules;
  private final String who;
  private final ClientSession session;

  /**
   * @param who for the log
   */
  PacketFilter(ConnectionFilter filter, PacketRules rules, String who, ClientSession session) {
    this.filter = filter;
    this.rules = rules;
    this.who = who;
    this.session = session;
  }

  /**
   * Looks at a packet and, if it may pass, routes it or hands it on to Moquette.
   *
   * @return whether it was handed on; otherwise it is the caller's still
   */
  boolean examine(ChannelHandlerContext ctx, MqttMessage packet) {
    switch (packet.fixedHeader().messageType()) {
      case PUBLISH:
        return examine(ctx, (MqttPublishMessage) packet);
      case SUBSCRIBE:
        MqttSubscribeMessage wanted = (MqttSubscribeMessage) packet;
        Optional<String> refused = rules.refusalOf(wanted);
        if (refused.isPresent()) {
          filter.refusals().add("subscription refused, " + refused.get(), who);
          ctx.writeAndFlush(PacketRules.refusedAnswer(wanted));
          return false;
        }
        break;
      case UNSUBSCRIBE:
        MqttUnsubscribeMessage unwanted = (MqttUnsubscribeMessage) packet;
        Optional<MqttUnsubscribeMessage> known = rules.unsubscribed(unwanted);
        if (known.isEmpty()) {
          int id = unwanted.variableHeader().messageId();
          ctx.writeAndFlush(MqttMessageBuilders.unsubAck().packetId(id).build());
          return false;
        }
        ctx.fireChannelRead(known.get());
        return true;
      case PUBACK:
      case PINGREQ:
      case DISCONNECT:
        break;
      default: // QoS 2, a second CONNECT, or what only a broker says
        session.putOut(ctx, "unexpected packet", packet.fixedHeader().messageType().toString());
        return false;
    }
    ctx.fireChannelRead(packet);
    return true;
  }

  private boolean examine(ChannelHandlerContext ctx, MqttPublishMessage publish) {
    MqttQoS qos = publish.fixedHeader().qosLevel();
    if (qos == MqttQoS.EXACTLY_ONCE) {
      session.putOut(ctx, "unexpected packet", "QoS 2, which no channel of U2SA uses");
      return false;
    }
    if (filter.isEnding()) { // not acknowledged: who wants to know learns that it is lost
      filter.refusals().add("message not taken, the broker ends", who);
      return false;
    }
    Optional<String> refused = rules.refusalOf(publish);
    if (refused.isPresent()) {
      String topic = Refusals.shown(publish.variableHeader().topicName());
      filter.refusals().add("message refused, " + refused.get(), who + ", topic " + topic);
      if (qos == MqttQoS.AT_LEAST_ONCE) { // MQTT 3.1.1 knows no other answer
        int packet = publish.variableHeader().packetId();
        ctx.writeAndFlush(MqttMessageBuilders.pubAck().packetId(packet).build());
      }
      return false;
    }
    if (qos == MqttQoS.AT_LEAST_ONCE) {
      filter.backlog().keep(publish.content().readableBytes());
    }
    if (filter.router().route(publish, session)) {
      if (qos == MqttQoS.AT_LEAST_ONCE) {
        session.acknowledge(publish.variableHeader().packetId());
      }
      return false;
    }
    filter.backlog().in(publish.content().readableBytes());
    ctx.fireChannelRead(publish);
    return true;
  }
}
