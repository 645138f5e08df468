package org.u2sa.mission.returning;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.safety.FenceState;

/** Determines where the vehicle returns to: its home or a rally point, whichever is nearest. */
public final class ReturnPlaces {
  private final Supplier<Optional<Waypoint>> home;
  private final ReturnWay way = new ReturnWay();
  private List<GoalInformation> rally = List.of();
  private StateInformation state; // null until a position is received

  /**
   * @param home home of the mission
   */
  public ReturnPlaces(Supplier<Optional<Waypoint>> home) {
    this.home = home;
  }

  public void see(FenceState fence) {
    rally = fence.rally();
    way.see(fence);
  }

  public void see(StateInformation now) {
    state = now.x().isPresent() && now.y().isPresent() ? now : state;
  }

  /**
   * Nearest place; the home if the vehicle's position is unknown, empty if no place exists.
   *
   * @param thresholdM horizontal threshold [m]
   */
  public Optional<Waypoint> nearest(double thresholdM) {
    List<Waypoint> places = new ArrayList<>();
    home.get().ifPresent(places::add);
    for (GoalInformation goal : rally) {
      if (goal instanceof Waypoint point) {
        Waypoint place = point.copy();
        places.add(place.horizontalThreshold(thresholdM));
      }
    }
    Optional<Waypoint> nearest = Optional.empty();
    double leastM = Double.POSITIVE_INFINITY;
    for (Waypoint place : places) {
      double distanceM = distanceM(place);
      if (nearest.isEmpty() || distanceM < leastM) {
        nearest = Optional.of(place);
        leastM = distanceM;
      }
    }
    return nearest;
  }

  /** Whether ways are known: where the fence has areas, only once a position has been received. */
  public boolean isReady() {
    return state != null || !way.hasAreas();
  }

  /** Waypoints on a way to a place within the fence; see {@link ReturnWay#between}. */
  public Optional<List<Waypoint>> wayTo(Waypoint place) {
    return state == null ? Optional.of(List.of()) : way.between(state, place);
  }

  /** Horizontal distance [m]; infinite if unknown. */
  private double distanceM(Waypoint place) {
    ReferenceFrame frame = place.referenceFrame();
    if (state == null || !isComparable(state.referenceFrame(), frame)) {
      return Double.POSITIVE_INFINITY;
    }
    StateInformation own = state.in(frame);
    Point from = Point.of(own.x().orElseThrow(), own.y().orElseThrow(), 0.0);
    Point to = Point.of(place.x().orElseThrow(), place.y().orElseThrow(), 0.0);
    Point apart =
        frame.equals(ReferenceFrame.GLOBAL)
            ? new Geodetic(from.x(), from.y(), 0.0).enuOf(new Geodetic(to.x(), to.y(), 0.0))
            : to.minus(from);
    return Math.hypot(apart.x(), apart.y());
  }

  private static boolean isComparable(ReferenceFrame one, ReferenceFrame other) {
    return (one.isEarth() && other.isEarth()) || (one.isLocal() && other.isLocal());
  }
}
