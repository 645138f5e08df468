package org.u2sa.gcs.view;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.gcs.socket.ClientSocket;
import org.u2sa.interfaces.JsonText;

/**
 * One viewer's session. If it reads too slowly and its buffer is full, messages are dropped and
 * counted, so that it does not delay others. Thread-safe.
 */
final class ViewerSession {
  /** Severity of a status, numbered as in the protocol. */
  enum Level {
    INFO,
    WARNING,
    ERROR
  }

  private static final byte MESSAGE_DATA = 0x01;
  private static final byte TIME = 0x02;
  private static final long MAX_UNREAD_BYTES = 16L << 20;
  private static final int HEAD = 1 + Integer.BYTES + Long.BYTES;
  private static final int MAX_SUBSCRIPTIONS = 4096;

  private final ClientSocket socket;
  private final Map<Long, Integer> channelBySubscription = new ConcurrentHashMap<>();
  private final AtomicLong sent = new AtomicLong();
  private final AtomicLong dropped = new AtomicLong();

  ViewerSession(ClientSocket socket) {
    this.socket = socket;
  }

  String address() {
    return socket.address();
  }

  long sent() {
    return sent.get();
  }

  long dropped() {
    return dropped.get();
  }

  /** Returns the reason for rejection; null if accepted. */
  String subscribe(long subscription, int channel) {
    if (channelBySubscription.size() >= MAX_SUBSCRIPTIONS) {
      return "more than " + MAX_SUBSCRIPTIONS + " subscriptions";
    }
    return channelBySubscription.putIfAbsent(subscription, channel) == null
        ? null
        : "subscription " + subscription + " already exists";
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
   * Sends a message that must not be dropped, such as a new channel. A viewer so slow that even
   * these accumulate is disconnected.
   */
  void send(JsonText message) {
    if (socket.backlog() > MAX_UNREAD_BYTES) {
      socket.close();
      return;
    }
    socket.text(message.line());
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
      return; // disconnected, about to be removed
    }
    if (!socket.isWritable()) {
      long count = dropped.incrementAndGet();
      if (Long.bitCount(count) == 1) { // 1, 2, 4, 8…: reports need space too
        status(Level.WARNING, "reads too slowly: " + count + " messages not sent so far");
      }
      return;
    }
    byte[] head = head(HEAD).put(MESSAGE_DATA).putInt((int) subscription).putLong(nanos).array();
    socket.binary(head, data);
    sent.incrementAndGet();
  }

  /** Sends the recording's current time. */
  void time(long nanos) {
    if (socket.isWritable()) {
      socket.binary(head(1 + Long.BYTES).put(TIME).putLong(nanos).array(), new byte[0]);
    }
  }

  private static ByteBuffer head(int bytes) {
    return ByteBuffer.allocate(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }
}
