package org.u2sa.world.modeller;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.shape.ImageFootprint;
import org.u2sa.service.handover.HandOver;

/**
 * A representation of sensor data (thesis 3.2.3.3): a memory, an object map, a grid. Several may be
 * active at once. All methods are called on the World Modeler's thread, sightings in order of
 * measurement time.
 */
public interface Modeller {
  /**
   * Processes one sensor's detections at one time.
   *
   * @param seen detections as published, in any frame; frozen, at least one
   */
  default void objects(List<ObjectDescription> seen, Sighting sighting) {}

  default void scan(RangeScan scan, ScanPoses poses) {}

  /** Processes the ground shown by one image, in the frame of its message. */
  default void footprint(ImageFootprint seen) {}

  /** Processes the goals of the mission, current and upcoming. */
  default void goals(GoalList goals) {}

  /**
   * Replaces the a priori objects. Objects with a velocity move from the sighting's time on, which
   * may be in the past.
   */
  default void known(List<ObjectDescription> objects, Sighting since) {}

  /**
   * Whether {@link #objects(Sighting)} includes the objects passed to {@link #known}. If no active
   * modeller does, the World Modeler publishes them itself.
   */
  default boolean publishesKnown() {
    return false;
  }

  /**
   * Switches to another frame because the vehicle's pose has become known or was lost.
   *
   * @param now the vehicle's last known state, used for the conversion; empty if none
   */
  default void enter(MapFrame frame, Sighting now) {}

  /**
   * Current objects.
   *
   * @param now current time and vehicle state
   */
  default List<ObjectDescription> objects(Sighting now) {
    return List.of();
  }

  /** Current grid; empty if the modeller keeps no grid or has no data yet. */
  default Optional<OccupancyGrid> grid(Sighting now) {
    return Optional.empty();
  }

  /** Whether {@link #sensed} is needed. */
  default boolean needsSensedState() {
    return false;
  }

  /** Processes a proprioceptive measurement, such as rates and speeds. */
  default void sensed(StateInformation measured) {}

  /** Processes a dead-reckoned state of local-state, which never jumps. */
  default void local(StateInformation state) {}

  /**
   * Measurements of the vehicle's state that the map has yielded since the last call, with source
   * and time; the World Modeler publishes them on sensed-state.
   */
  default List<StateInformation> corrections() {
    return List.of();
  }

  /** Saves data to be kept; called when the World Modeler stops. */
  default void end() {}

  /** Counters, for the health report. */
  String remark();

  /** Saves this modeller's knowledge for its successor. */
  default void handOver(HandOver state, Sighting now) {}

  /** Restores the knowledge of its predecessor. */
  default void takeOver(HandOver state, Sighting now) {}
}
