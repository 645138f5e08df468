package org.u2sa.scenarios.report;

import java.util.OptionalDouble;

/**
 * A waypoint as the mission wants it.
 *
 * @param name shown in tables and pictures
 * @param longitudeDeg longitude, WGS-84 [deg]
 * @param latitudeDeg latitude, WGS-84 [deg]
 * @param altitudeM altitude above mean sea level [m]; empty: any
 * @param captureRadiusM horizontal distance within which it counts as reached [m], more than 0
 * @param verticalThresholdM vertical distance within which it counts as reached [m]; empty: any
 */
public record PlannedWaypoint(
    String name,
    double longitudeDeg,
    double latitudeDeg,
    OptionalDouble altitudeM,
    double captureRadiusM,
    OptionalDouble verticalThresholdM) {

  /**
   * @throws IllegalArgumentException if the capture radius is not a positive number
   */
  public PlannedWaypoint {
    if (!(captureRadiusM > 0.0) || Double.isInfinite(captureRadiusM)) {
      throw new IllegalArgumentException(
          "captureRadiusM of " + name + ": " + captureRadiusM + ", expected more than 0 m");
    }
  }
}
