package org.u2sa.scenarios.robosub.course;

import java.util.Random;
import org.u2sa.messages.frame.Point;

/** The path along which a layout is arranged: a position and a heading, initially north. */
final class Walk {
  private final Random random;
  private Point place = Point.ORIGIN; // north, east of the start [m]
  private double headingRad; // clockwise from north

  Walk(Random random) {
    this.random = random;
  }

  double headingRad() {
    return headingRad;
  }

  /** Turns to the right by a random angle between two limits [rad]. */
  void turn(double least, double most) {
    headingRad += SubCourse.between(random, least, most);
  }

  /** Turns to the right or left by a random angle between two limits [rad]. */
  void turn(double least, double most, boolean isRight) {
    headingRad += (isRight ? 1.0 : -1.0) * SubCourse.between(random, least, most);
  }

  void to(Point next) {
    place = next;
  }

  /** Moves ahead by a random distance between two limits [m]. */
  void ahead(double least, double most) {
    place = at(SubCourse.between(random, least, most), 0.0, 0.0);
  }

  /** A position ahead and to the right of here, at the given depth [m]. */
  Point at(double aheadM, double rightM, double downM) {
    Point level = Point.of(place.x(), place.y(), downM);
    return level.plus(right(rightM)).plus(way(aheadM, headingRad));
  }

  /** A horizontal vector to the right [m]. */
  Point right(double distanceM) {
    return way(distanceM, headingRad + Math.PI / 2.0);
  }

  private static Point way(double distanceM, double towardsRad) {
    return Point.of(Math.cos(towardsRad), Math.sin(towardsRad), 0.0).times(distanceM);
  }
}
