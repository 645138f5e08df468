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

  /**
   * Curvature of the arc to a point, tangent to the heading [1/m], right positive; the tightest if
   * the point is on the wrong side (Coulter, CMU-RI-TR-92-01: 2 y / L²).
   *
   * @param tightest maximum curvature [1/m]
   * @param backwards whether it reverses to the point
   */
  public double curvatureTo(double north, double east, double tightest, boolean backwards) {
    double dn = north - northM;
    double de = east - eastM;
    double right = de * Math.cos(headingRad) - dn * Math.sin(headingRad);
    double ahead = dn * Math.cos(headingRad) + de * Math.sin(headingRad);
    double square = dn * dn + de * de;
    if (square < 1.0e-6) {
      return 0.0;
    }
    boolean wrongSide = backwards ? ahead > 0.0 : ahead < 0.0;
    double wanted = wrongSide ? Math.copySign(tightest, right) : 2.0 * right / square;
    return Math.max(-tightest, Math.min(tightest, wanted));
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
