package org.u2sa.core.communication;

import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelFuture;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelOutboundHandlerAdapter;
import io.netty.channel.ChannelPromise;
import io.netty.handler.codec.mqtt.MqttEncoder;
import io.netty.handler.codec.mqtt.MqttMessage;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.u2sa.core.communication.access.Refusals;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.communication.routing.Publication;
import org.u2sa.core.security.User;
import org.u2sa.interfaces.mqtt.ClientIds;

/**
 * Outgoing messages of one client: filters by the systems it may listen to and bounds its backlog.
 * Confined to its connection's thread.
 */
final class Outflow extends ChannelOutboundHandlerAdapter {
  private static final String SYSTEMS = "u2sa/";
  private static final String TOO_MANY_BYTES = "too many bytes are unacknowledged";
  private static final int LAST_PACKET = 65_535;

  /**
   * Maximum number of unacknowledged messages per client. Half of the packet IDs stay free, so the
   * next free one is found quickly in whatever order the client acknowledges.
   */
  private static final int MAX_UNACKNOWLEDGED = LAST_PACKET / 2;

  private static final int BYTES_OF_A_NUMBER = 128; // memory of one map entry
  private static final int PUBACK = 0x4002; // type and length

  /** More answers than one read of ordinary messages causes. */
  private static final int MAX_UNSENT_ANSWERS = 512;

  private final BrokerState broker;
  private final Map<Integer, Unacknowledged> unacknowledged = new LinkedHashMap<>(); // by packet
  private User user; // null grants access to all systems
  private boolean isAnonymous;
  private String client = "";
  private long taken; // packets written to the client's socket
  private long takenBefore;
  private long idleSince; // [µs]
  private int unsentAnswers; // acknowledgements and other replies
  private int onTheWay; // unacknowledged messages queued but not yet written
  private long sentMicros = Long.MIN_VALUE / 2; // time of the last message
  private int lastPacket;
  private String mayHear = ""; // topic prefix last found to be allowed
  private boolean isFlushing; // flush scheduled
  private ChannelHandlerContext packets; // position where packets are encoded

  /**
   * A message awaiting acknowledgement.
   *
   * @param since when it was sent [µs]
   * @param keptBefore total bytes kept for acknowledgement when it was sent
   */
  private record Unacknowledged(long since, long keptBefore) {}

  Outflow(BrokerState broker) {
    this.broker = broker;
  }

  /**
   * @param anonymous whether sending is charged to the time of clients without a log-in
   */
  void admitted(User whom, String clientId, boolean anonymous) {
    user = whom;
    isAnonymous = anonymous;
    idleSince = broker.nowMicros();
    client = ClientIds.shown(clientId);
  }

  /** Handles Moquette's writes, which are answers. */
  @Override
  public void write(ChannelHandlerContext ctx, Object message, ChannelPromise promise) {
    note(ctx.write(message, promise.unvoid()));
  }

  private int newNumber() {
    do {
      lastPacket = lastPacket % LAST_PACKET + 1;
    } while (unacknowledged.containsKey(lastPacket));
    unacknowledged.put(lastPacket, new Unacknowledged(sentMicros, broker.kept()));
    return lastPacket;
  }

