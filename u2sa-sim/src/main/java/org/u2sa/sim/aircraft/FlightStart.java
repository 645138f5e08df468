package org.u2sa.sim.aircraft;

import org.u2sa.sim.motion.Arguments;

/**
 * Initial condition of an airborne aircraft, without rotation and not necessarily trimmed; {@link
 * Trim} finds trimmed ones.
 *
 * @param longitudeDeg WGS-84 [°, −180…180]
 * @param latitudeDeg WGS-84 [°, −85…85]
 * @param altitudeM centre of gravity above mean sea level [m, −500…10000]
 * @param groundElevationM ground elevation [m], below the altitude
 * @param headingRad true heading of the nose [rad]
 * @param trueAirspeedMps [m/s, 0…120]
 * @param angleOfAttackRad [rad, −π…π]
 * @param sideslipRad positive for airflow from the right [rad, −π/2…π/2]
 * @param rollRad right wing down positive [rad, −π…π]
 * @param pitchRad nose up positive [rad, −π/2…π/2]
 * @param engineRpm 0 is a stopped engine [1/min, 0…3500]
 * @param flaps flap position, 0 (up) … 1 (30°)
 */
public record FlightStart(
    double longitudeDeg,
    double latitudeDeg,
    double altitudeM,
    double groundElevationM,
    double headingRad,
    double trueAirspeedMps,
    double angleOfAttackRad,
    double sideslipRad,
    double rollRad,
    double pitchRad,
    double engineRpm,
    double flaps) {

  /**
   * @throws IllegalArgumentException if a value is not a number or outside its range
   */
  public FlightStart {
    Arguments.requireInside("start longitude [deg]", longitudeDeg, -180.0, 180.0);
    Arguments.requireInside("start latitude [deg]", latitudeDeg, -85.0, 85.0);
    Arguments.requireInside("start altitude [m]", altitudeM, -500.0, 10_000.0);
    Arguments.requireInside("ground elevation [m]", groundElevationM, -500.0, altitudeM);
    Arguments.requireInside("start heading [rad]", headingRad, -10.0, 10.0);
    Arguments.requireInside("start airspeed [m/s]", trueAirspeedMps, 0.0, 120.0);
    Arguments.requireInside("start angle of attack [rad]", angleOfAttackRad, -Math.PI, Math.PI);
    Arguments.requireInside("start sideslip [rad]", sideslipRad, -Math.PI / 2, Math.PI / 2);
    Arguments.requireInside("start roll [rad]", rollRad, -Math.PI, Math.PI);
    Arguments.requireInside("start pitch [rad]", pitchRad, -Math.PI / 2, Math.PI / 2);
    Arguments.requireInside("start engine speed [1/min]", engineRpm, 0.0, 3_500.0);
    Arguments.requireInside("start flaps", flaps, 0.0, 1.0);
  }
}
