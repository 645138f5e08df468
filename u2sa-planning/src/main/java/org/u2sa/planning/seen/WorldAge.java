package org.u2sa.planning.seen;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;

/**
 * Age of the planner's world data, and the sensors missing in it. If the World Modeler publishes
 * objects, they must be new: a grid, which has its own rate, does not replace them.
 */
public final class WorldAge {
  private long listMicros = Long.MIN_VALUE; // time of the newest list
  private long gridMicros = Long.MIN_VALUE;
  private List<String> awaited = List.of();

  void see(ObjectList list, long nowMicros) {
    listMicros = newer(listMicros, list.timestamp().orElse(nowMicros), nowMicros);
    awaited = list.awaited();
  }

  void see(OccupancyGrid grid, long nowMicros) {
    gridMicros = newer(gridMicros, grid.timestamp().orElse(nowMicros), nowMicros);
  }

  /** Retained messages are dated by their timestamps, and none is newer than its arrival. */
  private static long newer(long known, long micros, long nowMicros) {
    return Math.max(known, Math.min(micros, nowMicros));
  }

  public boolean isKnown() {
    return Math.max(listMicros, gridMicros) != Long.MIN_VALUE;
  }

  /**
   * Why the surroundings are unknown.
   *
   * @param staleMicros age from which objects, or a grid alone, are too old [µs]
   * @return empty if they are known
   */
  public Optional<String> trouble(long nowMicros, long staleMicros) {
    if (!isKnown()) {
      return Optional.of("neither objects nor a grid yet from the World Modeler");
    }
    long newestMicros = listMicros == Long.MIN_VALUE ? gridMicros : listMicros;
    if (nowMicros - newestMicros > staleMicros) {
      return Optional.of(
          String.format(
              Locale.ROOT,
              "no data from the World Modeler for more than %.1f s",
              Clock.seconds(staleMicros)));
    }
    return awaited.isEmpty()
        ? Optional.empty()
        : Optional.of("the World Modeler receives no data from " + String.join(", ", awaited));
  }
}
