package org.u2sa.scenarios.robosub.course;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.marine.Hoop;

/**
 * A floating ring to surface in, where the run ends.
 *
 * @param middle middle of the ring
 */
record RingTask(Point middle) implements CourseTask {
  static final String TYPE = "yellow hoop";
  static final double RADIUS_M = 1.37; // an octagon of 9 feet
  private static final double SURFACE_M = 0.3; // depth at which the hull breaks the surface

  @Override
  public List<ObjectDescription> objects() {
    Hoop ring = new Hoop().radius(RADIUS_M).thickness(0.08).lying(true).colour(Colour.YELLOW);
    return List.of(SubObjects.placed(ring, TYPE, middle));
  }

  @Override
  public List<Goal> goals() {
    return List.of(new Goal("surfaceInRing", "ring", List.of(TYPE)));
  }

  @Override
  public SubTaskJudge judge() {
    return new Judge();
  }

  private final class Judge implements SubTaskJudge {
    private double offM = Double.POSITIVE_INFINITY; // level distance from the middle
    private double downM;

    @Override
    public Optional<String> moved(Point from, Point to) {
      offM = Math.hypot(to.x() - middle.x(), to.y() - middle.y());
      downM = to.z();
      return Optional.empty();
    }

    private boolean isInside() {
      return downM < SURFACE_M && offM < RADIUS_M;
    }

    @Override
    public Optional<String> violation() {
      return isInside()
          ? Optional.empty()
          : Optional.of(
              String.format(
                  Locale.ROOT, "ring: ended %.2f m from its middle, %.2f m deep", offM, downM));
    }

    @Override
    public Map<String, Integer> counts() {
      return Map.of("surfacedInRing", isInside() ? 1 : 0);
    }

    @Override
    public Map<String, Double> figures() {
      return Map.of("metresFromRingsMiddle", offM);
    }
  }
}
