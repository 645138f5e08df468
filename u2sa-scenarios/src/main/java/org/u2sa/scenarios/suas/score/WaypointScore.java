package org.u2sa.scenarios.suas.score;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * Score of the waypoints: max(0, (100 ft − d) / 100 ft) for each, d the distance of one position of
 * the telemetry, positions in the order of the waypoints; the best such sequence by dynamic
 * programming (auvsi-suas/interop, score_waypoints).
 */
public final class WaypointScore {
  private static final double WIDE_M = 30.48; // 100 ft

  private WaypointScore() {}

  /** Score of each waypoint in the best ordered sequence, 0…1. */
  public static List<Double> scores(List<Point> waypoints, List<ReportedTrack.Sample> track) {
    int count = track.size();
    double[] best = new double[count]; // sum of the waypoints so far, positions up to j
    int[][] chosen = new int[waypoints.size()][count];
    for (int i = 0; i < waypoints.size(); i++) {
      double[] with = new double[count];
      for (int j = 0; j < count; j++) {
        double here = best[j] + score(waypoints.get(i), track.get(j));
        boolean isBetter = j == 0 || here > with[j - 1];
        with[j] = isBetter ? here : with[j - 1];
        chosen[i][j] = isBetter ? j : chosen[i][j - 1];
      }
      best = with;
    }
    List<Double> scores = new ArrayList<>();
    int last = count - 1;
    for (int i = waypoints.size() - 1; i >= 0; i--) {
      int at = last < 0 ? -1 : chosen[i][last];
      scores.add(0, at < 0 ? 0.0 : score(waypoints.get(i), track.get(at)));
      last = at;
    }
    return scores;
  }

  private static double score(Point waypoint, ReportedTrack.Sample at) {
    double distance = at.distanceM(waypoint.x(), waypoint.y(), waypoint.z());
    return Math.max(0.0, (WIDE_M - distance) / WIDE_M);
  }
}
