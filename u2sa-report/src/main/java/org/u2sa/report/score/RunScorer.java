package org.u2sa.report.score;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Geodetic;

/** Scores a run against its plan by ground truth only. Assumes straight motion between samples. */
public final class RunScorer {
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
                .filter(result -> !isPassable(plan, result))
                .map(ObstacleResult::violation)
                .toList()),
        track.isEmpty() ? 0.0 : track.get(track.size() - 1).timeS() - track.get(0).timeS());
  }

  /** Whether an object may be touched. */
  private static boolean isPassable(RunPlan plan, ObstacleResult result) {
    return plan.surroundings().objects().stream()
        .filter(object -> object.level().filter(ObjectLevel.HINDRANCE::equals).isPresent())
        .anyMatch(object -> object.uid().equals(result.name()));
  }

  private static List<ObstacleResult> obstacles(RunPlan plan, List<TrackSample> track) {
    if (track.isEmpty()) {
      return List.of();
    }
    Geodetic home = plan.home().map(RunPlan.Start::place).orElse(track.get(0).place());
    return plan.surroundings().objects().stream()
        .map(each -> ObstacleResult.of(each, plan.surroundings(), home, track))
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
    int last = -1;
    boolean onLine = false; // not after a goal without a position, which leads away from the line
    for (int i = 0; i + 1 < track.size(); i++) {
      int now = track.get(i).leg();
      onLine = now == last ? onLine : last == leg - 1;
      last = now;
      if (now != leg || !onLine) {
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
}
