package org.u2sa.world.scanmap;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * Detects loop closures. A candidate must fit well, near the expected pose, and better than
 * elsewhere in the search window, and a second candidate from a later scan must agree with it.
 */
final class LoopSearch {
  /** A candidate: the newest key scan relative to an earlier one. */
  record Closure(int from, int to, Pose2 step, double[] information) {}

  private static final double MIN_DRIVEN_M = 12.0; // distance driven between two visits
  private static final double MAX_RADIUS_M = 12.0;
  private static final double BASE_RADIUS_M = 1.5;
  private static final double SIGMAS = 3.0;
  private static final double MAX_TURN = 0.5; // [rad]
  private static final double NEIGHBOURS_M =
      6.0; // distance driven before and after the candidate [m]
  private static final double JOINED_M =
      4.0; // distance covered by the newest scans, matched together [m]
  private static final double INFLATED =
      4.0; // variance of the expected pose, for what the graph's omits
  private static final double MAX_OFF = 16.0; // from the expected pose, squared sigmas
  private static final double MAX_OFF_IF_ALIKE = 1.0;
  private static final double MIN_APART =
      4.0; // by which the other one is farther from the expected pose
  private static final double AGREE_M = 0.35;
  private static final double AGREE_RAD = 0.06;
  private static final double PENDING_M = 5.0;
  private static final double STEP_M = 0.7; // distance between searches [m]
  private static final double PAUSE_M =
      3.0; // minimum distance after a closure before another one to the same visit [m]
  private static final int MIN_POINTS = 60;
  private static final int CANDIDATES = 2;

  private final LocalMap map;
  private final PlaceSearch places = new PlaceSearch();
  private final List<Closure> pending = new ArrayList<>();
  private double searchedM = Double.NEGATIVE_INFINITY;
  private final List<Closure> confirmed = new ArrayList<>();
  private long tried;

  LoopSearch(double reach) {
    map = new LocalMap(reach + MAX_RADIUS_M);
  }

  /**
   * Searches for a visit before the newest key scan's; returns closures that confirm each other.
   */
  List<Closure> search(List<KeyScan> keys, double[] covariance) {
    int newest = keys.size() - 1;
    KeyScan now = keys.get(newest);
    pending.removeIf(each -> now.drivenM() - keys.get(each.to()).drivenM() > PENDING_M);
    if (now.drivenM() - searchedM < STEP_M) {
      return List.of();
    }
    searchedM = now.drivenM();
    double sigma = Matrix3.largestSigma(covariance);
    double radius = Math.min(MAX_RADIUS_M, BASE_RADIUS_M + SIGMAS * sigma);
    double turn = Math.min(MAX_TURN, 0.1 + SIGMAS * Math.sqrt(covariance[8]));
    List<Integer> near = new ArrayList<>();
    for (int i = 0; i < newest; i++) {
      if (now.drivenM() - keys.get(i).drivenM() > MIN_DRIVEN_M
          && keys.get(i).pose().distance(now.pose()) < radius + 1.0) {
        near.add(i);
      }
    }
    near.sort(Comparator.comparingDouble(i -> keys.get(i).pose().distance(now.pose())));
    List<Integer> visits = new ArrayList<>(); // the nearest key scan of each visit
    for (int candidate : near) {
      double drivenM = keys.get(candidate).drivenM();
      if (visits.stream()
          .noneMatch(i -> Math.abs(keys.get(i).drivenM() - drivenM) < NEIGHBOURS_M)) {
        visits.add(candidate);
      }
    }
    visits.removeIf(each -> isClosed(keys, each));
    visits.sort(null); // oldest first: its position has drifted least
    List<Closure> found = new ArrayList<>();
    for (int candidate : visits.subList(0, Math.min(CANDIDATES, visits.size()))) {
      closure(keys, candidate, radius, turn, covariance)
          .ifPresent(each -> confirm(keys, each, found));
    }
    return found;
  }

