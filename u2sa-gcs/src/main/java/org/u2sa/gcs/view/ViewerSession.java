package org.u2sa.gcs.view;

import io.netty.buffer.ByteBuf;
import io.netty.channel.Channel;
import io.netty.handler.codec.http.websocketx.BinaryWebSocketFrame;
import io.netty.handler.codec.http.websocketx.TextWebSocketFrame;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.interfaces.JsonText;

/**
 * One viewer. What it does not read in time is dropped and counted, once its buffer is full: it
 * holds nobody else up. Safe for several threads.
 */
final class ViewerSession {
  /** How grave a status is, as the protocol numbers it. */
  enum Level {
    INFO,
    WARNING,
    ERROR
  }

  private static final byte MESSAGE_DATA = 0x01;
  private static final byte TIME = 0x02;
  private static final long MAX_UNREAD_BYTES = 16L << 20;
  private static final int HEAD = 1 + Integer.BYTES + Long.BYTES;
  private static final int MOST_SUBSCRIPTIONS = 4096;

  private final Channel socket;
  private final Map<Long, Integer> channelBySubscription = new ConcurrentHashMap<>();
  private final AtomicLong sent = new AtomicLong();
  private final AtomicLong dropped = new AtomicLong();

  ViewerSession(Channel socket) {
    this.socket = socket;
  }

  /** Where it is. */
  String address() {
    return String.valueOf(socket.remoteAddress());
  }

  long sent() {
    return sent.get();
  }

  long dropped() {
    return dropped.get();
  }

  /** Returns why it is refused, or null. */
  String subscribe(long subscription, int channel) {
    if (channelBySubscription.size() >= MOST_SUBSCRIPTIONS) {
      return "more than " + MOST_SUBSCRIPTIONS + " subscriptions";
    }
    return channelBySubscription.putIfAbsent(subscription, channel) == null
        ? null
        : "subscription " + subscription + " is there already";
  }

  boolean unsubscribe(long subscription) {
    return channelBySubscription.remove(subscription) != null;
  }

  boolean hears(int channel) {
    return channelBySubscription.containsValue(channel);
  }

  boolean hearsAnything() {
    return !channelBySubscription.isEmpty();
  }

  /**
   * Sends what a viewer must not miss, such as a new channel. One that has not read for so long
   * that even these pile up is disconnected.
   */
  void send(JsonText message) {
    if (socket.bytesBeforeWritable() > MAX_UNREAD_BYTES) {
      socket.close();
      return;
    }
    socket.writeAndFlush(new TextWebSocketFrame(message.line()));
  }

  void status(Level level, String text) {
    send(
        new JsonText()
            .put("op", "status")
            .put("level", level.ordinal())
            .put("message", text)
            .put("id", level.name()));
  }

  /** Sends a message under each subscription of its channel. */
  void message(int channel, long nanos, byte[] data) {
    List<Long> subscriptions = new ArrayList<>();
    channelBySubscription.forEach(
        (subscription, heard) -> {
          if (heard == channel) {
            subscriptions.add(subscription);
          }
        });
    for (long subscription : subscriptions) {
      message(subscription, nanos, data);
    }
  }

  /** Sends a message under one subscription. */
  void message(long subscription, long nanos, byte[] data) {
    if (!socket.isActive()) {
      return; // it has left, and will be forgotten
    }
    if (!socket.isWritable()) {
      long count = dropped.incrementAndGet();
      if (Long.bitCount(count) == 1) { // 1, 2, 4, 8…: telling takes room, too
        status(Level.WARNING, "reads too slowly: " + count + " messages were not sent so far");
      }
      return;
    }
    ByteBuf frame = socket.alloc().buffer(HEAD + data.length);
    frame.writeByte(MESSAGE_DATA).writeIntLE((int) subscription).writeLongLE(nanos);
    frame.writeBytes(data);
    socket.writeAndFlush(new BinaryWebSocketFrame(frame));
    sent.incrementAndGet();
  }

  /** Tells what time it is in the recording. */
  void time(long nanos) {
    if (socket.isWritable()) {
      ByteBuf frame = socket.alloc().buffer(1 + Long.BYTES);
      socket.writeAndFlush(new BinaryWebSocketFrame(frame.writeByte(TIME).writeLongLE(nanos)));
    }
  }
}
