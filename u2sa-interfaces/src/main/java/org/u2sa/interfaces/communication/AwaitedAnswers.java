package org.u2sa.interfaces.communication;

import java.io.IOException;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Who waits for the broker's answer to which packet: publishers for a confirmation, others for the
 * answer to a question. Numbers are given out by one thread at a time; answers may come on another.
 */
final class AwaitedAnswers {
  private static final int CONFIRMATIONS_AT_MOST = 4_096;
  private static final int LAST_PACKET = 65_535;
  private static final Runnable NOBODY = () -> {};

  private final Map<Integer, Runnable> unconfirmed = new ConcurrentHashMap<>(); // by packet
  private final Map<Integer, CompletableFuture<byte[]>> questions = new ConcurrentHashMap<>();
  private int lastPacket;

  /** Whether so many messages await their confirmation that no more are to be sent. */
  boolean isFull() {
    return unconfirmed.size() >= CONFIRMATIONS_AT_MOST;
  }

  /** Messages that await their confirmation. */
  int unconfirmed() {
    return unconfirmed.size();
  }

  /**
   * Numbers a message that the broker is to confirm.
   *
   * @param confirmed what to do then; null for nothing
   */
  int publishing(Runnable confirmed) {
    int packet = nextPacket();
    unconfirmed.put(packet, confirmed == null ? NOBODY : confirmed);
    return packet;
  }

  /** Numbers a question. */
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

  /** Waits no more for what was not sent, or was answered too late. */
  void forget(int packet) {
    unconfirmed.remove(packet);
    questions.remove(packet);
  }

  /** Tells who waited. */
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

  /** No question will be answered. Who waits for a confirmation is not told. */
  void fail(IOException why) {
    questions.values().forEach(answer -> answer.completeExceptionally(why));
  }
}
