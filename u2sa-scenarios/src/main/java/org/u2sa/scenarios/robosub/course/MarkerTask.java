package org.u2sa.scenarios.robosub.course;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.marine.Colour;
import org.u2sa.messages.marine.PathMarker;

/**
 * A marker on the floor that points to the next task.
 *
 * @param name name of its goal and type
 * @param place position of its middle
 * @param headingRad its direction, clockwise from north
 */
record MarkerTask(String name, Point place, double headingRad) implements CourseTask {
  private static final double OVER_M = 1.0;

  @Override
  public List<ObjectDescription> objects() {
    PathMarker marker = new PathMarker().colour(Colour.ORANGE).length(1.2).width(0.15);
    marker.psi(Math.PI / 2.0 - headingRad);
    return List.of(SubObjects.placed(marker, name, place));
  }

  @Override
  public List<Goal> goals() {
    return List.of(new Goal("followMarker", name, List.of(name)));
  }

  @Override
  public SubTaskJudge judge() {
    return new Judge();
  }

  private final class Judge implements SubTaskJudge {
    private boolean isFollowed;

    @Override
    public Optional<String> moved(Point from, Point to) {
      isFollowed |= Math.hypot(to.x() - place.x(), to.y() - place.y()) < OVER_M;
      return Optional.empty();
    }

    @Override
    public Optional<String> violation() {
      return isFollowed ? Optional.empty() : Optional.of(name + ": never above the marker");
    }

    @Override
    public Map<String, Integer> counts() {
      return Map.of(name.replace(" path marker", "PathMarkerReached"), isFollowed ? 1 : 0);
    }
  }
}
