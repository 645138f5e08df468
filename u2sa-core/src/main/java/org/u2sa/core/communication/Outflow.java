package org.u2sa.core.communication;

import io.netty.channel.ChannelDuplexHandler;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelPromise;
import io.netty.handler.codec.mqtt.MqttMessageBuilders;
import io.netty.handler.codec.mqtt.MqttMessageType;
import io.netty.handler.codec.mqtt.MqttPubAckMessage;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.handler.codec.mqtt.MqttQoS;
import io.netty.util.ReferenceCountUtil;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.u2sa.core.security.User;

/**
 * What goes out to one client: only of systems that it may listen to, and no more than it takes.
 * Belongs to its connection's thread.
 */
final class Outflow extends ChannelDuplexHandler {
  private static final String SYSTEMS = "u2sa/";

  private final ConnectionFilter filter;
  private final Map<Integer, Unacknowledged> unacknowledged = new LinkedHashMap<>(); // by packet
  private User user; // null: may listen to everything
  private String client = "";
  private long taken; // packets that the client's side of the network took
  private long takenBefore;
  private long idleSince; // [µs]
  private int onTheWay; // of those that are not acknowledged: handed over and not sent yet
  private long sentMicros = Long.MIN_VALUE / 2; // the last message

  /** Since when [µs], and how much had been published then for acknowledgement by anybody. */
  private record Unacknowledged(long since, long keptBefore) {}

  Outflow(ConnectionFilter filter) {
    this.filter = filter;
  }

  void admitted(User whom, String clientId) {
    user = whom;
    idleSince = filter.nowMicros();
    client = clientId;
  }

  @Override
  public void write(ChannelHandlerContext ctx, Object message, ChannelPromise promise) {
    if (!(message instanceof MqttPublishMessage publish)) {
      pass(ctx, message, promise);
      return;
    }
    boolean acknowledged = publish.fixedHeader().qosLevel() != MqttQoS.AT_MOST_ONCE;
    int packet = publish.variableHeader().packetId();
    if (!mayHear(publish.variableHeader().topicName())) {
      ReferenceCountUtil.release(message);
      promise.trySuccess();
      if (acknowledged) { // for Moquette it has arrived, or it would send it again and again
        ctx.executor()
            .execute(
                () -> ctx.fireChannelRead(MqttMessageBuilders.pubAck().packetId(packet).build()));
      }
    } else if (!ctx.channel().isActive()) { // it has left: neither slow nor a loss
      ctx.write(message, promise);
    } else if (!acknowledged && unread(ctx) > BrokerLimits.UNREAD_BYTES) {
      ReferenceCountUtil.release(message);
      promise.trySuccess();
      filter.unsent(Refusals.shown(client));
    } else {
      sentMicros = filter.nowMicros();
      if (acknowledged) {
        unacknowledged.putIfAbsent(packet, new Unacknowledged(sentMicros, filter.backlog().kept()));
        pass(ctx, message, promise);
      } else {
        onTheWay++;
        pass(ctx, message, promise.unvoid().addListener(sent -> onTheWay--));
      }
    }
  }

  private void pass(ChannelHandlerContext ctx, Object message, ChannelPromise promise) {
    ctx.write(message, promise.unvoid().addListener(done -> taken++));
  }

  /** What the client has not taken yet. */
  ShutdownDrain.Owed owed() {
    return new ShutdownDrain.Owed(unacknowledged.size() + onTheWay, sentMicros);
  }

  private boolean mayHear(String topic) {
    if (user == null) {
      return true;
    }
    int end = topic.indexOf('/', SYSTEMS.length());
    return topic.startsWith(SYSTEMS)
        && end > 0
        && user.mayEnter(topic.substring(SYSTEMS.length(), end));
  }

  private static long unread(ChannelHandlerContext ctx) {
    // Netty counts one byte more as free than there is.
    return Math.max(
        0,
        ctx.channel().config().getWriteBufferHighWaterMark()
            - ctx.channel().bytesBeforeUnwritable());
  }

  @Override
  public void channelRead(ChannelHandlerContext ctx, Object message) {
    if (message instanceof MqttPubAckMessage answer
        && answer.fixedHeader().messageType() == MqttMessageType.PUBACK) {
      unacknowledged.remove(answer.variableHeader().messageId());
    }
    ctx.fireChannelRead(message);
  }

  /** Why to disconnect the client; empty to keep it. Asked about once a second. */
  Optional<String> tooSlow(ChannelHandlerContext ctx) {
    long now = filter.nowMicros();
    if (unread(ctx) == 0 || taken != takenBefore) {
      takenBefore = taken;
      idleSince = now;
    } else if (now - idleSince > filter.limits().patienceMicros()) {
      return Optional.of("it reads nothing");
    }
    if (unacknowledged.isEmpty()) {
      return Optional.empty();
    }
    Unacknowledged oldest = unacknowledged.values().iterator().next();
    if (now - oldest.since > filter.limits().patienceMicros()) {
      return Optional.of("it acknowledges nothing");
    }
    return filter.backlog().kept() - oldest.keptBefore > filter.limits().unacknowledgedBytesAtMost()
        ? Optional.of("too many bytes await its acknowledgement")
        : Optional.empty();
  }
}
