package org.u2sa.gcs.report;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * Scores a flight against its plan by truth alone. Between samples the vehicle is taken to fly
 * straight.
 */
public final class FlightScorer {

  /**
   * How far beyond the last waypoint a leg counts as turn [m]: a vehicle that flies over a waypoint
   * cannot be on the next straight at once. One radius of a coordinated turn, r = V² / (g tan φ) =
   * 636 m at 60 m/s and 30° of bank, and some 360 m for rolling in and out (3 s each).
   */
  public static final double SETTLING_DISTANCE_M = 1000.0;

  /**
   * Height above the start at which an aircraft has taken off [m]: the screen height of 50 ft (CS
   * 23.2120).
   */
  public static final double SCREEN_HEIGHT_M = 15.24;

  private static final double LEVEL_WITHIN_M =
      1.0; // altitudes of a level leg's ends differ no more
  private static final double SHORTEST_LEG_M = 1.0; // a shorter leg has no direction

  private FlightScorer() {}

  /** The score of the flight {@code track} of {@code plan}. */
  public static FlightScore score(
      FlightPlan plan, List<FlightSample> track, FlightOutcome outcome) {
    List<WaypointResult> results = new ArrayList<>();
    for (int leg = 0; leg < plan.waypoints().size(); leg++) {
      results.add(WaypointApproach.measure(plan.waypoints().get(leg), leg, track));
    }
    RootMeanSquare straights = new RootMeanSquare();
    RootMeanSquare wholeLegs = new RootMeanSquare();
    RootMeanSquare altitude = new RootMeanSquare();
    for (int leg = 1; leg < plan.waypoints().size(); leg++) {
      PlannedWaypoint from = plan.waypoints().get(leg - 1);
      PlannedWaypoint to = plan.waypoints().get(leg);
      scoreCrossTrack(from, to, leg, track, straights, wholeLegs);
      scoreAltitude(from, to, leg, track, altitude);
    }
    Airborne air = Airborne.of(plan, track);
    return new FlightScore(
        results,
        straights.value(),
        wholeLegs.value(),
        altitude.value(),
        altitude.largest(),
        air.maxBankRad(),
        air.minAirspeedMps(),
        air.tookOff(),
        outcome,
        track.isEmpty() ? 0.0 : track.get(track.size() - 1).timeS() - track.get(0).timeS());
  }

  private static void scoreCrossTrack(
      PlannedWaypoint from,
      PlannedWaypoint to,
      int leg,
      List<FlightSample> track,
      RootMeanSquare straights,
      RootMeanSquare wholeLegs) {
    LocalPlane plane = new LocalPlane(from);
    LocalPlane.Place end = plane.place(to);
    if (end.distanceM() < SHORTEST_LEG_M) {
      return;
    }
    double sin = end.eastM() / end.distanceM();
    double cos = end.northM() / end.distanceM();
    for (int i = 0; i + 1 < track.size(); i++) {
      if (track.get(i).leg() != leg) {
        continue;
      }
      LocalPlane.Place a = plane.place(track.get(i));
      LocalPlane.Place b = plane.place(track.get(i + 1));
      double duration = track.get(i + 1).timeS() - track.get(i).timeS();
      double crossA = a.eastM() * cos - a.northM() * sin; // right of the track positive
      double crossB = b.eastM() * cos - b.northM() * sin;
      wholeLegs.add(duration, crossA, crossB);
      double alongA = a.eastM() * sin + a.northM() * cos;
      if (alongA >= SETTLING_DISTANCE_M) {
        straights.add(duration, crossA, crossB);
      }
    }
  }

  private static void scoreAltitude(
      PlannedWaypoint from,
      PlannedWaypoint to,
      int leg,
      List<FlightSample> track,
      RootMeanSquare altitude) {
    if (!isLevel(from, to)) {
      return;
    }
    double planned = to.altitudeM().getAsDouble();
    for (int i = 0; i + 1 < track.size(); i++) {
      FlightSample a = track.get(i);
      if (a.leg() == leg) {
        FlightSample b = track.get(i + 1);
        altitude.add(b.timeS() - a.timeS(), a.altitudeM() - planned, b.altitudeM() - planned);
      }
    }
  }

  private static boolean isLevel(PlannedWaypoint from, PlannedWaypoint to) {
    OptionalDouble a = from.altitudeM();
    OptionalDouble b = to.altitudeM();
    return a.isPresent()
        && b.isPresent()
        && Math.abs(a.getAsDouble() - b.getAsDouble()) <= LEVEL_WITHIN_M;
  }
}
