package org.u2sa.sim.aircraft;

import org.u2sa.sim.atmosphere.StandardAtmosphere;

/**
 * A steady flight of the Cessna 172 in still air: every acceleration is zero.
 *
 * @param altitudeM above mean sea level [m]
 * @param trueAirspeedMps [m/s]
 * @param rollRad right wing down positive [rad]
 * @param pitchRad nose up positive [rad]
 * @param flightPathRad climbing positive [rad]
 * @param turnRateRadPerS of the heading, right positive [rad/s]
 * @param angleOfAttackRad [rad]
 * @param sideslipRad positive if the air comes from the right [rad]
 * @param controls that hold it
 * @param engineRpm [1/min]
 * @param shaftPowerW that the propeller takes [W]
 */
public record Trim(
    double altitudeM,
    double trueAirspeedMps,
    double rollRad,
    double pitchRad,
    double flightPathRad,
    double turnRateRadPerS,
    double angleOfAttackRad,
    double sideslipRad,
    ControlInputs controls,
    double engineRpm,
    double shaftPowerW) {

  /**
   * Straight and level: the throttle is found.
   *
   * @param flaps 0…1
   * @throws IllegalArgumentException if the aircraft cannot fly so
   */
  public static Trim level(double altitudeM, double trueAirspeedMps, double flaps) {
    return new TrimSolver(altitudeM, trueAirspeedMps, 0.0, flaps).level();
  }

  /** Level in a coordinated turn of a bank [rad]: the throttle is found. */
  public static Trim turning(double altitudeM, double trueAirspeedMps, double rollRad) {
    return new TrimSolver(altitudeM, trueAirspeedMps, rollRad, 0.0).level();
  }

  /** Straight at a throttle 0…1: the climb or descent is found. */
  public static Trim atThrottle(
      double altitudeM, double trueAirspeedMps, double throttle, double flaps) {
    return new TrimSolver(altitudeM, trueAirspeedMps, 0.0, flaps).atThrottle(throttle);
  }

  /** Speed upwards [m/s]. */
  public double climbMps() {
    return trueAirspeedMps * StrictMath.sin(flightPathRad);
  }

  /** Calibrated airspeed [m/s]. */
  public double calibratedAirspeedMps() {
    return StandardAtmosphere.at(altitudeM).calibratedAirspeedMps(trueAirspeedMps);
  }

  /** A start in this flight; a turning one begins with its bank but without its rotation. */
  public FlightStart start(
      double longitudeDeg, double latitudeDeg, double groundElevationM, double headingRad) {
    return new FlightStart(
        longitudeDeg,
        latitudeDeg,
        altitudeM,
        groundElevationM,
        headingRad,
        trueAirspeedMps,
        angleOfAttackRad,
        sideslipRad,
        rollRad,
        pitchRad,
        engineRpm,
        controls.flaps());
  }
}
