package org.u2sa.report.score;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Score of a run by ground truth. A number is empty if the vehicle was never in a state in which it
 * is measured.
 *
 * @param waypoints one result for each planned waypoint, in order
 * @param crossTrackRmsM RMS cross-track error over time relative to the straight line between
 *     consecutive waypoints [m], without the first {@link Domain#settlingDistanceM} of each leg;
 *     the path to the first waypoint is not a leg, nor is one that comes from another goal
 * @param crossTrackRmsWholeLegsM same for whole legs [m]
 * @param flight metrics of aircraft; empty for others
 * @param obstacles one result per surrounding object, in order
 * @param outcome outcome according to the simulator
 * @param simSeconds simulated time from first to last sample [s]
 */
public record RunScore(
    List<WaypointResult> waypoints,
    OptionalDouble crossTrackRmsM,
    OptionalDouble crossTrackRmsWholeLegsM,
    Optional<FlightFigures> flight,
    List<ObstacleResult> obstacles,
    RunOutcome outcome,
    double simSeconds) {

  public RunScore {
    waypoints = List.copyOf(waypoints);
    obstacles = List.copyOf(obstacles);
  }

  /** Number of waypoints captured. */
  public int captured() {
    return (int) waypoints.stream().filter(WaypointResult::captured).count();
  }

  /** The result in words: completed tasks, if the rules define any, and waypoints. */
  public String verdict() {
    Map<String, Integer> counts = outcome.counts();
    String tasks =
        counts.containsKey(RunOutcome.TASKS)
            ? String.format(
                Locale.ROOT,
                "%d of %d tasks done",
                counts.get(RunOutcome.TASKS_DONE),
                counts.get(RunOutcome.TASKS))
            : "";
    if (!tasks.isEmpty() && waypoints.isEmpty()) {
      return tasks;
    }
    String reached =
        String.format(Locale.ROOT, "%d of %d waypoints captured", captured(), waypoints.size());
    return tasks.isEmpty() ? reached : tasks + ", " + reached;
  }

  /** Number of waypoints passed within a distance [m], regardless of their capture radius. */
  public int within(double distanceM) {
    return (int)
        waypoints.stream()
            .filter(result -> result.missM().orElse(Double.POSITIVE_INFINITY) <= distanceM)
            .count();
  }

  /**
   * Whether all waypoints were captured that were not left out by choice, at least one goal was
   * planned, and the {@linkplain RunOutcome#isClean outcome is clean}: the condition for exit code
   * 0.
   */
  public boolean success() {
    boolean hasGoals =
        !waypoints.isEmpty()
            || outcome.counts().getOrDefault(RunOutcome.GOALS_WITHOUT_PLACE, 0) > 0;
    int leftOut = outcome.counts().getOrDefault(RunOutcome.WAYPOINTS_LEFT_OUT, 0);
    return hasGoals && captured() + leftOut == waypoints.size() && outcome.isClean();
  }
}
