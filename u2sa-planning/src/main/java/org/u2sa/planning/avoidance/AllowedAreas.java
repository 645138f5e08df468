package org.u2sa.planning.avoidance;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.shape.Polygon;
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

  /** Whether a position is outside the fence, or a fence of another frame is in force. */
  boolean isForbidden(double north, double east, StateInformation state) {
    List<Polygon> inside = fence.map(FenceState::keepIn).orElse(List.of());
    List<Polygon> outside = fence.map(FenceState::keepOut).orElse(List.of());
    boolean onEarth = world.plane(state).onEarth();
    boolean isForeign =
        Stream.concat(inside.stream(), outside.stream())
            .map(Polygon::referenceFrame)
            .anyMatch(frame -> onEarth ? !frame.equals(ReferenceFrame.GLOBAL) : !frame.isLocal());
    Predicate<Polygon> contains = area -> world.outline(area, state).isInside(north, east);
    return isForeign
        || !inside.isEmpty() && inside.stream().noneMatch(contains)
        || outside.stream().anyMatch(contains);
  }
}
