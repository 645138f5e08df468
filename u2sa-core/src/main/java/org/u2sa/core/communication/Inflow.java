package org.u2sa.core.communication;

import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.handler.codec.mqtt.MqttPublishMessage;
import io.netty.util.ReferenceCountUtil;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.TimeUnit;
import org.u2sa.core.communication.limit.Allowance;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.OccupancyGrid;

/**
 * Rate-limits a client's packets by back-pressure: stops reading, so that packets wait at the
 * client and none is lost. Confined to its connection's thread.
 */
final class Inflow extends ChannelInboundHandlerAdapter {
  /** Decides when packets are handled. */
  interface Gate {
    /**
     * Whether the next packet may be read: not while the client leaves answers unread, nor before
     * Moquette has finished connecting it: Moquette disconnects a client that subscribes earlier,
     * which may be after the client has received CONNACK.
     */
    boolean isReady();

    /** Whether a packet may be accepted now; if so, it is charged to the allowances. */
    boolean isInTurn(Object packet);

    /**
     * Whether the packet acknowledges a message that was sent to the client. There are no more of
     * them than the broker has sent, so they are not counted and never wait: behind a few hundred
     * of them, an emergency stop would.
     */
    boolean isAwaited(Object packet);

    /** Whether the client has no log-in where others have one. */
    boolean isAnonymous();

    /** Whether the client is an operator's, which never waits for others. */
    boolean isOperator();
  }

  private static final long LOOK_AGAIN_MS = 2;

  /** Fraction of its rates a client has while a subscriber of its messages is behind. */
  private static final double SLOWER = 0.1;

  private static final double SLOWER_BURST_MESSAGES = 20.0; // may arrive between two checks

  /**
   * Guaranteed fraction of its rate, whatever others send: enough for a vehicle's service or an
   * operator.
   */
  private static final double SHARE = 0.01;

  private static final double SHARE_BURST_MESSAGES = 20.0; // shared by many simultaneous clients

  /**
   * Maximum payload of a short message [bytes], which is handled within microseconds regardless of
   * its content.
   */
  static final int SHORT_PAYLOAD = 1_024;

  private static final int LONG_BYTES = 2 * SHORT_PAYLOAD; // more than any short message takes

  private final BrokerState broker;
  private final Gate gate;
  private final Deque<Object> held = new ArrayDeque<>(); // packets already read
  private final Allowance share; // its guaranteed share
  private final Allowance messages;
  private final Allowance bytes;
  private final Allowance slowMessages;
  private final Allowance slowBytes;
  private long decoded; // number of packets
  private long sincePacket; // bytes received since the last complete packet
  private double chargedS; // of the current read, for complete messages
  private double advanceS; // charged for the next read
  private double lastReadS; // cost of the last read of a long message
  private boolean isLong; // whether the last read was of a long message
  private boolean isBehind; // whether a subscriber is behind
  private boolean isWithinShare; // whether the next message is
  private boolean paused;
  private ChannelHandlerContext context;

  Inflow(BrokerState broker, Gate gate) {
    this.broker = broker;
    this.gate = gate;
    long now = broker.nowMicros();
    double messagesPerS = broker.limits.clientMessagesPerSecond();
    double bytesPerS = broker.limits.clientBytesPerSecond();
    share = new Allowance(SHARE * messagesPerS, SHARE_BURST_MESSAGES, now);
    messages = new Allowance(messagesPerS, now);
    bytes = new Allowance(bytesPerS, now);
    slowMessages = new Allowance(SLOWER * messagesPerS, SLOWER_BURST_MESSAGES, now);
    slowBytes = new Allowance(SLOWER * bytesPerS, BrokerLimits.BEHIND_BYTES, now);
  }

  @Override
  public void handlerAdded(ChannelHandlerContext ctx) {
    context = ctx;
  }

  /** Pauses reading until the session is ready. */
  void hold() {
    pause(context);
  }

  @Override
  public void channelRead(ChannelHandlerContext ctx, Object message) {
    decoded++;
    sincePacket = 0;
    if (gate.isAwaited(message)) {
      ctx.fireChannelRead(message);
    } else if (held.isEmpty() && isOpen() && isAffordable(message) && gate.isInTurn(message)) {
      letIn(ctx, message);
    } else {
      held.add(message);
      pause(ctx);
    }
  }

  /** Number of packets from the decoder, including undecodable ones. */
  long decoded() {
    return decoded;
  }

  private boolean isOpen() {
    long now = broker.nowMicros();
    isWithinShare = share.isOpen(now);
    return gate.isReady()
        && (isWithinShare || broker.beyondShares.isOpen(now))
        && messages.isOpen(now)
        && bytes.isOpen(now)
        && (!gate.isAnonymous() || broker.anonymousInput.isOpen())
        && (!isBehind || slowMessages.isOpen(now) && slowBytes.isOpen(now));
  }

