package org.u2sa.planning.curve;

/**
 * Position and heading on a horizontal plane. Immutable.
 *
 * @param northM north [m]
 * @param eastM east [m]
 * @param headingRad clockwise from north [rad]
 */
public record Pose(double northM, double eastM, double headingRad) {
  /** The pose after an arc: positive curvature turns right, negative length reverses. */
  public Pose along(double lengthM, double curvature) {
    double turned = lengthM * curvature;
    if (Math.abs(turned) < 1.0e-9) {
      return new Pose(
          northM + lengthM * Math.cos(headingRad),
          eastM + lengthM * Math.sin(headingRad),
          headingRad + turned);
    }
    double after = headingRad + turned;
    return new Pose(
        northM + (Math.sin(after) - Math.sin(headingRad)) / curvature,
        eastM - (Math.cos(after) - Math.cos(headingRad)) / curvature,
        wrapped(after));
  }

  /** Another pose relative to this one: x ahead, y to the right, relative heading. */
  Pose relative(Pose other) {
    double north = other.northM - northM;
    double east = other.eastM - eastM;
    double cos = Math.cos(headingRad);
    double sin = Math.sin(headingRad);
    return new Pose(
        north * cos + east * sin, east * cos - north * sin, wrapped(other.headingRad - headingRad));
  }

  /** Distance to a point [m]. */
  public double distanceM(double north, double east) {
    return Math.hypot(north - northM, east - eastM);
  }

  /** Wraps an angle to −π…π [rad]. */
  public static double wrapped(double rad) {
    // avoids the expensive remainder within half a turn
    return rad > -Math.PI && rad < Math.PI ? rad : Math.IEEEremainder(rad, 2.0 * Math.PI);
  }
}
