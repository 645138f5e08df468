package org.u2sa.planning.payload;

import java.util.Optional;
import java.util.function.Predicate;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.guidance.Leg;
import org.u2sa.planning.guidance.Place;
import org.u2sa.planning.guidance.Vehicle;

/**
 * Straight way on which an aeroplane comes to a drop, with as much room behind the drop to turn
 * back: so that neither leads among high ground.
 *
 * @param begin where it begins, at the altitude to be flown
 * @param courseRad course on it [rad]
 * @param lengthM its length [m]
 */
public record RunIn(Place begin, double courseRad, double lengthM) {
  private static final int DIRECTIONS = 8;
  private static final double NEAR = 0.25; // of the length
  private static final double ALIGNED_RAD = Math.toRadians(30.0);

  /**
   * Chooses a free way, by the difference of its course from a wanted one.
   *
   * @param aim where it leads to, at the altitude to be flown
   * @param courseRad wanted course [rad]
   * @param lengthM its length, and that of the way behind the aim [m]
   * @param isBlocked whether ground is too high for the straight and level way from the aim to a
   *     place
   * @param skipped number of free ways to leave out, which were tried before
   * @return empty if no other is free
   */
  public static Optional<RunIn> to(
      Place aim, double courseRad, double lengthM, Predicate<Place> isBlocked, int skipped) {
    int free = 0;
    for (int i = 0; i < DIRECTIONS; i++) {
      int side = i % 2 == 0 ? 1 : -1;
      double course = Leg.wrapped(courseRad + side * ((i + 1) / 2) * 2.0 * Math.PI / DIRECTIONS);
      double north = lengthM * Math.cos(course);
      double east = lengthM * Math.sin(course);
      Place begin = aim.moved(-north, -east);
      boolean isFree = !isBlocked.test(begin) && !isBlocked.test(aim.moved(north, east));
      if (isFree && free++ == skipped) {
        return Optional.of(new RunIn(begin, course, lengthM));
      }
    }
    return Optional.empty();
  }

  /** Whether a vehicle is about to fly it. */
  public boolean isReached(Vehicle vehicle) {
    Point to = vehicle.nedOf(begin);
    double off = Leg.wrapped(vehicle.courseRad() - courseRad);
    return Math.hypot(to.x(), to.y()) < NEAR * lengthM && Math.abs(off) < ALIGNED_RAD;
  }
}
