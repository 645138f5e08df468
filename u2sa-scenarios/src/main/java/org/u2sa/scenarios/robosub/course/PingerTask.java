package org.u2sa.scenarios.robosub.course;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.marine.Hoop;

/**
 * A pinger on the floor below the ring to surface in, with a second ring beside it as a decoy
 * (thesis 4.3).
 *
 * @param pinger position of the pinger
 * @param otherRing middle of the ring without pinger
 */
public record PingerTask(Point pinger, Point otherRing) implements CourseTask {
  /** The task of a seed's layout. */
  static PingerTask below(Point ring, long seed) {
    Random random = new Random(seed * 0x9E3779B97F4A7C15L + 1);
    double side = random.nextBoolean() ? 1.0 : -1.0;
    Point aside =
        Point.of(3.0 * (random.nextDouble() - 0.5), side * (4.0 + random.nextDouble()), 0.0);
    return new PingerTask(Point.of(ring.x(), ring.y(), SubCourse.FLOOR_M), ring.plus(aside));
  }

  /** Changes of the vehicle file for a layout, so that its hydrophones hear the pinger. */
  public static Map<String, String> changes(SubCourse course) {
    return course.tasks().stream()
        .filter(PingerTask.class::isInstance)
        .map(task -> ((PingerTask) task).pinger)
        .findFirst()
        .map(at -> String.format(Locale.ROOT, "%.3f %.3f %.3f", at.y(), at.x(), -at.z()))
        .map(place -> Map.of("hydrophones/pinger", place))
        .orElse(Map.of());
  }

  @Override
  public List<ObjectDescription> objects() {
    Hoop ring =
        new Hoop().radius(RingTask.RADIUS_M).thickness(0.08).lying(true).colour(Colour.YELLOW);
    ObjectDescription other = SubObjects.placed(ring, RingTask.TYPE, otherRing).copy();
    other.uid("other " + RingTask.TYPE);
    other.freeze();
    return List.of(other);
  }

  @Override
  public List<Goal> goals() {
    return List.of(new Goal("homeOnPinger", "pinger", List.of("pinger")));
  }

  @Override
  public SubTaskJudge judge() {
    return new Judge();
  }

  private final class Judge implements SubTaskJudge {
    private double nearestM = Double.POSITIVE_INFINITY; // level distance

    @Override
    public Optional<String> moved(Point from, Point to) {
      nearestM = Math.min(nearestM, Math.hypot(to.x() - pinger.x(), to.y() - pinger.y()));
      return Optional.empty();
    }

    private boolean isReached() {
      return nearestM < RingTask.RADIUS_M;
    }

    @Override
    public Optional<String> violation() {
      String off = String.format(Locale.ROOT, "pinger: came no nearer than %.2f m", nearestM);
      return isReached() ? Optional.empty() : Optional.of(off);
    }

    @Override
    public Map<String, Integer> counts() {
      return Map.of("pingersReached", isReached() ? 1 : 0);
    }
  }
}
