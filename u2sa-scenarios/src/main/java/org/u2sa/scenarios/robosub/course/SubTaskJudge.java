package org.u2sa.scenarios.robosub.course;

import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

/**
 * Scores one task of a run by ground truth. Positions are north, east and down from the start [m];
 * text returned for an event is logged.
 */
public interface SubTaskJudge {
  /** The vehicle's centre moved. */
  default Optional<String> moved(Point from, Point to) {
    return Optional.empty();
  }

  /** The vehicle touched an object. */
  default void touched(String uid) {}

  /** Called when a mechanism of the vehicle has released its load. */
  default Optional<String> released(String actuator, VehicleTruth truth) {
    return Optional.empty();
  }

  /** Unfinished part of the task at the end of the run; empty if the task is done. */
  Optional<String> violation();

  /** Its lines of the score sheet. */
  Map<String, Integer> counts();

  /** Other metrics of the task. */
  default Map<String, Double> figures() {
    return Map.of();
  }
}
