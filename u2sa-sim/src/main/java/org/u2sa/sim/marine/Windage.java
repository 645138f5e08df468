package org.u2sa.sim.marine;

import org.u2sa.messages.frame.Point;

/**
 * Force of the wind on a vessel: X = c_x u|u|, Y = c_y v|v|, N = −2 c_n u v, with the wind relative
 * to the vessel, u forward and v to the right (Sarda et al., Ocean Engineering 127, 2016, after
 * Fossen 1994, section 3.4.1).
 *
 * @param ahead c_x: ½ ρ C_x A of the area seen from ahead [kg/m]
 * @param aside c_y: likewise from the side [kg/m]
 * @param turning c_n [kg]; positive: the bow turns out of the wind
 * @param axes axes in which the products are taken
 * @param heightM height of the area's centre above the water [m]
 */
public record Windage(double ahead, double aside, double turning, Axes axes, double heightM) {
  /** Axes of the products. */
  public enum Axes {
    /** Forward, right, down. */
    BODY,
    /** East, north, up, as in VRX; the moment is then the same at every heading. */
    WORLD
  }

  /**
   * Force and moment: X, Y [N], N [N m].
   *
   * @param northMps relative wind, northward [m/s]
   * @param eastMps relative wind, eastward [m/s]
   */
  Point on(double headingRad, double northMps, double eastMps) {
    double cos = StrictMath.cos(headingRad);
    double sin = StrictMath.sin(headingRad);
    if (axes == Axes.BODY) {
      double u = northMps * cos + eastMps * sin;
      double v = eastMps * cos - northMps * sin;
      return Point.of(
          ahead * u * StrictMath.abs(u), aside * v * StrictMath.abs(v), -2.0 * turning * u * v);
    }
    double east = ahead * eastMps * StrictMath.abs(eastMps);
    double north = aside * northMps * StrictMath.abs(northMps);
    return Point.of(
        north * cos + east * sin,
        east * cos - north * sin,
        2.0 * turning * eastMps * northMps); // about up: −2 c_n; down has the opposite sign
  }
}
