package org.u2sa.gcs.mavlink.event;

import io.dronefleet.mavlink.common.Event;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.u2sa.gcs.mavlink.telemetry.Uptime;

/** The newest events of a vehicle, numbered from 1, modulo 65 536. Confined to one thread. */
@SuppressWarnings("deprecation") // the library predates the message's final form
final class EventLog {
  private static final int KEPT = 64;
  private static final int ARGUMENT_BYTES = 40;
  private static final int SEQUENCES = 0x1_0000;

  private final Uptime uptime;
  private final Deque<Event> kept = new ArrayDeque<>();
  private long count;

  EventLog(Uptime uptime) {
    this.uptime = uptime;
  }

  /**
   * Adds an event.
   *
   * @param arguments little-endian, without gaps
   */
  void add(EventType type, ByteBuffer arguments) {
    byte[] bytes = new byte[ARGUMENT_BYTES];
    System.arraycopy(arguments.array(), 0, bytes, 0, arguments.position());
    count++;
    kept.add(
        Event.builder()
            .id(type.id())
            .eventTimeBootMs(uptime.millis())
            .sequence(newest())
            .logLevels(type.levels())
            .arguments(bytes)
            .build());
    if (kept.size() > KEPT) {
      kept.remove();
    }
  }

  /** Buffer for the arguments of an event. */
  static ByteBuffer arguments() {
    return ByteBuffer.allocate(ARGUMENT_BYTES).order(ByteOrder.LITTLE_ENDIAN);
  }

  /** Number of events so far. */
  long count() {
    return count;
  }

  /** Sequence number of the newest event; 0 before the first. */
  int newest() {
    return (int) (count % SEQUENCES);
  }

  /** Sequence number of the oldest kept event; of the next event if none is kept. */
  int oldest() {
    return (int) ((count - kept.size() + 1) % SEQUENCES);
  }

  /** Event with a sequence number; empty if it is not kept. */
  Optional<Event> get(int sequence) {
    return kept.stream().filter(each -> each.sequence() == sequence).findFirst();
  }
}
