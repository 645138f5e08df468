package org.u2sa.core.planning;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.core.planning.local.RouteTrack;
import org.u2sa.core.planning.search.CostGrid;
import org.u2sa.core.planning.seen.PlanarShape;
import org.u2sa.interfaces.time.Clock;

/**
 * Gaps that look open from afar only. A scanner's errors widen obstacles where it sees them best,
 * so a gap may close as the vehicle comes near and open again as it leaves. Two of these would send
 * it to and fro; so a gap that closed twice counts as closed as long as there is another way.
 * Belongs to the planner's thread.
 */
final class FalseGaps {
  /** Farther away than this, a gap is not looked at well [radii of the vehicle with clearance]. */
  private static final double NEAR_RADII = 5.0;

  /** Nearer than this the vehicle would stand in what counts as closed. */
  private static final double LEAST_RADII = 1.5;

  /** Sooner than this it is still the same attempt. */
  private static final long AGAIN_MICROS = 3 * Clock.MICROS_PER_SECOND;

  private record Closure(double northM, double eastM, long micros) {
    boolean isAt(double north, double east, double withinM) {
      return Math.hypot(north - northM, east - eastM) <= withinM;
    }
  }

  private final List<Closure> closures = new ArrayList<>();
  private List<PlanarShape> closed = List.of();

  /** What counts as closed. */
  List<PlanarShape> shapes() {
    return closed;
  }

  /** Begins anew, as for another goal, or where there is no other way. */
  void forget() {
    closures.clear();
    closed = List.of();
  }

  /** The vehicle's route has just been closed. */
  void blocked(RouteTrack route, CostGrid costs, long micros) {
    double radius = costs.inflation().radiusM();
    OptionalDouble ahead = firstClosedM(route, costs, NEAR_RADII * radius);
    if (ahead.isEmpty() || ahead.getAsDouble() < LEAST_RADII * radius) {
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

  /** How far ahead on the route the first closed cell is [m]; empty if there is none so near. */
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
