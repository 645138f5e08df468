package org.u2sa.world.scanmap;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.RangeScan;

/**
 * Planar map of key scans: finds each scan's pose by matching, adds key scans, and closes loops.
 * All poses are in the map's axes.
 */
final class ScanMap {
  /**
   * Estimated pose of a scan.
   *
   * @param pose of the vehicle in the map
   * @param covariance of x, y and angle in the map's axes: match and map uncertainty, and
   *     dead-reckoning uncertainty along directions that the surroundings do not constrain
   * @param isMatched whether the scan matched the map; otherwise the pose is dead-reckoned
   * @param isRebuilt whether poses on the map have moved: a loop was closed, or a lost vehicle was
   *     found
   */
  record Located(Pose2 pose, double[] covariance, boolean isMatched, boolean isRebuilt) {}

  private static final double NEAR_M = 12.0; // key scans that a scan is matched against
  private static final int RECENT = 25; // number of these, until a loop is closed
  private static final int CLOSED_RECENTLY = 12; // key scans since the closure
  private static final double SEARCH_SIGMAS = 3.0;
  private static final double MIN_SEARCH_M = 0.3;
  private static final double MIN_SEARCH_RAD = 0.25; // odometry may lag while the vehicle turns
  private static final double MAX_SEARCH_M = 2.0;
  private static final double MAX_SEARCH_RAD = 0.5;
  private static final int LOST_SCANS = 3; // consecutive mismatches that indicate an unknown area
  private static final double LOST_FACTOR =
      10.0; // factor on the dead-reckoning covariance in that case
  private static final double OUTSIDE =
      1.5; // fraction of the search window beyond which a match is rejected
  private static final double MAX_SQUARE = 40.0; // of a closure after optimisation
  private static final int MAX_KEYS = 4000; // at least 4 km; about 60 MB of memory

  private final ScanMapVariables tuning;
  private final List<KeyScan> keys = new ArrayList<>();
  private final PoseGraph graph = new PoseGraph();
  private final ScanMatcher matcher = new ScanMatcher();
  private final LocalMap local;
  private final LoopSearch loops;
  private final boolean isFixed;
  private final double[] startCovariance;
  private final Relocation relocation;
  private List<KeyScan> compared = List.of();
  private Pose2 pose;
  private double[] covariance;
  private double[] atNewestKey = new double[9]; // covariance of the newest key scan's pose
  private double[] sinceKey = new double[9]; // dead-reckoning covariance since the newest key scan
  private Pose2 lastKey; // where the newest key scan, or the last fixed match, was taken
  private double way;
  private long matches;
  private long unmatched;
  private int unmatchedInARow;
  private int closures;

  /**
   * @param start pose of the vehicle in the map
   * @param startCovariance of that pose
   * @param saved key scans of a fixed map; empty: a new map is built
   */
  ScanMap(ScanMapVariables tuning, Pose2 start, double[] startCovariance, List<KeyScan> saved) {
    this.tuning = tuning;
    pose = start;
    covariance = startCovariance;
    this.startCovariance = startCovariance;
    isFixed = !saved.isEmpty();
    keys.addAll(saved);
    local = new LocalMap(tuning.matchReach() + NEAR_M);
    loops = new LoopSearch(tuning.matchReach());
    relocation = new Relocation(saved, tuning.matchReach(), NEAR_M);
    unmatchedInARow = isFixed ? LOST_SCANS : 0; // none has matched yet
  }

