package org.u2sa.scenarios.roboboat.gate;

import org.u2sa.messages.frame.Point;

/**
 * The line through the middle of a gate to the next one, on a level plane with axes north and east
 * [m].
 *
 * @param from start of the line
 * @param over middle of the gate
 * @param to position beyond it
 */
public record GateLine(Point from, Point over, Point to) {
  private static final double MIN_LENGTH_M = 1.0e-6; // length of a segment

  /** Distance from the segment to the gate, positive to the right [m]. */
  public double asideM(Point here) {
    double length = lengthM();
    double north = (over.x() - from.x()) / length;
    double east = (over.y() - from.y()) / length;
    return (here.y() - from.y()) * north - (here.x() - from.x()) * east;
  }

  private double lengthM() {
    return Math.max(MIN_LENGTH_M, from.flatDistanceTo(over));
  }

  /** Point at a distance ahead of a boat that is abreast of the segment to the gate. */
  public Point ahead(Point here, double metres) {
    double length = lengthM();
    double along =
        ((here.x() - from.x()) * (over.x() - from.x())
                + (here.y() - from.y()) * (over.y() - from.y()))
            / length;
    double reached = along + metres;
    return reached <= length
        ? between(from, over, reached / length)
        : between(over, to, (reached - length) / Math.max(MIN_LENGTH_M, over.flatDistanceTo(to)));
  }

  /** Position between two others, or beyond them. */
  public static Point between(Point from, Point to, double share) {
    return Point.of(
        from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()), 0.0);
  }
}
