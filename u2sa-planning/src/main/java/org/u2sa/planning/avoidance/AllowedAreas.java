package org.u2sa.planning.avoidance;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.planning.guidance.Leg;
import org.u2sa.planning.local.Area;
import org.u2sa.planning.seen.PlanarShape;
import org.u2sa.planning.seen.SeenWorld;

/** Areas of the fence in force, on the planning plane. Confined to the planner's thread. */
final class AllowedAreas {
  private final SeenWorld world;
  private Optional<FenceState> fence = Optional.empty();

  AllowedAreas(SeenWorld world) {
    this.world = world;
  }

  /** Receives the fence in force. */
  void see(FenceState inForce) {
    fence = Optional.of(inForce);
  }

  /**
   * Area inside the fence in force, drawn once, for many questions around a position; empty if a
   * fence of another frame is in force.
   *
   * @param at position on the plane [m]
   */
  Area area(Point at, StateInformation state) {
    List<Polygon> keepIn = fence.map(FenceState::keepIn).orElse(List.of());
    List<Polygon> keepOut = fence.map(FenceState::keepOut).orElse(List.of());
    boolean onEarth = world.plane(state).onEarth();
    boolean isForeign =
        Stream.concat(keepIn.stream(), keepOut.stream())
            .map(Polygon::referenceFrame)
            .anyMatch(frame -> onEarth ? !frame.equals(ReferenceFrame.GLOBAL) : !frame.isLocal());
    if (isForeign) {
      return (north, east) -> false;
    }
    List<PlanarShape> inside = outlines(keepIn, state);
    List<PlanarShape> outside = outlines(keepOut, state);
    Area exact =
        (north, east) ->
            (inside.isEmpty() || inside.stream().anyMatch(area -> area.isInside(north, east)))
                && outside.stream().noneMatch(area -> area.isInside(north, east));
    boolean isHereInside = exact.contains(at.x(), at.y());
    double edgeM =
        Stream.concat(inside.stream(), outside.stream())
            .mapToDouble(outline -> edgeM(outline, at))
            .min()
            .orElse(Double.POSITIVE_INFINITY);
    return (north, east) ->
        Math.hypot(north - at.x(), east - at.y()) < edgeM
            ? isHereInside
            : exact.contains(north, east);
  }

  private List<PlanarShape> outlines(List<Polygon> areas, StateInformation state) {
    return areas.stream().map(area -> world.outline(area, state)).collect(Collectors.toList());
  }

  private static double edgeM(PlanarShape outline, Point at) {
    double leastM = Double.POSITIVE_INFINITY;
    for (int i = 0; i < outline.count(); i++) {
      int next = (i + 1) % outline.count();
      Leg edge =
          new Leg(outline.northM(i), outline.eastM(i), outline.northM(next), outline.eastM(next));
      leastM = Math.min(leastM, edge.distanceM(at.x(), at.y()));
    }
    return leastM;
  }
}
