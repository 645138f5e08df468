package org.u2sa.scenarios.suas.score;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The score of a flight: 0.1 timeline + 0.2 flight + 0.1 · (obstacles cleared / all)³ + 0.2 objects
 * + 0.1 map + 0.2 drop + 0.1 operations. Flight = mean of the waypoints − 0.1 per takeover − 0.1
 * per boundary violation − 0.5 for a crash, and 0 if the mean gap of the telemetry exceeds 1 s.
 *
 * @param timeline share of the mission's parts done in time, 0…1
 * @param waypoints mean score of the waypoints, 0…1
 * @param gapS mean gap of the telemetry [s]
 * @param takeovers by a pilot
 * @param outOfBounds times that the boundary was left, debounced
 * @param cleared obstacles not hit
 * @param obstacles all of them
 * @param objects 0…1
 * @param map share of the search area seen at the resolution, 0…1
 * @param drop accuracy, 0…1
 * @param operations 0…1
 */
public record ScoreSheet(
    double timeline,
    double waypoints,
    double gapS,
    int takeovers,
    int outOfBounds,
    boolean crashed,
    int cleared,
    int obstacles,
    double objects,
    double map,
    double drop,
    double operations) {
  private static final double LONGEST_GAP_S = 1.0;
  private static final double DROP_M = 150.0 * 0.3048;

  /** Score of a drop by its distance from the target [m]; 0 from 150 ft on. */
  public static double drop(double awayM) {
    return Math.max(0.0, 1.0 - awayM / DROP_M);
  }

  /** Score of the flight, 0…1. */
  public double flight() {
    double score = waypoints - 0.1 * takeovers - 0.1 * outOfBounds - (crashed ? 0.5 : 0.0);
    return gapS > LONGEST_GAP_S ? 0.0 : Math.max(0.0, score);
  }

  /** Score of the obstacles, 0…1; 1 without any. */
  public double avoidance() {
    return obstacles == 0 ? 1.0 : Math.pow((double) cleared / obstacles, 3.0);
  }

  /** Total score, 0…1. */
  public double total() {
    return 0.1 * timeline
        + 0.2 * flight()
        + 0.1 * avoidance()
        + 0.2 * objects
        + 0.1 * map
        + 0.2 * drop
        + 0.1 * operations;
  }

  /** The parts by name, for {@code summary.json}. */
  public Map<String, Double> figures() {
    Map<String, Double> figures = new LinkedHashMap<>();
    figures.put("scoreTimeline", timeline);
    figures.put("scoreWaypoints", waypoints);
    figures.put("scoreFlight", flight());
    figures.put("scoreObstacles", avoidance());
    figures.put("scoreObjects", objects);
    figures.put("scoreMap", map);
    figures.put("scoreDrop", drop);
    figures.put("scoreOperations", operations);
    figures.put("score", total());
    figures.put("telemetryGapS", gapS);
    return figures;
  }
}
