package org.u2sa.planning.seen;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;

/** Age of the planner's world data, and the sensors missing in it. */
public final class WorldAge {
  private long newestMicros = Long.MIN_VALUE; // time of the newest list or grid
  private List<String> awaited = List.of();

  void see(ObjectList list, long nowMicros) {
    seen(list.timestamp().orElse(nowMicros), nowMicros);
    awaited = list.awaited();
  }

  void see(OccupancyGrid grid, long nowMicros) {
    seen(grid.timestamp().orElse(nowMicros), nowMicros);
  }

  /** Retained messages are dated by their timestamps, and none is newer than its arrival. */
  private void seen(long micros, long nowMicros) {
    newestMicros = Math.max(newestMicros, Math.min(micros, nowMicros));
  }

  public boolean isKnown() {
    return newestMicros != Long.MIN_VALUE;
  }

  /**
   * Why the surroundings are unknown.
   *
   * @param staleMicros age from which a list or grid is too old [µs]
   * @return empty if they are known
   */
  public Optional<String> trouble(long nowMicros, long staleMicros) {
    if (!isKnown()) {
      return Optional.of("neither objects nor a grid yet from the World Modeler");
    }
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
