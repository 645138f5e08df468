package org.u2sa.service;

import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.Clock;

/** Counts the data that a service publishes; what the service contract makes it say are no data. */
final class PublishedData {
  private static final Set<Channel<?>> CONTRACT =
      Set.of(
          Channels.HEALTH,
          Channels.DISCOVERY,
          Channels.FUNCTIONALITY,
          Channels.STOP,
          Channels.CONFIGURATION);

  private final Clock clock;
  private final AtomicLong published = new AtomicLong();
  private volatile long lastMicros;

  PublishedData(Clock clock) {
    this.clock = clock;
  }

  /** Takes note that a message was published. */
  void note(Channel<?> channel) {
    if (!CONTRACT.contains(channel)) {
      lastMicros = clock.micros();
      published.incrementAndGet();
    }
  }

  long published() {
    return published.get();
  }

  /** Time since the last one [s]; empty before the first. */
  OptionalDouble ageS() {
    return published() == 0
        ? OptionalDouble.empty()
        : OptionalDouble.of(Clock.seconds(Math.max(0, clock.micros() - lastMicros)));
  }
}
