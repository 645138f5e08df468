package org.u2sa.sim.aircraft;

/**
 * Where an aircraft stands on its wheels.
 *
 * @param longitudeDeg WGS-84 [°, −180…180]
 * @param latitudeDeg WGS-84 [°, −85…85]
 * @param elevationM of the ground above mean sea level [m, −500…5000]
 * @param headingRad true heading of the nose [rad]
 */
public record RunwayStart(
    double longitudeDeg, double latitudeDeg, double elevationM, double headingRad) {

  /**
   * @throws IllegalArgumentException if a value is not a number or outside its range
   */
  public RunwayStart {
    Arguments.requireInside("start longitude [deg]", longitudeDeg, -180.0, 180.0);
    Arguments.requireInside("start latitude [deg]", latitudeDeg, -85.0, 85.0);
    Arguments.requireInside("start elevation [m]", elevationM, -500.0, 5_000.0);
    Arguments.requireInside("start heading [rad]", headingRad, -10.0, 10.0);
  }
}
