package org.u2sa.planning.avoidance;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.messages.StateInformation;
import org.u2sa.planning.curve.Pose;
import org.u2sa.planning.local.RouteTrack;
import org.u2sa.planning.seen.PlanarShape;
import org.u2sa.planning.seen.SeenWorld;

/**
 * Virtual obstacles that the planner adds while another route exists: the way back, gaps found
 * closed, and the wrong sides of marks. Confined to the planner's thread.
 */
final class VirtualObstacles {
  private final SeenWorld world;
  private final FalseGaps gaps = new FalseGaps();
  private final PassSides sides = new PassSides();
  private List<PlanarShape> wayBack = List.of();

  /**
   * @param world world to which they are added
   */
  VirtualObstacles(SeenWorld world) {
    this.world = world;
  }

  /** Reopens the gaps, because no other route exists or the goal changed. */
  void forgetGaps() {
    gaps.forget();
    tell();
  }

  /** Discards all, because the plane changed; takes effect with the next change. */
  void forgetAll() {
    wayBack = List.of();
    gaps.forget();
    sides.forget();
  }

  /** Closes the way back, up to a distance to each side. */
  void closeBehind(Pose pose, double circleM, double mostM) {
    wayBack = WayBack.closed(world.shapes(), pose, circleM, mostM).map(List::of).orElse(List.of());
    tell();
  }

  /** Called when a route is blocked; takes effect with the next state. */
  void blocked(RouteTrack track, long micros) {
    gaps.blocked(track, world.costs(), micros);
    tell();
  }

  /** Closes the wrong sides of marks to be passed on one side. */
  void keepSides(
      Pose pose, StateInformation state, Optional<RouteTrack> track, AvoidanceVariables now) {
    Map<PassSides.Side, List<PlanarShape>> seen = new EnumMap<>(PassSides.Side.class);
    PassSides.parse(now.passSides())
        .forEach(
            (type, side) ->
                seen.computeIfAbsent(side, each -> new ArrayList<>())
                    .addAll(world.of(type, state)));
    if (sides.see(seen, pose, track, now.passReach(), now.body(true).circleM())) {
      tell();
    }
  }

  private void tell() {
    List<PlanarShape> all = new ArrayList<>(wayBack);
    all.addAll(gaps.shapes());
    all.addAll(sides.shapes());
    world.guess(all);
  }
}