  /**
   * Sends a message.
   *
   * @param eachMatters whether the client is to acknowledge it
   * @return why to disconnect the client; null to keep it
   */
  String deliver(ChannelHandlerContext ctx, Publication publication, boolean eachMatters) {
    if (!mayHear(publication.topic())) {
      return null;
    }
    long unread = unread(ctx);
    // Retained messages come in bursts and share their payload with the table.
    long limit =
        publication.isRetained()
            ? broker.limits.maxUnacknowledgedBytes()
            : BrokerLimits.UNREAD_BYTES;
    if (!eachMatters && unread > limit) {
      broker.dropped(Refusals.shown(client));
      return null;
    }
    if (eachMatters && unread > broker.limits.maxUnacknowledgedBytes()) {
      return TOO_MANY_BYTES;
    }
    if (eachMatters && unacknowledged.size() >= MAX_UNACKNOWLEDGED) {
      return "too many messages are unacknowledged";
    }
    sentMicros = broker.nowMicros();
    if (eachMatters) {
      int packet = newNumber();
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

  /** Approximate memory used by the client's messages [bytes]. */
  long kept(ChannelHandlerContext ctx) {
    return unread(ctx) + (long) BYTES_OF_A_NUMBER * unacknowledged.size();
  }

  void acknowledge(ChannelHandlerContext ctx, int packet) {
    note(write(ctx, ctx.alloc().ioBuffer(2 * Short.BYTES).writeShort(PUBACK).writeShort(packet)));
  }

  void answer(ChannelHandlerContext ctx, MqttMessage answer) {
    flushSoon(ctx);
    note(ctx.write(answer));
  }

  private void note(ChannelFuture answer) {
    unsentAnswers++;
    answer.addListener(
        done -> {
          taken++;
          unsentAnswers--;
        });
  }

  /**
   * Whether too many answers are unsent to read further requests: a client that asks and never
   * reads would otherwise exhaust memory.
   */
  boolean owesAnswers() {
    return unsentAnswers > MAX_UNSENT_ANSWERS;
  }

  /** Flushes all writes of one read pass of the network thread together. */
  private ChannelFuture write(ChannelHandlerContext ctx, ByteBuf packet) {
    flushSoon(ctx);
    return packets.write(packet);
  }

  private void flushSoon(ChannelHandlerContext ctx) {
    if (packets == null) {
      packets = ctx.pipeline().context(MqttEncoder.class);
    }
    if (!isFlushing) {
      isFlushing = true;
      ctx.executor().execute(this::flush);
    }
  }

  private void flush() {
    isFlushing = false;
    if (isAnonymous) {
      broker.anonymousOutput.time().run(packets::flush);
    } else {
      packets.flush();
    }
  }

  Client.Owed owed() {
    return new Client.Owed(unacknowledged.size() + onTheWay, sentMicros);
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
      mayHear = topic.substring(0, end + 1); // a changed user is disconnected
    }
    return may;
  }

  private static long unread(ChannelHandlerContext ctx) {
    // Netty reports one free byte too many.
    return Math.max(
        0,
        ctx.channel().config().getWriteBufferHighWaterMark()
            - ctx.channel().bytesBeforeUnwritable());
  }

  /** Handles an acknowledgement; unknown packet IDs are ignored. */
  void acknowledged(int packet) {
    unacknowledged.remove(packet);
  }

  /** Whether the client has not acknowledged a message of this packet ID. */
  boolean isAwaited(int packet) {
    return unacknowledged.containsKey(packet);
  }

  /** Whether the client's backlog calls for slowing down publishers to it. */
  static boolean isBehind(ChannelHandlerContext ctx) {
    return unread(ctx) > BrokerLimits.BEHIND_BYTES;
  }

  /** Reason to disconnect the client, or empty. Called about once a second. */
  Optional<String> tooSlow(ChannelHandlerContext ctx) {
    long now = broker.nowMicros();
    if (unread(ctx) == 0 || taken != takenBefore) {
      takenBefore = taken;
      idleSince = now;
    } else if (now - idleSince > broker.limits.patienceMicros()) {
      return Optional.of("it does not read");
    }
    if (unacknowledged.isEmpty()) {
      return Optional.empty();
    }
    Unacknowledged oldest = unacknowledged.values().iterator().next();
    if (now - oldest.since > broker.limits.patienceMicros()) {
      return Optional.of("it does not acknowledge");
    }
    return broker.kept() - oldest.keptBefore > broker.limits.maxUnacknowledgedBytes()
        ? Optional.of(TOO_MANY_BYTES)
        : Optional.empty();
  }
}
