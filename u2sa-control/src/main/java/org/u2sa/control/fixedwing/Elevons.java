package org.u2sa.control.fixedwing;

import java.util.Map;
import org.u2sa.control.fixedwing.law.Limit;

/**
 * Elevons of a flying wing: trailing edges that move together as an elevator and against each other
 * as ailerons. A positive command lowers the trailing edge.
 */
final class Elevons {
  static final String LEFT = "LEFT ELEVON";
  static final String RIGHT = "RIGHT ELEVON";

  private Elevons() {}

  /** Command of the left one, −1…1. */
  static double left(Surfaces surfaces) {
    return Limit.symmetric(surfaces.elevator() + surfaces.aileron(), 1.0);
  }

  /** Command of the right one, −1…1. */
  static double right(Surfaces surfaces) {
    return Limit.symmetric(surfaces.elevator() - surfaces.aileron(), 1.0);
  }

  /** The aileron that two commands mean. */
  static double aileron(double left, double right) {
    return (left - right) / 2.0;
  }

  /** The elevator that two commands mean. */
  static double elevator(double left, double right) {
    return (left + right) / 2.0;
  }

  /** Replaces elevator and aileron in neutral commands [%]. */
  static void replace(Map<String, Double> neutral) {
    double elevator = neutral.remove(AircraftActuator.ELEVATOR.actuatorName());
    neutral.remove(AircraftActuator.AILERON.actuatorName());
    neutral.put(LEFT, elevator);
    neutral.put(RIGHT, elevator);
  }
}
