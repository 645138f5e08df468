package org.u2sa.planning.avoidance;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.seen.PlanarShape;

/**
 * Gaps that appear open only from a distance. Scanner errors widen obstacles where they are seen
 * best, so a gap may close as the vehicle approaches and open again as it leaves. Two such gaps
 * would make it oscillate; so a gap that closed twice counts as closed while another route exists.
 * Confined to the planner's thread.
 */
final class FalseGaps {
  /** Maximum distance at which a gap is seen reliably [radii of the vehicle with clearance]. */
  private static final double NEAR_RADII = 5.0;

  /** Minimum distance: nearer, the vehicle would be inside the closed region. */
  private static final double MIN_RADII = 1.5;

  /** Sooner closures belong to the same attempt. */
  private static final long AGAIN_MICROS = 3 * Clock.MICROS_PER_SECOND;

  private record Closure(double northM, double eastM, long micros) {
    boolean isAt(double north, double east, double withinM) {
      return Math.hypot(north - northM, east - eastM) <= withinM;
    }
  }

  private final List<Closure> closures = new ArrayList<>();
  private List<PlanarShape> closed = List.of();

  /** Shapes of the closed gaps. */
  List<PlanarShape> shapes() {
    return closed;
  }

  /** Resets, such as for another goal or if no other route exists. */
  void forget() {
    closures.clear();
    closed = List.of();
  }

  /** Called when the vehicle's route has just been blocked. */
  void blocked(RouteTrack route, CostGrid costs, long micros) {
    double radius = costs.inflation().radiusM();
    OptionalDouble ahead = firstClosedM(route, costs, NEAR_RADII * radius);
    if (ahead.isEmpty() || ahead.getAsDouble() < MIN_RADII * radius) {
      return;
    }
    double north = route.northAheadM(ahead.getAsDouble());
    double east = route.eastAheadM(ahead.getAsDouble());
    boolean again = false;
    for (Closure before : closures) {
      boolean same = before.isAt(north, east, radius);
      if (same && micros - before.micros() < AGAIN_MICROS) {
        return;
      }
      again |= same;
    }
    closures.add(new Closure(north, east, micros));
    if (again) {
      List<PlanarShape> more = new ArrayList<>(closed);
      more.add(PlanarShape.disc("gap", north, east, costs.frame().cellM()));
      closed = List.copyOf(more);
    }
  }

  /** Distance along the route to the first closed cell [m]; empty if none is near enough. */
  private static OptionalDouble firstClosedM(RouteTrack route, CostGrid costs, double withinM) {
    double step = 0.5 * costs.frame().cellM();
    double farthest = Math.min(withinM, route.remainingM());
    for (double ahead = 0.0; ahead <= farthest; ahead += step) {
      if (costs.cost(route.northAheadM(ahead), route.eastAheadM(ahead))
          == Double.POSITIVE_INFINITY) {
        return OptionalDouble.of(ahead);
      }
    }
    return OptionalDouble.empty();
  }
}
