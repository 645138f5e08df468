package org.u2sa.world.object;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Associates sightings with objects: pairs beyond the gate are excluded, the rest are assigned at
 * minimum total distance. Groups without common candidates are solved separately, so that a hundred
 * objects cost little more than a hundred times as much as one.
 */
record SightingMatch(List<MappedObject> tracks, ObjectMapVariables settings) {
  static final int NONE = -1;

  private static final double SURELY_MOVES = 3.0; // speed, in its own sigmas

  /** Index of each sighting's object in the list of tracks, or {@link #NONE}. */
  int[] of(List<Detection> detections) {
    double limit = settings.gate() * settings.gate();
    double[][] distance = new double[detections.size()][];
    int[] group = new int[detections.size()]; // sightings that compete for an object
    int[] claimed = new int[tracks.size()]; // first sighting that may claim it
    Arrays.fill(claimed, NONE);
    for (int i = 0; i < detections.size(); i++) {
      group[i] = i;
      distance[i] = new double[tracks.size()];
      boolean isTracked = isTracked(detections.get(i));
      for (int k = 0; k < tracks.size(); k++) {
        distance[i][k] = distance(detections.get(i), isTracked, tracks.get(k), limit);
        if (distance[i][k] <= limit) {
          if (claimed[k] == NONE) {
            claimed[k] = i;
          } else {
            join(group, i, claimed[k]);
          }
        }
      }
    }
    int[] match = new int[detections.size()];
    Arrays.fill(match, NONE);
    for (int i = 0; i < match.length; i++) {
      if (root(group, i) == i) {
        solve(members(group, i), distance, limit, match);
      }
    }
    return match;
  }

  /** Whether an object that was not read from a file is known by the sighting's UID. */
  private boolean isTracked(Detection detection) {
    return settings.trustUids()
        && tracks.stream()
            .anyMatch(track -> !track.isFromFile() && track.isCalled(detection.object()));
  }

  private double distance(
      Detection detection, boolean isTracked, MappedObject track, double limit) {
    boolean called = track.isCalled(detection.object());
    if (!track.isLike(detection.object(), settings.trustUids()) || isTracked && !called) {
      return Double.POSITIVE_INFINITY;
    }
    if (called && settings.trustUids() && !track.isFromFile()) {
      return 0.0; // a UID in the wrong place is rejected later
    }
    if (track.isFromFile()) { // a large object may be seen anywhere on its surface
      if (isTracked || track.isFixture() && moves(detection)) {
        return Double.POSITIVE_INFINITY; // distinguishes an aircraft from the mast below it
      }
      double sigma = Math.max(1e-6, detection.sigma().distance());
      double off = track.template().distanceTo(detection.object().center()) / sigma;
      return off * off;
    }
    double distance = track.filter().cost(detection.place(), detection.sigma());
    return called && distance <= limit ? distance / 2.0 : distance; // the UID supports the match
  }

  private static boolean moves(Detection detection) {
    return detection
        .velocity()
        .filter(each -> each.distance() > SURELY_MOVES * detection.velocitySigma().orElse(0.0))
        .isPresent();
  }

  private static int root(int[] group, int i) {
    int root = i;
    while (group[root] != root) {
      root = group[root];
    }
    return root;
  }

  private static void join(int[] group, int a, int b) {
    int first = root(group, a);
    int second = root(group, b);
    group[Math.max(first, second)] = Math.min(first, second);
  }

  private static List<Integer> members(int[] group, int root) {
    List<Integer> members = new ArrayList<>();
    for (int i = root; i < group.length; i++) {
      if (root(group, i) == root) {
        members.add(i);
      }
    }
    return members;
  }

  private void solve(List<Integer> rows, double[][] distance, double limit, int[] match) {
    List<Integer> columns = new ArrayList<>();
    for (int k = 0; k < tracks.size(); k++) {
      for (int row : rows) {
        if (distance[row][k] <= limit) {
          columns.add(k);
          break;
        }
      }
    }
    if (columns.isEmpty()) {
      return;
    }
    // One more column per sighting: a new object, at the cost of the gate.
    double[][] cost = new double[rows.size()][columns.size() + rows.size()];
    double forbidden = 1e3 * (limit + 1.0);
    for (int i = 0; i < rows.size(); i++) {
      Arrays.fill(cost[i], forbidden);
      for (int k = 0; k < columns.size(); k++) {
        double each = distance[rows.get(i)][columns.get(k)];
        cost[i][k] = each <= limit ? each : forbidden;
      }
      cost[i][columns.size() + i] = limit;
    }
    int[] columnOf = Assignment.of(cost);
    for (int i = 0; i < columnOf.length; i++) {
      if (columnOf[i] < columns.size() && cost[i][columnOf[i]] <= limit) {
        match[rows.get(i)] = columns.get(columnOf[i]);
      }
    }
  }
}
