package org.u2sa.gcs.report;

import java.util.List;
import java.util.OptionalDouble;

/**
 * How well a flight went, by truth. An empty number means that the flight never was in the state it
 * is measured in.
 *
 * @param waypoints one result for each planned waypoint, in order
 * @param crossTrackRmsM RMS over time of the distance from the straight between consecutive
 *     waypoints [m], without the first {@link FlightScorer#SETTLING_DISTANCE_M} of each leg; the
 *     way to the first waypoint is none
 * @param crossTrackRmsWholeLegsM the same with nothing left out [m]
 * @param altitudeRmsM RMS over time of the altitude error on level legs [m]: those between
 *     waypoints of one altitude
 * @param altitudeMaxErrorM largest absolute altitude error on level legs [m]
 * @param maxBankRad largest absolute bank in the air [rad]
 * @param minAirspeedMps least calibrated airspeed in the air [m/s]
 * @param tookOff whether the vehicle left the ground and rose {@link FlightScorer#SCREEN_HEIGHT_M}
 *     above its start
 * @param outcome what the simulator says of the end
 * @param simSeconds simulated time from first to last sample [s]
 */
public record FlightScore(
    List<WaypointResult> waypoints,
    OptionalDouble crossTrackRmsM,
    OptionalDouble crossTrackRmsWholeLegsM,
    OptionalDouble altitudeRmsM,
    OptionalDouble altitudeMaxErrorM,
    OptionalDouble maxBankRad,
    OptionalDouble minAirspeedMps,
    boolean tookOff,
    FlightOutcome outcome,
    double simSeconds) {

  public FlightScore {
    waypoints = List.copyOf(waypoints);
  }

  /** How many waypoints were captured. */
  public int captured() {
    return (int) waypoints.stream().filter(WaypointResult::captured).count();
  }

  /**
   * Whether all waypoints were captured, at least one was planned, and nothing crashed: what exit
   * code 0 asks for.
   */
  public boolean success() {
    return !waypoints.isEmpty() && captured() == waypoints.size() && !outcome.crashed();
  }
}
