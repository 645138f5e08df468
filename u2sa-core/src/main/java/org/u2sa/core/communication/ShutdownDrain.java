package org.u2sa.core.communication;

import java.util.Collection;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.u2sa.interfaces.time.Clock;

/**
 * At the broker's end: waits until its clients have taken what was sent to them, such as neutral
 * commands. What was sent with QoS 1 they acknowledge; for the rest they are given some time, since
 * a client forgets what it has not looked at when its connection ends.
 */
final class ShutdownDrain {
  private static final long QUIET_MICROS = 500_000;
  private static final long LOOK_EVERY_MICROS = 10_000;
  private static final long GIVE_UP_AFTER_MICROS = 1_500_000; // if nobody takes anything
  private static final long AT_MOST_MICROS = 10_000_000;
  private static final long ANSWER_WITHIN_MS = 1_000;

  private final Collection<ClientSession> clients;
  private final Clock clock;

  ShutdownDrain(Collection<ClientSession> clients, Clock clock) {
    this.clients = clients;
    this.clock = clock;
  }

  /**
   * Of one client or all.
   *
   * @param messages that were sent and of which nobody can say that they have arrived
   * @param sentMicros when the last one was sent
   */
  record Owed(int messages, long sentMicros) {}

  /**
   * Waits for as long as anybody takes anything. Nothing new may come in meanwhile.
   *
   * @return messages that were not taken; at least, since more may have waited behind them
   */
  int await() {
    Owed owed = new Owed(0, Long.MIN_VALUE);
    try (Clock.Waiter waiter = clock.newWaiter("last-words")) {
      long begun = clock.micros();
      long progress = begun;
      int least = Integer.MAX_VALUE;
      while (true) {
        owed = owed();
        long now = clock.micros();
        if (owed.messages == 0 && (clients.isEmpty() || now - owed.sentMicros > QUIET_MICROS)) {
          return 0;
        }
        if (owed.messages < least || owed.sentMicros > progress) {
          least = owed.messages;
          progress = now;
        }
        if (owed.messages > 0 && now - progress > GIVE_UP_AFTER_MICROS
            || now - begun > AT_MOST_MICROS) {
          return owed.messages;
        }
        waiter.await(now + LOOK_EVERY_MICROS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return owed.messages;
    }
  }

  private Owed owed() throws InterruptedException {
    int messages = 0;
    long sentMicros = Long.MIN_VALUE / 2;
    for (ClientSession client : clients) {
      Future<Owed> answer = client.owed();
      try {
        Owed one = answer.get(ANSWER_WITHIN_MS, TimeUnit.MILLISECONDS);
        messages += one.messages;
        sentMicros = Math.max(sentMicros, one.sentMicros);
      } catch (ExecutionException | TimeoutException e) {
        messages++; // it cannot say how many
      }
    }
    return new Owed(messages, sentMicros);
  }
}
