package org.u2sa.sim.world;

import org.u2sa.messages.frame.Point;

/**
 * A ray in world axes (east, north, up [m]) with a unit direction.
 *
 * @param x origin, east [m]
 * @param y origin, north [m]
 * @param z origin, up [m]
 * @param dx direction, east
 * @param dy direction, north
 * @param dz direction, up
 */
public record Ray(double x, double y, double z, double dx, double dy, double dz) {
  private static final double UNIT = 1e-9;

  /**
   * @throws IllegalArgumentException if the direction is not a unit vector or the origin is not
   *     finite
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
   * A ray given by azimuth, clockwise from north, and elevation above the horizon [rad].
   *
   * @param from origin: east, north, up [m]
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

  /** The point at a distance along the ray. */
  public Point at(double distanceM) {
    return Point.of(x + distanceM * dx, y + distanceM * dy, z + distanceM * dz);
  }
}
