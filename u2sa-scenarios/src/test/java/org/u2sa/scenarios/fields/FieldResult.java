package org.u2sa.scenarios.fields;

import java.util.List;

/**
 * How a vehicle did in a field.
 *
 * @param reached whether the goal was reported reached, and the vehicle was there
 * @param reason why the goal was given up; empty if it was not
 * @param contacts what was touched
 * @param simS simulated time [s]
 * @param track where the vehicle was: east, north [m]
 */
record FieldResult(
    boolean reached, String reason, List<String> contacts, double simS, List<double[]> track) {
  boolean gaveUp() {
    return !reason.isEmpty();
  }
}
