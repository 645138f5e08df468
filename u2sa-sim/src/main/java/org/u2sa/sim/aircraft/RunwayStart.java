package org.u2sa.sim.aircraft;

import org.u2sa.sim.motion.Arguments;

/**
 * Initial position of an aircraft on its wheels.
 *
 * @param longitudeDeg WGS-84 [°, −180…180]
 * @param latitudeDeg WGS-84 [°, −85…85]
 * @param elevationM ground elevation above mean sea level [m, −500…5000]
 * @param headingRad true heading of the nose [rad]
 */
public record RunwayStart(
    double longitudeDeg, double latitudeDeg, double elevationM, double headingRad) {

  /** Maximum start latitude, north or south [deg]. */
  public static final double NORTHERNMOST_DEG = 85.0;

  /** Lowest ground elevation [m]. */
  public static final double LOWEST_M = -500.0;

  /** Highest ground elevation [m]. */
  public static final double HIGHEST_M = 5_000.0;

  /**
   * @throws IllegalArgumentException if a value is not a number or outside its range
   */
  public RunwayStart {
    Arguments.requireInside("start longitude [deg]", longitudeDeg, -180.0, 180.0);
    Arguments.requireInside(
        "start latitude [deg]", latitudeDeg, -NORTHERNMOST_DEG, NORTHERNMOST_DEG);
    Arguments.requireInside("start elevation [m]", elevationM, LOWEST_M, HIGHEST_M);
    Arguments.requireInside("start heading [rad]", headingRad, -10.0, 10.0);
  }
}
