package org.u2sa.world.modeller;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.service.HandOver;

/**
 * One way to keep what sensors saw (thesis 3.2.3.3): a memory, a map of objects, a grid. Several
 * may work side by side. Everything is called on the World Modeler's thread, sightings in the order
 * of their measurement.
 */
public interface Modeller {
  /**
   * Takes what one sensor saw at one moment.
   *
   * @param seen as the sensor published it, in whatever frame; frozen, at least one
   */
  default void objects(List<ObjectDescription> seen, Sighting sighting) {}

  /** Takes one scan. */
  default void scan(RangeScan scan, ScanPoses poses) {}

  /**
   * Takes what is known beforehand, in place of what was known so before. What has a velocity moves
   * from the sighting's time on, which may have passed.
   */
  default void known(List<ObjectDescription> objects, Sighting since) {}

  /**
   * Whether {@link #objects(Sighting)} contains what {@link #known} got. If no modeller at work
   * does so, the World Modeler publishes it itself.
   */
  default boolean publishesKnown() {
    return false;
  }

  /**
   * Goes on in another frame: the vehicle has learnt where it is, or knows it no longer.
   *
   * @param now the vehicle's last known state, to carry over by; empty: there was none
   */
  default void enter(MapFrame frame, Sighting now) {}

  /**
   * The objects as they are now.
   *
   * @param now the time, and where the vehicle is
   */
  default List<ObjectDescription> objects(Sighting now) {
    return List.of();
  }

  /** The grid as it is now; empty from modellers that keep none, or nothing yet. */
  default Optional<OccupancyGrid> grid(Sighting now) {
    return Optional.empty();
  }

  /** Counters, for the health report. */
  String remark();

  /** Tells another modeller what this one knows. */
  default void handOver(HandOver state, Sighting now) {}

  /** Takes over what another one knew. */
  default void takeOver(HandOver state, Sighting now) {}
}
