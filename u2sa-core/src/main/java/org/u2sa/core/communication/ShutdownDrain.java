package org.u2sa.core.communication;

import java.util.Collection;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.u2sa.interfaces.time.Clock;

/**
 * On broker shutdown, waits until clients have received pending messages, such as neutral commands.
 * QoS 1 messages are acknowledged; for others this waits for a while, because clients discard
 * unprocessed messages when the connection closes.
 */
record ShutdownDrain(Collection<Client> clients, Clock clock) {
  private static final long QUIET_MICROS = 500_000;
  private static final long LOOK_EVERY_MICROS = 10_000;
  private static final long GIVE_UP_AFTER_MICROS = 1_500_000; // without progress
  private static final long AT_MOST_MICROS = 10_000_000;
  private static final long ANSWER_WITHIN_MS = 1_000;

  /**
   * Waits while there is progress. No new messages may arrive during this time.
   *
   * @return lower bound of undelivered messages; more may have been queued behind them
   */
  int await() {
    Client.Owed owed = new Client.Owed(0, Long.MIN_VALUE);
    try (Clock.Waiter waiter = clock.newWaiter("last-words")) {
      long begun = clock.micros();
      long progress = begun;
      int least = Integer.MAX_VALUE;
      while (true) {
        owed = owed();
        long now = clock.micros();
        if (owed.messages() == 0 && (clients.isEmpty() || now - owed.sentMicros() > QUIET_MICROS)) {
          return 0;
        }
        if (owed.messages() < least || owed.sentMicros() > progress) {
          least = owed.messages();
          progress = now;
        }
        if (owed.messages() > 0 && now - progress > GIVE_UP_AFTER_MICROS
            || now - begun > AT_MOST_MICROS) {
          return owed.messages();
        }
        waiter.await(now + LOOK_EVERY_MICROS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return owed.messages();
    }
  }

  private Client.Owed owed() throws InterruptedException {
    int messages = 0;
    long sentMicros = Long.MIN_VALUE / 2;
    for (Client client : clients) {
      Future<Client.Owed> answer = client.owed();
      try {
        Client.Owed one = answer.get(ANSWER_WITHIN_MS, TimeUnit.MILLISECONDS);
        messages += one.messages();
        sentMicros = Math.max(sentMicros, one.sentMicros());
      } catch (ExecutionException | TimeoutException e) {
        messages++; // number unknown
      }
    }
    return new Client.Owed(messages, sentMicros);
  }
}