  /**
   * Finds the pose of a scan.
   *
   * @param step motion since the previous scan, in the axes of the vehicle at that scan
   */
  Located locate(ScanPoints points, RangeScan scan, Pose2 step) {
    double metres = Math.hypot(step.x(), step.y());
    way += metres;
    Pose2 predicted = pose.times(step);
    double[] noise = noise(metres, Math.abs(step.theta()));
    if (!isFixed && keys.isEmpty()) {
      pose = predicted;
      key(points, scan, null);
      return new Located(pose, covariance, true, false);
    }
    sinceKey = Matrix3.propagated(sinceKey, pose, predicted, noise);
    double[] carried = Matrix3.propagated(covariance, pose, predicted, noise);
    double[] known = isFixed ? carried : sinceKey;
    double[] prior = Matrix3.inverse(Matrix3.plus(known, Matrix3.ofSigmas(0.01, 0.01, 0.002)));
    boolean wasLost = isLost(carried);
    Optional<ScanMatcher.Match> found =
        wasLost ? Optional.empty() : near(points, predicted, prior, known);
    if (isFixed && found.isEmpty()) {
      found = relocation.find(points, predicted, carried);
    }
    if (found.isEmpty()) {
      unmatched++;
      unmatchedInARow++;
      pose = predicted;
      covariance = carried;
      boolean isNew = !isFixed && unmatchedInARow >= LOST_SCANS && isFarFromKey();
      boolean isRebuilt = // an unknown area is connected by dead reckoning alone
          isNew
              && key(
                  points,
                  scan,
                  Matrix3.times(
                      Matrix3.rotated(sinceKey, -newestKey().pose().theta()), LOST_FACTOR));
      return new Located(pose, covariance, isRebuilt, isRebuilt);
    }
    ScanMatcher.Match match = found.get();
    matches++;
    unmatchedInARow = 0;
    double[] after = Matrix3.inverse(Matrix3.plus(match.information(), prior));
    return isFixed
        ? onFixed(match.pose(), after, wasLost)
        : onGrowing(match.pose(), after, points, scan);
  }

  /** Whether a pose of the saved map is not known well enough for a match nearby to be the one. */
  private boolean isLost(double[] known) {
    return isFixed && unmatchedInARow >= LOST_SCANS && Relocation.isUncertain(known);
  }

  /** Whether the vehicle has yet to be found on the saved map. */
  boolean isLost() {
    return isLost(covariance);
  }

  /** Continues from a pose of another source, while the vehicle is lost. */
  void expect(Pose2 expected, double[] itsCovariance) {
    pose = expected;
    covariance = itsCovariance;
  }

  /** The match near the predicted pose, or a bit farther away on a map that is being built. */
  private Optional<ScanMatcher.Match> near(
      ScanPoints points, Pose2 predicted, double[] prior, double[] known) {
    prepare(predicted);
    double windowM =
        Math.min(MAX_SEARCH_M, MIN_SEARCH_M + SEARCH_SIGMAS * Matrix3.largestSigma(known));
    double windowRad =
        Math.min(MAX_SEARCH_RAD, MIN_SEARCH_RAD + SEARCH_SIGMAS * Math.sqrt(known[8]));
    ScanMatcher.Match match = matcher.match(local, points, predicted, prior, windowM, windowRad);
    if (!fits(match, predicted, windowM) && !isFixed) {
      windowM = MAX_SEARCH_M;
      match = matcher.match(local, points, predicted, prior, windowM, MAX_SEARCH_RAD);
    }
    return fits(match, predicted, windowM) ? Optional.of(match) : Optional.empty();
  }

  private boolean fits(ScanMatcher.Match match, Pose2 predicted, double windowM) {
    return match.share() >= tuning.minShare()
        && match.pose().distance(predicted) <= OUTSIDE * windowM;
  }

  private Located onFixed(Pose2 matched, double[] after, boolean wasLost) {
    pose = matched;
    covariance = after;
    double own = tuning.mapSigma();
    double[] shown = Matrix3.plus(after, Matrix3.ofSigmas(own, own, own / NEAR_M));
    return new Located(pose, shown, true, wasLost);
  }

  private Located onGrowing(Pose2 matched, double[] after, ScanPoints points, RangeScan scan) {
    KeyScan newest = newestKey();
    double[] step = Matrix3.rotated(after, -newest.pose().theta());
    covariance = Matrix3.propagated(atNewestKey, newest.pose(), matched, step);
    pose = matched;
    sinceKey = after;
    boolean isRebuilt = isFarFromKey() && key(points, scan, step);
    return new Located(pose, covariance, true, isRebuilt);
  }

  private KeyScan newestKey() {
    return keys.get(keys.size() - 1);
  }

  private boolean isFarFromKey() {
    Pose2 off = pose.from(newestKey().pose());
    return keys.size() < MAX_KEYS
        && (Math.hypot(off.x(), off.y()) >= tuning.keyDistance()
            || Math.abs(off.theta()) >= Math.toRadians(tuning.keyTurn()));
  }

