package org.u2sa.report.score;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * How well a run went, by truth. An empty number means that the vehicle never was in the state it
 * is measured in.
 *
 * @param waypoints one result for each planned waypoint, in order
 * @param crossTrackRmsM RMS over time of the distance from the straight between consecutive
 *     waypoints [m], without the first {@link Domain#settlingDistanceM} of each leg; the way to the
 *     first waypoint is none
 * @param crossTrackRmsWholeLegsM the same with nothing left out [m]
 * @param flight what is measured of aircraft only; empty for others
 * @param obstacles one result for each object around, in order
 * @param outcome what the simulator says of the end
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

  /** How many waypoints were captured. */
  public int captured() {
    return (int) waypoints.stream().filter(WaypointResult::captured).count();
  }

  /** How many waypoints were passed within a distance [m], whatever their own capture radius. */
  public int within(double distanceM) {
    return (int)
        waypoints.stream()
            .filter(result -> result.missM().orElse(Double.POSITIVE_INFINITY) <= distanceM)
            .count();
  }

  /**
   * Whether all waypoints were captured, at least one was planned, and the {@linkplain
   * RunOutcome#isClean outcome is clean}: what exit code 0 asks for.
   */
  public boolean success() {
    return !waypoints.isEmpty() && captured() == waypoints.size() && outcome.isClean();
  }
}
