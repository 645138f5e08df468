package org.u2sa.trials.run;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.report.score.RunPlan;

/**
 * A plan that follows the waypoints which operators move, and changed thresholds, but those of
 * stations: their capture radii are circles.
 */
final class MovedPlan {
  private static final double SAME_WITHIN_M = 0.01;

  private final Geodetic origin;
  private final Set<String> moved = new TreeSet<>();
  private RunPlan plan;

  /**
   * @param origin of the local frames
   */
  MovedPlan(RunPlan plan, Geodetic origin) {
    this.plan = plan;
    this.origin = origin;
  }

  RunPlan plan() {
    return plan;
  }

  /** Names of the moved waypoints. */
  Set<String> moved() {
    return moved;
  }

  /**
   * Takes over the position of a goal.
   *
   * @param at index of its waypoint
   * @param withThresholds whether to take over its thresholds, too
   * @return whether it differs from the plan's
   */
  boolean follow(Waypoint goal, int at, boolean withThresholds) {
    RunPlan.Waypoint planned = plan.waypoints().get(at);
    boolean asPlanned = !withThresholds || goal instanceof Station;
    Optional<RunPlan.Waypoint> now =
        RunPlans.waypoint(goal, origin)
            .map(
                to ->
                    asPlanned
                        ? to.within(planned.captureRadiusM(), planned.verticalThresholdM())
                        : to)
            .filter(to -> !isSame(planned, to));
    now.ifPresent(
        to -> {
          plan = plan.with(at, to);
          moved.add(goal.uid());
        });
    return now.isPresent();
  }

  private static boolean isSame(RunPlan.Waypoint one, RunPlan.Waypoint other) {
    OptionalDouble a = one.altitudeM();
    OptionalDouble b = other.altitudeM();
    boolean level =
        a.isPresent() && b.isPresent()
            ? Math.abs(a.getAsDouble() - b.getAsDouble()) <= SAME_WITHIN_M
            : a.equals(b);
    return level
        && one.captureRadiusM() == other.captureRadiusM()
        && one.verticalThresholdM().equals(other.verticalThresholdM())
        && one.onMap().distanceM(other.onMap()) <= SAME_WITHIN_M;
  }
}