  /** Adds a key scan; returns whether it closed a loop. */
  private boolean key(ScanPoints points, RangeScan scan, double[] stepCovariance) {
    Pose2 before = keys.isEmpty() ? pose : keys.get(keys.size() - 1).pose();
    keys.add(new KeyScan(pose, points, scan, way));
    int number = graph.add(pose);
    if (number > 0) {
      double[] information = Matrix3.inverse(stepCovariance);
      graph.add(new PoseGraph.Edge(number - 1, number, pose.from(before), information, false));
    }
    atNewestKey = covariance;
    sinceKey = new double[9];
    compared = List.of();
    if (!tuning.closeLoops() || number == 0) {
      return false;
    }
    List<LoopSearch.Closure> found = loops.search(keys, covariance);
    if (found.isEmpty()) {
      return false;
    }
    for (LoopSearch.Closure each : found) {
      graph.add(new PoseGraph.Edge(each.from(), each.to(), each.step(), each.information(), true));
    }
    closures += found.size();
    double[] relative = graph.optimise();
    int dropped = graph.dropContradicted(MAX_SQUARE);
    if (dropped > 0) {
      closures -= dropped;
      relative = graph.optimise();
    }
    for (int i = 0; i < keys.size(); i++) {
      keys.get(i).moveTo(graph.pose(i));
    }
    pose = graph.pose(number);
    covariance =
        Matrix3.plus(
            Matrix3.propagated(startCovariance, graph.pose(0), pose, new double[9]), relative);
    atNewestKey = covariance;
    return true;
  }

  private double[] noise(double metres, double turn) {
    double along = tuning.wayNoise() * metres + 0.005;
    double angle =
        tuning.turnNoise() * turn + Math.toRadians(tuning.headingNoise()) * metres + 0.002;
    return Matrix3.ofSigmas(along, along, angle);
  }

  /** Updates the local map with the nearby key scans, if they have changed. */
  private void prepare(Pose2 predicted) {
    List<KeyScan> chosen = isFixed ? nearFixed(predicted) : nearGrowing(predicted);
    if (!chosen.equals(compared)) {
      compared = chosen;
      local.build(chosen, predicted);
    }
  }

  private List<KeyScan> nearFixed(Pose2 predicted) {
    boolean stays = lastKey != null && lastKey.distance(predicted) < NEAR_M / 8.0;
    if (stays && !compared.isEmpty()) {
      return compared;
    }
    lastKey = predicted;
    List<KeyScan> chosen = new ArrayList<>();
    for (KeyScan key : keys) {
      if (key.pose().distance(predicted) < NEAR_M) {
        chosen.add(key);
      }
    }
    return chosen;
  }

  private List<KeyScan> nearGrowing(Pose2 predicted) {
    if (!compared.isEmpty()) {
      return compared; // until the next key scan
    }
    int newest = keys.size() - 1;
    boolean[] taken = new boolean[keys.size()];
    for (int i = Math.max(0, newest - RECENT); i <= newest; i++) {
      taken[i] = true;
    }
    for (PoseGraph.Edge edge : graph.edges()) {
      if (edge.isClosure() && edge.to() > newest - CLOSED_RECENTLY) {
        for (int i = Math.max(0, edge.from() - RECENT / 2);
            i <= Math.min(newest, edge.from() + RECENT / 2);
            i++) {
          taken[i] = true;
        }
      }
    }
    List<KeyScan> chosen = new ArrayList<>();
    for (int i = 0; i <= newest; i++) {
      if (taken[i] && keys.get(i).pose().distance(predicted) < NEAR_M) {
        chosen.add(keys.get(i));
      }
    }
    return chosen;
  }

  /** The key scans, at their current poses. */
  List<KeyScan> keys() {
    return keys;
  }

  @Override
  public String toString() {
    return (isLost() ? "lost on the saved map: " + relocation.why() + "; " : "")
        + matches
        + " scans matched, "
        + unmatched
        + " not, "
        + keys.size()
        + " key scans, "
        + closures
        + " closures of "
        + loops.tried()
        + " tried";
  }
}
