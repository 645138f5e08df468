package org.u2sa.report.score;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.frame.Geodetic;

/** Scores a run against its plan by ground truth only. Assumes straight motion between samples. */
public final class RunScorer {

  /**
   * Height above the start at which an aircraft has taken off [m]: the screen height of 50 ft (CS
   * 23.2120).
   */
  public static final double SCREEN_HEIGHT_M = 15.24;

  private static final double SHORTEST_LEG_M = 1.0; // a shorter leg has no direction

  private RunScorer() {}

  /** Scores the run {@code track} of {@code plan}. */
  public static RunScore score(RunPlan plan, List<TrackSample> track, RunOutcome outcome) {
    List<WaypointResult> results = new ArrayList<>();
    for (int leg = 0; leg < plan.waypoints().size(); leg++) {
      results.add(WaypointResult.of(plan.waypoints().get(leg), leg, track));
    }
    RootMeanSquare straights = new RootMeanSquare();
    RootMeanSquare wholeLegs = new RootMeanSquare();
    double settlingM = plan.domain().settlingDistanceM();
    for (int leg = 1; leg < plan.waypoints().size(); leg++) {
      RunPlan.Waypoint from = plan.waypoints().get(leg - 1);
      RunPlan.Waypoint to = plan.waypoints().get(leg);
      scoreCrossTrack(from, to, leg, track, settlingM, straights, wholeLegs);
    }
    List<ObstacleResult> obstacles = obstacles(plan, track);
    return new RunScore(
        results,
        straights.value(),
        wholeLegs.value(),
        plan.domain() == Domain.AIR ? Optional.of(FlightFigures.of(plan, track)) : Optional.empty(),
        obstacles,
        outcome.breaking(
            obstacles.stream()
                .filter(ObstacleResult::touched)
                .map(ObstacleResult::violation)
                .toList()),
        track.isEmpty() ? 0.0 : track.get(track.size() - 1).timeS() - track.get(0).timeS());
  }

  private static List<ObstacleResult> obstacles(RunPlan plan, List<TrackSample> track) {
    if (track.isEmpty()) {
      return List.of();
    }
    TrackSample first = track.get(0);
    Geodetic home =
        plan.home()
            .map(
                start -> new Geodetic(start.longitudeDeg(), start.latitudeDeg(), start.altitudeM()))
            .orElse(new Geodetic(first.longitudeDeg(), first.latitudeDeg(), first.altitudeM()));
    return plan.surroundings().objects().stream()
        .map(each -> ObstacleResult.of(each, plan.surroundings().reachM(), home, track))
        .toList();
  }

  private static void scoreCrossTrack(
      RunPlan.Waypoint from,
      RunPlan.Waypoint to,
      int leg,
      List<TrackSample> track,
      double settlingM,
      RootMeanSquare straights,
      RootMeanSquare wholeLegs) {
    PlotPlane plane = new PlotPlane(from);
    PlotPlane.Place end = plane.place(to);
    if (end.distanceM() < SHORTEST_LEG_M) {
      return;
    }
    double sin = end.eastM() / end.distanceM();
    double cos = end.northM() / end.distanceM();
    for (int i = 0; i + 1 < track.size(); i++) {
      if (track.get(i).leg() != leg) {
        continue;
      }
      PlotPlane.Place a = plane.place(track.get(i));
      PlotPlane.Place b = plane.place(track.get(i + 1));
      double duration = track.get(i + 1).timeS() - track.get(i).timeS();
      double crossA = a.eastM() * cos - a.northM() * sin; // right positive
      double crossB = b.eastM() * cos - b.northM() * sin;
      wholeLegs.add(duration, crossA, crossB);
      double alongA = a.eastM() * sin + a.northM() * cos;
      if (alongA >= settlingM) {
        straights.add(duration, crossA, crossB);
      }
    }
  }

  /**
   * RMS over time of a quantity that is linear between its samples, so that uneven sampling does
   * not bias it.
   */
  static final class RootMeanSquare {

    private double squareSeconds;
    private double seconds;
    private double largest;

    /** Adds a linear change from {@code from} to {@code to} in {@code durationS}. */
    void add(double durationS, double from, double to) {
      squareSeconds +=
          durationS * (from * from + from * to + to * to) / 3.0; // ∫ of a squared linear function
      seconds += durationS;
      largest = Math.max(largest, Math.max(Math.abs(from), Math.abs(to)));
    }

    /** RMS; empty if nothing was added. */
    OptionalDouble value() {
      return seconds > 0.0
          ? OptionalDouble.of(Math.sqrt(squareSeconds / seconds))
          : OptionalDouble.empty();
    }

    /** Largest absolute value; empty if nothing was added. */
    OptionalDouble largest() {
      return seconds > 0.0 ? OptionalDouble.of(largest) : OptionalDouble.empty();
    }
  }
}
