package org.u2sa.core.communication;

import io.moquette.broker.subscriptions.Topic;
import io.netty.channel.ChannelDuplexHandler;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelPromise;
import io.netty.handler.codec.mqtt.MqttFixedHeader;
import io.netty.handler.codec.mqtt.MqttMessageType;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.handler.codec.mqtt.MqttQoS;
import io.netty.handler.codec.mqtt.MqttSubAckMessage;
import io.netty.handler.codec.mqtt.MqttSubscribeMessage;
import io.netty.handler.codec.mqtt.MqttTopicSubscription;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Sets the retain flag on what a new subscription brings, as MQTT demands (3.1.1, 3.3.1.3):
 * Moquette leaves it out at QoS 1 and 2. Retained messages follow the answer to the subscription,
 * before any new one on their topics. Belongs to its connection's thread.
 */
final class RetainFlag extends ChannelDuplexHandler {
  /** Of a client that asks without waiting for answers, the rest come without the flag. */
  private static final int UNANSWERED_AT_MOST = 64;

  private final Set<String> retainedTopics;
  private final Map<Integer, List<MqttTopicSubscription>> unanswered = new HashMap<>(); // by packet
  private final Map<String, Integer> expected = new HashMap<>(); // messages by topic

  /**
   * @param retainedTopics of which the broker holds a message; may change at any time
   */
  RetainFlag(Set<String> retainedTopics) {
    this.retainedTopics = retainedTopics;
  }

  @Override
  public void channelRead(ChannelHandlerContext ctx, Object message) {
    if (message instanceof MqttSubscribeMessage && unanswered.size() < UNANSWERED_AT_MOST) {
      MqttSubscribeMessage subscribe = (MqttSubscribeMessage) message;
      unanswered.put(
          subscribe.variableHeader().messageId(), subscribe.payload().topicSubscriptions());
    }
    ctx.fireChannelRead(message);
  }

  @Override
  public void write(ChannelHandlerContext ctx, Object message, ChannelPromise promise) {
    if (message instanceof MqttSubAckMessage) {
      answered((MqttSubAckMessage) message);
    }
    ctx.write(
        message instanceof MqttPublishMessage ? flagged((MqttPublishMessage) message) : message,
        promise);
  }

  private void answered(MqttSubAckMessage answer) {
    List<MqttTopicSubscription> wanted = unanswered.remove(answer.variableHeader().messageId());
    List<Integer> granted = answer.payload().grantedQoSLevels();
    for (int i = 0; wanted != null && i < Math.min(wanted.size(), granted.size()); i++) {
      if (granted.get(i) != MqttQoS.FAILURE.value()) {
        expect(new Topic(wanted.get(i).topicFilter()));
      }
    }
  }

  private void expect(Topic filter) {
    for (String topic : retainedTopics) {
      if (new Topic(topic).match(filter)) {
        expected.merge(topic, 1, Integer::sum);
      }
    }
  }

  private MqttPublishMessage flagged(MqttPublishMessage publish) {
    String topic = publish.variableHeader().topicName();
    if (expected.isEmpty() || !expected.containsKey(topic)) {
      return publish;
    }
    expected.computeIfPresent(topic, (name, left) -> left > 1 ? left - 1 : null);
    MqttFixedHeader header = publish.fixedHeader();
    return new MqttPublishMessage(
        new MqttFixedHeader(
            MqttMessageType.PUBLISH,
            header.isDup(),
            header.qosLevel(),
            true,
            header.remainingLength()),
        publish.variableHeader(),
        publish.content());
  }
}
