package org.u2sa.core.communication;

import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelDuplexHandler;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelPromise;
import io.netty.handler.codec.mqtt.MqttEncoder;
import io.netty.handler.codec.mqtt.MqttMessageBuilders;
import io.netty.handler.codec.mqtt.MqttMessageType;
import io.netty.handler.codec.mqtt.MqttPubAckMessage;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.handler.codec.mqtt.MqttPublishVariableHeader;
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
  private static final String TOO_MANY_BYTES = "too many bytes await its acknowledgement";
  private static final int NOBODYS = 0;
  private static final int LAST_PACKET = 65_535;

  /** So many numbers of packets stay free for Moquette, which has at most ten on the way. */
  private static final int KEPT_FREE = 1_024;

  private static final int PUBACK = 0x4002; // its type and length

  /** More than one read of ordinary messages makes. */
  private static final int MAX_UNSENT_ANSWERS = 512;

  private final ConnectionFilter filter;
  private final Map<Integer, Unacknowledged> unacknowledged = new LinkedHashMap<>(); // by packet
  private User user; // null: may listen to everything
  private String client = "";
  private long taken; // packets that the client's side of the network took
  private long takenBefore;
  private long idleSince; // [µs]
  private int unsentAnswers; // acknowledgements and the like
  private int onTheWay; // of those that are not acknowledged: handed over and not sent yet
  private long sentMicros = Long.MIN_VALUE / 2; // the last message
  private int lastPacket;
  private String mayHear = ""; // what topics begin with of which it is known
  private boolean isFlushing; // soon
  private ChannelHandlerContext packets; // where they are bytes already

  /**
   * A message that is to be acknowledged.
   *
   * @param since when it was sent [µs]
   * @param keptBefore how much had been published then for acknowledgement by anybody
   * @param moquettes the packet's number that Moquette gave it; {@link #NOBODYS} if it knows
   *     nothing of it
   */
  private record Unacknowledged(long since, long keptBefore, int moquettes) {}

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
      answer(ctx.write(message, promise.unvoid()));
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
        pass(ctx, numbered(publish, numberOf(packet)), promise);
      } else {
        onTheWay++;
        pass(ctx, message, promise.unvoid().addListener(sent -> onTheWay--));
      }
    }
  }

  private void pass(ChannelHandlerContext ctx, Object message, ChannelPromise promise) {
    ctx.write(message, promise.unvoid().addListener(done -> taken++));
  }

  /** The number under which a packet of Moquette's goes out; the same when it is sent again. */
  private int numberOf(int moquettes) {
    for (Map.Entry<Integer, Unacknowledged> entry : unacknowledged.entrySet()) {
      if (entry.getValue().moquettes == moquettes) {
        return entry.getKey();
      }
    }
    return number(moquettes);
  }

  private int number(int moquettes) {
    do {
      lastPacket = lastPacket % LAST_PACKET + 1;
    } while (unacknowledged.containsKey(lastPacket));
    unacknowledged.put(
        lastPacket, new Unacknowledged(sentMicros, filter.backlog().kept(), moquettes));
    return lastPacket;
  }

  private static MqttPublishMessage numbered(MqttPublishMessage publish, int packet) {
    return new MqttPublishMessage(
        publish.fixedHeader(),
        new MqttPublishVariableHeader(publish.variableHeader().topicName(), packet),
        publish.content());
  }

  /**
   * Sends a message that comes past Moquette.
   *
   * @param eachMatters whether the client is to acknowledge it
   * @return why to disconnect the client; null to keep it
   */
  String deliver(ChannelHandlerContext ctx, Publication publication, boolean eachMatters) {
    if (!mayHear(publication.topic())) {
      return null;
    }
    long unread = unread(ctx);
    if (!eachMatters && unread > BrokerLimits.UNREAD_BYTES) {
      filter.unsent(Refusals.shown(client));
      return null;
    }
    if (eachMatters && unread > filter.limits().unacknowledgedBytesAtMost()) {
      return TOO_MANY_BYTES;
    }
    if (eachMatters && unacknowledged.size() > LAST_PACKET - KEPT_FREE) {
      return "too many messages await its acknowledgement";
    }
    sentMicros = filter.nowMicros();
    if (eachMatters) {
      int packet = number(NOBODYS);
      write(ctx, publication.packet(ctx.alloc(), packet)).addListener(done -> taken++);
    } else {
      onTheWay++;
      write(ctx, publication.packet(ctx.alloc()))
          .addListener(
              done -> {
                taken++;
                onTheWay--;
              });
    }
    return null;
  }

  /** Acknowledges what the client published. */
  void acknowledge(ChannelHandlerContext ctx, int packet) {
    answer(write(ctx, ctx.alloc().ioBuffer(2 * Short.BYTES).writeShort(PUBACK).writeShort(packet)));
  }

  private void answer(ChannelFuture written) {
    unsentAnswers++;
    written.addListener(
        done -> {
          taken++;
          unsentAnswers--;
        });
  }

  /**
   * Whether so many answers wait for the client that it should be read no further: one that asks
   * and never reads would otherwise fill the memory.
   */
  boolean owesAnswers() {
    return unsentAnswers > MAX_UNSENT_ANSWERS;
  }

  /** What is written while the network's thread reads goes out together. */
  private ChannelFuture write(ChannelHandlerContext ctx, ByteBuf packet) {
    if (packets == null) {
      packets = ctx.pipeline().context(MqttEncoder.class);
    }
    if (!isFlushing) {
      isFlushing = true;
      ctx.executor().execute(this::flush);
    }
    return packets.write(packet);
  }

  private void flush() {
    isFlushing = false;
    packets.flush();
  }

  /** What the client has not taken yet. */
  ShutdownDrain.Owed owed() {
    return new ShutdownDrain.Owed(unacknowledged.size() + onTheWay, sentMicros);
  }

  private boolean mayHear(String topic) {
    if (user == null || !mayHear.isEmpty() && topic.startsWith(mayHear)) {
      return true;
    }
    int end = topic.indexOf('/', SYSTEMS.length());
    boolean may =
        topic.startsWith(SYSTEMS)
            && end > 0
            && user.mayEnter(topic.substring(SYSTEMS.length(), end));
    if (may) {
      mayHear = topic.substring(0, end + 1); // who is changed is put out
    }
    return may;
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
      Unacknowledged answered = unacknowledged.remove(answer.variableHeader().messageId());
      if (answered != null && answered.moquettes != NOBODYS) {
        ctx.fireChannelRead(MqttMessageBuilders.pubAck().packetId(answered.moquettes).build());
      } // Moquette does not know the others
    } else {
      ctx.fireChannelRead(message);
    }
  }

  /** Whether so much waits for the client that those who publish to it should slow down. */
  static boolean isBehind(ChannelHandlerContext ctx) {
    return unread(ctx) > BrokerLimits.BEHIND_BYTES;
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
        ? Optional.of(TOO_MANY_BYTES)
        : Optional.empty();
  }
}
