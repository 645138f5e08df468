package org.u2sa.core.planning.seen;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.time.Clock;

/**
 * Remembers what moved: a thing that has stopped may set off again, onward or back to where it came
 * from. Belongs to the planner's thread.
 */
final class TrafficMemory {
  /** What stands longer counts as parked [µs]. */
  private static final long PARKED_AFTER_MICROS = 10 * Clock.MICROS_PER_SECOND;

  private record Motion(long micros, double northMps, double eastMps) {}

  private final Map<String, Motion> moved = new HashMap<>();

  /** Takes note that an object moves. */
  void moves(Mover mover) {
    moved.put(mover.name(), new Motion(mover.seenMicros(), mover.northMps(), mover.eastMps()));
  }

  /** How an object that stands may set off: on and back; nothing if it is parked. */
  List<Mover> mightMove(Mover standing) {
    Motion last = moved.get(standing.name());
    if (last == null || standing.seenMicros() - last.micros() > PARKED_AFTER_MICROS) {
      moved.remove(standing.name());
      return List.of();
    }
    return List.of(
        standing.moving(last.northMps(), last.eastMps()),
        standing.moving(-last.northMps(), -last.eastMps()));
  }
}
