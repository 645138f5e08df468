package org.u2sa.gcs.remote;

import java.util.Collections;
import java.util.SortedSet;
import java.util.TreeSet;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.schema.U2SAData;

/** Finds the systems that talk over a broker by the health reports of their services. */
final class SystemSearch implements Receiver {
  /** Services report each quarter of a second unless told otherwise; twice that, and some slack. */
  private static final double LISTEN_ON_S = 0.6;

  private final SortedSet<String> heard = Collections.synchronizedSortedSet(new TreeSet<>());
  private final Clock.Waiter waiter;

  private SystemSearch(Clock.Waiter waiter) {
    this.waiter = waiter;
  }

  /**
   * Listens until the first system is heard, and then on for others.
   *
   * @param everywhere a transport of {@link org.u2sa.interfaces.communication.Topic#ANY_SYSTEM}
   * @param timeoutS how long to wait for the first [s]
   * @return the IDs heard; perhaps none
   */
  static SortedSet<String> heard(Transport everywhere, String name, Clock clock, double timeoutS)
      throws InterruptedException {
    try (Clock.Waiter waiter = clock.newWaiter(name)) {
      SystemSearch search = new SystemSearch(waiter);
      try (Connection connection = everywhere.connect(name, search)) {
        connection.subscribe(Channels.HEALTH);
        long first = clock.micros() + Clock.micros(timeoutS);
        while (search.heard.isEmpty() && clock.micros() < first) {
          waiter.await(first);
        }
        long others = clock.micros() + Clock.micros(Math.min(timeoutS, LISTEN_ON_S));
        while (!search.heard.isEmpty() && clock.micros() < others) {
          waiter.await(others);
        }
        return new TreeSet<>(search.heard);
      }
    }
  }

  @Override
  public void receive(Channel<?> channel, U2SAData message) {
    if (!message.systemId().isEmpty()) {
      heard.add(message.systemId());
    }
    waiter.signal();
  }

  @Override
  public void trouble(String what) {
    // A system of a newer data model, or a lost connection: what is not heard is said at the end.
    waiter.signal();
  }
}