  /** Counts bytes as received, before decryption and decoding. */
  void received(int length) {
    long now = broker.nowMicros();
    sincePacket += length;
    chargedS = 0.0;
    bytes.take(length, now);
    if (isBehind) {
      slowBytes.take(length, now);
    }
    if (!isOpen()) {
      pause(context);
    }
  }

  /**
   * Processes a read, decryption included; charges its time if it was of a long message, and reads
   * no further while others' long messages have taken too much.
   */
  void process(Runnable read) {
    long before = broker.nowMicros();
    read.run();
    long now = broker.nowMicros();
    double seconds = Clock.seconds(now - before);
    if (gate.isAnonymous()) {
      broker.anonymousInput.take(seconds);
      if (!broker.anonymousInput.isOpen()) {
        pause(context);
      }
    }
    isLong = sincePacket > LONG_BYTES || chargedS > 0.0;
    if (isLong) {
      lastReadS = Math.max(0.0, seconds - chargedS);
      broker.costlyTime.take(this, lastReadS - advanceS, now);
      advanceS = 0.0;
      if (!mayReadOn(now)) {
        pause(context);
      }
    }
  }

  /** Whether the network's thread has time for the next read. Operators never wait. */
  private boolean mayReadOn(long now) {
    return !isLong || gate.isOperator() || broker.costlyTime.isOpen(this, now);
  }

  /**
   * Records whether a subscriber of the client's last message is behind. Meanwhile the client is
   * read more slowly, so that a burst is not lost, but never stopped, because a slow subscriber
   * must not block the publisher.
   */
  void subscriberIsBehind(boolean behind) {
    isBehind = behind;
  }

  private void letIn(ChannelHandlerContext ctx, Object message) {
    (isWithinShare ? share : broker.beyondShares).take(1.0);
    messages.take(1.0);
    if (isBehind) {
      slowMessages.take(1.0);
    }
    if (!isCostly(message)) {
      ctx.fireChannelRead(message);
      return;
    }
    long before = broker.nowMicros();
    ctx.fireChannelRead(message);
    long now = broker.nowMicros();
    double tookS = Clock.seconds(now - before);
    chargedS += tookS;
    broker.costlyTime.take(this, tookS, now);
  }

  /**
   * Whether the network's thread has time for the message. Operators' messages never wait: an
   * emergency stop with a long reason is a long message too.
   */
  private boolean isAffordable(Object message) {
    return !isCostly(message)
        || gate.isOperator()
        || broker.costlyTime.isOpen(this, broker.nowMicros());
  }

  /**
   * Whether the cost of a message must be measured by its size: it is long, or a grid, whose cells
   * may be compressed a thousandfold.
   */
  private static boolean isCostly(Object message) {
    return message instanceof MqttPublishMessage publish
        && publish.fixedHeader() != null
        && publish.content() != null
        && (publish.content().readableBytes() > SHORT_PAYLOAD
            || publish.variableHeader().topicName().contains(OccupancyGrid.TYPE.name()));
  }

  private void pause(ChannelHandlerContext ctx) {
    ctx.channel().config().setAutoRead(false);
    if (!paused) {
      paused = true;
      ctx.executor().schedule(() -> resume(ctx), LOOK_AGAIN_MS, TimeUnit.MILLISECONDS);
    }
  }

  private void resume(ChannelHandlerContext ctx) {
    paused = false;
    if (ctx.isRemoved()) {
      return;
    }
    if (gate.isAnonymous()) {
      broker.anonymousInput.run(() -> readOn(ctx));
    } else {
      readOn(ctx);
    }
  }

  private void readOn(ChannelHandlerContext ctx) {
    boolean any = false;
    while (!held.isEmpty() && isOpen() && isAffordable(held.peek()) && gate.isInTurn(held.peek())) {
      letIn(ctx, held.poll());
      any = true;
    }
    if (any) {
      ctx.fireChannelReadComplete();
    }
    long now = broker.nowMicros();
    if (held.isEmpty() && isOpen() && mayReadOn(now)) {
      if (isLong) { // in advance, or all waiting clients would read at once
        broker.costlyTime.take(this, lastReadS - advanceS, now);
        advanceS = lastReadS;
      }
      ctx.channel().config().setAutoRead(true);
    } else {
      pause(ctx);
    }
  }

  @Override
  public void handlerRemoved(ChannelHandlerContext ctx) {
    held.forEach(ReferenceCountUtil::release);
    held.clear();
  }
}
