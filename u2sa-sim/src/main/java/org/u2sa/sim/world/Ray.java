package org.u2sa.sim.world;

import org.u2sa.messages.frame.Point;

/**
 * A half-line in the world's axes, east, north, up [m]; the direction has length 1.
 *
 * @param x where it starts, east [m]
 * @param y north [m]
 * @param z up [m]
 * @param dx direction, east
 * @param dy north
 * @param dz up
 */
public record Ray(double x, double y, double z, double dx, double dy, double dz) {
  private static final double UNIT = 1e-9;

  /**
   * @throws IllegalArgumentException if the direction has not the length 1, or the start is no
   *     place
   */
  public Ray {
    if (!(Math.abs(dx * dx + dy * dy + dz * dz - 1.0) < UNIT) || !Double.isFinite(x + y + z)) {
      throw new IllegalArgumentException(
          String.format(
              "ray from (%s, %s, %s) along (%s, %s, %s): expected a place and a direction of length 1",
              x, y, z, dx, dy, dz));
    }
  }

  /**
   * A ray by its azimuth, clockwise from north, and its elevation above the horizon [rad].
   *
   * @param from east, north, up [m]
   */
  public static Ray of(Point from, double azimuthRad, double elevationRad) {
    double flat = StrictMath.cos(elevationRad);
    return new Ray(
        from.x(),
        from.y(),
        from.z(),
        flat * StrictMath.sin(azimuthRad),
        flat * StrictMath.cos(azimuthRad),
        StrictMath.sin(elevationRad));
  }

  /** The point at a distance from its start. */
  public Point at(double distanceM) {
    return Point.of(x + distanceM * dx, y + distanceM * dy, z + distanceM * dz);
  }
}
