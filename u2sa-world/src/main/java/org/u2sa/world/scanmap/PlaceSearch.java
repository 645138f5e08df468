package org.u2sa.world.scanmap;

import java.util.Optional;

/**
 * Finds where echoes fit a map, in a window that may contain several such places. A place must fit
 * well and be definite in all directions.
 */
final class PlaceSearch {
  /**
   * A place.
   *
   * @param match the best one in the window
   * @param alike another pose in the window that may be the true one, if there is any
   */
  record Place(ScanMatcher.Match match, Optional<Pose2> alike) {}

  private static final double MIN_SHARE = 0.7;
  private static final double MIN_SCORE = 0.55;
  private static final double MAX_SIGMA_M = 0.15;
  private static final double ALIKE = 0.85; // of the score: another pose that may be the true one

  private final ScanMatcher matcher = new ScanMatcher();

  /** The best place in a window around the expected pose. */
  Optional<Place> search(
      LocalMap map, ScanPoints scan, Pose2 expected, double windowM, double windowRad) {
    Pose2 best = matcher.searched(map, scan, expected, windowM, windowRad);
    double[] weak = Matrix3.inverse(Matrix3.ofSigmas(5.0, 5.0, 1.0));
    ScanMatcher.Match match = matcher.match(map, scan, best, weak, 0.0, 0.0);
    if (match.share() <= MIN_SHARE || match.score() <= MIN_SCORE || !isDefinite(match)) {
      return Optional.empty();
    }
    double least = ALIKE * match.score();
    Optional<Pose2> alike =
        matcher
            .elsewhere(map, scan, expected, windowM, windowRad, match.pose(), least)
            .filter(other -> ScanMatcher.score(map, scan, other) > least);
    return Optional.of(new Place(match, alike));
  }

  private static boolean isDefinite(ScanMatcher.Match match) {
    try {
      double[] known = Matrix3.inverse(match.information());
      return known[0] > 0.0
          && known[4] > 0.0
          && known[8] > 0.0
          && Matrix3.largestSigma(known) <= MAX_SIGMA_M;
    } catch (ArithmeticException e) {
      return false;
    }
  }
}