  /** Whether the loop to that visit has just been closed. */
  private boolean isClosed(List<KeyScan> keys, int candidate) {
    double drivenM = keys.get(keys.size() - 1).drivenM();
    return confirmed.stream()
        .anyMatch(
            each ->
                drivenM - keys.get(each.to()).drivenM() < PAUSE_M
                    && Math.abs(keys.get(each.from()).drivenM() - keys.get(candidate).drivenM())
                        < NEIGHBOURS_M);
  }

  private void confirm(List<KeyScan> keys, Closure closure, List<Closure> found) {
    for (Closure other : pending) {
      if (other.to() < closure.to() && agree(keys, other, closure)) {
        found.add(other);
        found.add(closure);
        pending.remove(other);
        confirmed.add(closure);
        confirmed.removeIf(
            each -> keys.get(closure.to()).drivenM() - keys.get(each.to()).drivenM() > PAUSE_M);
        return;
      }
    }
    pending.add(closure);
  }

  /** Whether two closures are consistent, given the chains of poses at both ends. */
  private static boolean agree(List<KeyScan> keys, Closure a, Closure b) {
    Pose2 early = keys.get(b.from()).pose().from(keys.get(a.from()).pose());
    Pose2 late = keys.get(b.to()).pose().from(keys.get(a.to()).pose());
    Pose2 there = early.times(b.step());
    Pose2 here = a.step().times(late);
    return here.distance(there) < AGREE_M
        && Math.abs(Pose2.wrapped(here.theta() - there.theta())) < AGREE_RAD;
  }

  private Optional<Closure> closure(
      List<KeyScan> keys, int candidate, double radius, double turn, double[] covariance) {
    tried++;
    int newest = keys.size() - 1;
    KeyScan now = keys.get(newest);
    List<KeyScan> around = new ArrayList<>();
    for (int i = 0; i < newest; i++) {
      KeyScan key = keys.get(i);
      if (Math.abs(key.drivenM() - keys.get(candidate).drivenM()) <= NEIGHBOURS_M
          && now.drivenM() - key.drivenM() > MIN_DRIVEN_M) {
        around.add(key);
      }
    }
    List<KeyScan> latest = new ArrayList<>();
    for (int i = newest; i >= 0 && now.drivenM() - keys.get(i).drivenM() <= JOINED_M; i--) {
      latest.add(keys.get(i));
    }
    ScanPoints joined = ScanPoints.joined(latest, now.pose());
    if (joined.count < MIN_POINTS) {
      return Optional.empty();
    }
    map.build(around, now.pose());
    Optional<PlaceSearch.Place> place = places.search(map, joined, now.pose(), radius, turn);
    if (place.isEmpty()) {
      return Optional.empty();
    }
    ScanMatcher.Match match = place.get().match();
    double off = squareOff(now.pose(), match.pose(), covariance);
    boolean isLikeliest = // unlike along a row of equal pillars
        place
            .get()
            .alike()
            .map(
                other ->
                    off < MAX_OFF_IF_ALIKE
                        && squareOff(now.pose(), other, covariance) > off + MIN_APART)
            .orElse(true);
    if (off > MAX_OFF || !isLikeliest) {
      return Optional.empty();
    }
    Pose2 early = keys.get(candidate).pose();
    double[] information = Matrix3.rotated(match.information(), -early.theta());
    return Optional.of(
        new Closure(candidate, newest, match.pose().from(early), Matrix3.times(information, 0.25)));
  }

  /** Squared Mahalanobis distance of a position from where the graph has the vehicle. */
  private static double squareOff(Pose2 expected, Pose2 there, double[] covariance) {
    double x = there.x() - expected.x();
    double y = there.y() - expected.y();
    double a = INFLATED * covariance[0] + 1e-4;
    double b = INFLATED * covariance[1];
    double d = INFLATED * covariance[4] + 1e-4;
    return (d * x * x - 2.0 * b * x * y + a * y * y) / (a * d - b * b);
  }

  /** Number of candidates compared so far. */
  long tried() {
    return tried;
  }
}
