package org.u2sa.planning.seen;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.interfaces.time.Clock;

/**
 * Remembers moving objects: one that has stopped may start again, forward or backward. Confined to
 * the planner's thread.
 */
final class TrafficMemory {
  /** Objects stationary for longer count as parked [µs]. */
  private static final long PARKED_AFTER_MICROS = 10 * Clock.MICROS_PER_SECOND;

  private static final int MAX_MOVERS = 1_000;

  /** Velocity at its fastest, and time of the last motion [µs]. */
  private record Motion(long micros, double northMps, double eastMps, long lastMicros) {
    double mps() {
      return Math.hypot(northMps, eastMps);
    }

    /** Adds an observation; its velocity counts only if faster or if the old one has expired. */
    Motion and(Motion now) {
      boolean isOld = now.micros - micros > PARKED_AFTER_MICROS;
      return isOld || now.mps() >= mps()
          ? now
          : new Motion(micros, northMps, eastMps, now.lastMicros);
    }
  }

  private final Map<String, Motion> moved = new HashMap<>();

  /** Records the fastest velocity of the last seconds: the estimate decays as an object stops. */
  void moves(Mover mover) {
    long seen = mover.seenMicros();
    if (moved.size() >= MAX_MOVERS && !moved.containsKey(mover.name())) {
      moved.values().removeIf(each -> Math.abs(seen - each.lastMicros()) > PARKED_AFTER_MICROS);
    }
    if (moved.size() >= MAX_MOVERS && !moved.containsKey(mover.name())) {
      return; // more than any real traffic: spoofed names
    }
    moved.merge(
        mover.name(), new Motion(seen, mover.northMps(), mover.eastMps(), seen), Motion::and);
  }

  /** Possible motions of a stationary object: forward and back; empty if it is parked. */
  List<Mover> mightMove(Mover standing) {
    Motion last = moved.get(standing.name());
    if (last == null || standing.seenMicros() - last.lastMicros() > PARKED_AFTER_MICROS) {
      moved.remove(standing.name());
      return List.of();
    }
    return List.of(
        standing.moving(last.northMps(), last.eastMps()),
        standing.moving(-last.northMps(), -last.eastMps()));
  }
}
