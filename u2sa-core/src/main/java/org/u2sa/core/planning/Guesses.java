package org.u2sa.core.planning;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.core.planning.curve.Pose;
import org.u2sa.core.planning.local.RouteTrack;
import org.u2sa.core.planning.seen.PlanarShape;
import org.u2sa.core.planning.seen.SeenWorld;
import org.u2sa.messages.StateInformation;

/**
 * What the planner itself closes, as long as there is another way: the way back, gaps that were
 * found closed, and the wrong sides of marks. Belongs to the planner's thread.
 */
final class Guesses {
  private final SeenWorld world;
  private final FalseGaps gaps = new FalseGaps();
  private final PassSides sides = new PassSides();
  private List<PlanarShape> wayBack = List.of();

  /**
   * @param world that is told of them
   */
  Guesses(SeenWorld world) {
    this.world = world;
  }

  /** There is no other way, or another goal: gaps may be open. */
  void forgetGaps() {
    gaps.forget();
    tell();
  }

  /** None of them lies where the plane is now; seen from the next change on. */
  void forgetAll() {
    wayBack = List.of();
    gaps.forget();
    sides.forget();
  }

  /** Closes the way back, at most so far to each side. */
  void closeBehind(Pose pose, double circleM, double mostM) {
    wayBack = WayBack.closed(world.shapes(), pose, circleM, mostM).map(List::of).orElse(List.of());
    tell();
  }

  /** A route is blocked; seen from the next state on. */
  void blocked(RouteTrack track, long micros) {
    gaps.blocked(track, world.costs(), micros);
    tell();
  }

  /** Closes the wrong sides of what is to be passed on one. */
  void keepSides(
      Pose pose, StateInformation state, Optional<RouteTrack> track, AvoidanceSettings now) {
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
