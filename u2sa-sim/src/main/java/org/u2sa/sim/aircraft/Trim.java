package org.u2sa.sim.aircraft;

/**
 * A trimmed flight condition of the Cessna 172 in still air: all accelerations are zero.
 *
 * @param altitudeM above mean sea level [m]
 * @param trueAirspeedMps [m/s]
 * @param rollRad right wing down positive [rad]
 * @param pitchRad nose up positive [rad]
 * @param flightPathRad positive for a climb [rad]
 * @param turnRateRadPerS of the heading, right positive [rad/s]
 * @param angleOfAttackRad [rad]
 * @param sideslipRad positive for airflow from the right [rad]
 * @param controls inputs that hold it
 * @param engineRpm [1/min]
 * @param shaftPowerW power absorbed by the propeller [W]
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
   * Straight and level flight; solves for throttle.
   *
   * @param flaps 0…1
   * @throws IllegalArgumentException if no such flight condition exists
   */
  public static Trim level(double altitudeM, double trueAirspeedMps, double flaps) {
    return new TrimSolver(altitudeM, trueAirspeedMps, 0.0, flaps).level();
  }

  /** Level coordinated turn at a bank angle [rad]; solves for throttle. */
  public static Trim turning(double altitudeM, double trueAirspeedMps, double rollRad) {
    return new TrimSolver(altitudeM, trueAirspeedMps, rollRad, 0.0).level();
  }

  /** Straight flight at a throttle 0…1; solves for climb or descent. */
  public static Trim atThrottle(
      double altitudeM, double trueAirspeedMps, double throttle, double flaps) {
    return new TrimSolver(altitudeM, trueAirspeedMps, 0.0, flaps).atThrottle(throttle);
  }

  /** Climb rate [m/s]. */
  public double climbMps() {
    return trueAirspeedMps * StrictMath.sin(flightPathRad);
  }

  /** Initial condition in this trim; a turn starts with its bank but without its rotation. */
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
