package org.u2sa.scenarios.fields;

import java.util.List;

/**
 * How a vehicle did in a field.
 *
 * @param reached whether the goal was reported reached, and the vehicle was there
 * @param reason why the goal was given up; empty if it was not
 * @param contacts what the vehicle drove or flew into
 * @param touchedBy traffic that came on and touched it while it stood or backed off
 * @param simS simulated time [s]
 * @param track where the vehicle was: east, north [m]
 */
record FieldResult(
    boolean reached,
    String reason,
    List<String> contacts,
    List<String> touchedBy,
    double simS,
    List<double[]> track) {
  boolean gaveUp() {
    return !reason.isEmpty();
  }
}
