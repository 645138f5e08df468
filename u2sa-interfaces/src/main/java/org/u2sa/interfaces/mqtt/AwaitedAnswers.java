package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Pending broker responses by packet identifier. Identifiers are assigned by one thread at a time;
 * responses may arrive on another.
 */
final class AwaitedAnswers {
  private static final int CONFIRMATIONS_AT_MOST = 4_096;
  private static final int LAST_PACKET = 65_535;
  private static final Runnable NOBODY = () -> {};

  private final Map<Integer, Runnable> unconfirmed =
      new ConcurrentHashMap<>(); // by packet identifier
  private final Map<Integer, CompletableFuture<byte[]>> questions = new ConcurrentHashMap<>();
  private int lastPacket;

  boolean isFull() {
    return unconfirmed.size() >= CONFIRMATIONS_AT_MOST;
  }

  int unconfirmed() {
    return unconfirmed.size();
  }

  /** Identifier of a message; {@code confirmed} may be null. */
  int publishing(Runnable confirmed) {
    int packet = nextPacket();
    unconfirmed.put(packet, confirmed == null ? NOBODY : confirmed);
    return packet;
  }

  int asking(CompletableFuture<byte[]> answer) {
    int packet = nextPacket();
    questions.put(packet, answer);
    return packet;
  }

  private int nextPacket() {
    do {
      lastPacket = lastPacket % LAST_PACKET + 1;
    } while (unconfirmed.containsKey(lastPacket) || questions.containsKey(lastPacket));
    return lastPacket;
  }

  /** Cancels a request that was not sent or timed out. */
  void forget(int packet) {
    unconfirmed.remove(packet);
    questions.remove(packet);
  }

  void answered(int packet, byte[] codes) {
    Runnable confirmed = unconfirmed.remove(packet);
    if (confirmed != null) {
      confirmed.run();
    }
    CompletableFuture<byte[]> answer = questions.get(packet);
    if (answer != null) {
      answer.complete(codes);
    }
  }

  /** Fails all pending requests. Publishers awaiting a confirmation are not notified. */
  void fail(IOException why) {
    questions.values().forEach(answer -> answer.completeExceptionally(why));
  }
}
