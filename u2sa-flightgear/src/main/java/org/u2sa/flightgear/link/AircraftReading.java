package org.u2sa.flightgear.link;

/**
 * One reading of a simulated aircraft, in SI units and radians.
 *
 * @param connected whether the aircraft is there; if not, the other values are the last known ones
 * @param sequence counts readings, so that a new one is told from one read before; 0 if there was
 *     none yet
 * @param measuredAtMicros when it was measured, by the run's clock [µs]
 * @param longitudeDeg WGS-84 [°], east positive
 * @param latitudeDeg WGS-84 geodetic [°], north positive
 * @param altitudeM reference point above mean sea level [m]
 * @param heightAboveGroundM height above where the aircraft stands on its wheels [m]
 * @param rollRad right wing down positive [rad]
 * @param pitchRad nose up positive [rad]
 * @param headingRad true [rad, 0…2π)
 * @param rollRateRadPerS rate of the roll angle (Euler) [rad/s]
 * @param pitchRateRadPerS rate of the pitch angle (Euler) [rad/s]
 * @param headingRateRadPerS rate of the heading (Euler), right turn positive [rad/s]
 * @param northMps velocity over ground [m/s]
 * @param eastMps velocity over ground [m/s]
 * @param upMps velocity [m/s]
 * @param airForwardMps velocity through the air along the aircraft's axis to the front [m/s]
 * @param airLeftMps velocity through the air along the axis to the left [m/s]
 * @param airDownMps velocity through the air along the axis to the bottom [m/s]
 * @param calibratedAirspeedMps [m/s]
 * @param engineRpm [1/min]
 * @param weightOnWheels whether a main wheel carries load
 * @param engineStarting whether the engine is still being started: then it dies unless the throttle
 *     is between 0.1 and 0.5
 * @param crashed whether the simulator says so
 */
public record AircraftReading(
    boolean connected,
    long sequence,
    long measuredAtMicros,
    double longitudeDeg,
    double latitudeDeg,
    double altitudeM,
    double heightAboveGroundM,
    double rollRad,
    double pitchRad,
    double headingRad,
    double rollRateRadPerS,
    double pitchRateRadPerS,
    double headingRateRadPerS,
    double northMps,
    double eastMps,
    double upMps,
    double airForwardMps,
    double airLeftMps,
    double airDownMps,
    double calibratedAirspeedMps,
    double engineRpm,
    boolean weightOnWheels,
    boolean engineStarting,
    boolean crashed) {

  /** No reading yet. */
  public static AircraftReading none() {
    return new AircraftReading(
        false, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, false, false, false);
  }
}
