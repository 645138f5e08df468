package org.u2sa.planning.payload;

import java.util.OptionalDouble;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;

/**
 * Fall of a compact payload in steady wind, with drag proportional to the square of its airspeed: a
 * = g − g |v| v / v∞², v through the air, v∞ the terminal speed.
 *
 * @param timeS time until it reaches the ground [s]
 * @param way displacement over ground: north, east, down [m]
 */
public record Fall(double timeS, Point way) {
  private static final double STEP_S = 0.02;
  private static final double LONGEST_S = 120.0;

  /**
   * Computes the fall from a height, by the midpoint rule.
   *
   * @param heightM above the ground [m]
   * @param velocity over ground at the release: north, east, down [m/s]
   * @param wind over ground: north, east, down [m/s]
   */
  public static Fall from(double heightM, Point velocity, Point wind, OptionalDouble terminalMps) {
    double drag =
        terminalMps.isPresent()
            ? Gravity.STANDARD_MPS2 / (terminalMps.getAsDouble() * terminalMps.getAsDouble())
            : 0.0;
    Point v = velocity;
    Point way = Point.ORIGIN;
    double timeS = 0.0;
    while (way.z() < heightM && timeS < LONGEST_S) {
      Point middle = v.plus(acceleration(v, wind, drag).times(STEP_S / 2.0));
      Point step = middle.times(STEP_S);
      double share =
          way.z() + step.z() > heightM ? (heightM - way.z()) / Math.max(1e-9, step.z()) : 1.0;
      way = way.plus(step.times(share));
      timeS += share * STEP_S;
      v = v.plus(acceleration(middle, wind, drag).times(STEP_S));
      if (share < 1.0) {
        break;
      }
    }
    return new Fall(timeS, way);
  }

  private static Point acceleration(Point v, Point wind, double drag) {
    Point air = v.minus(wind);
    return Point.of(0.0, 0.0, Gravity.STANDARD_MPS2).minus(air.times(drag * air.distance()));
  }
}
