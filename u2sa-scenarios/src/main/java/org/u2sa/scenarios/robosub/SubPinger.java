package org.u2sa.scenarios.robosub;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.marine.Hoop;

/**
 * The pinger on the ground below a layout's ring, and a second ring without one (thesis 4.3).
 * Places are north, east and down of the start [m].
 */
record SubPinger(Point pinger, Point otherRing) {
  private static final double POOL_M = 4.5; // depth

  /** That of a seed's layout. */
  static SubPinger of(long seed, SubCourse course) {
    Random random = new Random(seed * 0x9E3779B97F4A7C15L + 1);
    double side = random.nextBoolean() ? 1.0 : -1.0;
    Point aside =
        Point.of(3.0 * (random.nextDouble() - 0.5), side * (4.0 + random.nextDouble()), 0.0);
    return new SubPinger(
        Point.of(course.ring().x(), course.ring().y(), POOL_M), course.ring().plus(aside));
  }

  /** The second ring, as the world's object. */
  List<ObjectDescription> objects() {
    String type = SubCourse.type(Colour.YELLOW, "hoop");
    Hoop ring = new Hoop().radius(SubCourse.RING_M).thickness(0.08).lying(true);
    ring.colour(Colour.YELLOW)
        .uid("other " + type)
        .objectType(type)
        .referenceFrame(ReferenceFrame.LOCAL_ENU)
        .x(otherRing.y())
        .y(otherRing.x())
        .z(-otherRing.z())
        .level(ObjectLevel.AVOID_ALWAYS);
    ring.freeze();
    return List.of(ring);
  }

  /** Changes of the vehicle file, whose hydrophones hear the pinger. */
  Map<String, String> changes() {
    String place = String.format(Locale.ROOT, "%.3f %.3f %.3f", pinger.y(), pinger.x(), -pinger.z());
    return Map.of("hydrophones/pinger", place);
  }
}
