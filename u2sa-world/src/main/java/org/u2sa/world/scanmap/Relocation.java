package org.u2sa.world.scanmap;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Finds a lost vehicle on a saved map: anywhere within its uncertainty, but only where no other
 * place in it looks alike. Where several do, later scans from elsewhere may tell them apart.
 */
final class Relocation {
  /** Largest standard deviation of a position that is searched [m]: takes a phone a second. */
  static final double MAX_SIGMA_M = 5.0;

  private static final double SIGMAS = 3.0;
  private static final double MIN_WINDOW_M = 2.0; // after a slip, the uncertainty is too small
  private static final double MIN_WINDOW_RAD = 0.5;
  private static final double AGAIN_M = 0.3; // motion after which the vehicle is searched again
  private static final double AGAIN_RAD = 0.15;
  private static final int AGAIN_SCANS = 10; // the same at rest: people may have moved

  private final List<KeyScan> keys;
  private final double reach;
  private final double nearM;
  private final PlaceSearch places = new PlaceSearch();
  private LocalMap map; // of the last window, until the vehicle is found
  private double mapWindowM;
  private Pose2 searchedAt;
  private String why = "not searched yet";
  private int scansSince;

  /**
   * @param keys of the saved map
   * @param reach of scans [m]
   * @param nearM distance up to which a key scan shows what a scan sees
   */
  Relocation(List<KeyScan> keys, double reach, double nearM) {
    this.keys = keys;
    this.reach = reach;
    this.nearM = nearM;
  }

  /** Whether a pose is so uncertain that the vehicle may be at more than one place. */
  static boolean isUncertain(double[] covariance) {
    return SIGMAS * Matrix3.largestSigma(covariance) > ScanMatcher.ELSEWHERE_M
        || SIGMAS * Math.sqrt(covariance[8]) > ScanMatcher.ELSEWHERE_RAD;
  }

  /** The match at the only place where the vehicle can be; empty if there are none or several. */
  Optional<ScanMatcher.Match> find(ScanPoints scan, Pose2 expected, double[] covariance) {
    double sigmaM = Matrix3.largestSigma(covariance);
    if (sigmaM > MAX_SIGMA_M) {
      why =
          String.format(
              Locale.ROOT,
              "its position is known to %.0f m (1 sigma), at most %.0f m are searched",
              sigmaM,
              MAX_SIGMA_M);
      return Optional.empty();
    }
    if (!isDue(expected)) {
      return Optional.empty();
    }
    searchedAt = expected;
    scansSince = 0;
    double windowM = Math.max(MIN_WINDOW_M, SIGMAS * sigmaM);
    double windowRad =
        Math.min(Math.PI, Math.max(MIN_WINDOW_RAD, SIGMAS * Math.sqrt(covariance[8])));
    if (map == null || windowM > mapWindowM) {
      mapWindowM = windowM + 1.0; // the uncertainty grows with the way
      map = new LocalMap(reach + mapWindowM);
    }
    double near = windowM * Math.sqrt(2.0) + nearM;
    map.build(
        keys.stream()
            .filter(key -> key.pose().distance(expected) < near)
            .collect(Collectors.toList()),
        expected);
    Optional<PlaceSearch.Place> place = places.search(map, scan, expected, windowM, windowRad);
    if (place.isEmpty() || place.get().alike().isPresent()) {
      why = place.isEmpty() ? "the scan fits nowhere" : "several places look alike";
      return Optional.empty();
    }
    map = null;
    searchedAt = null;
    return Optional.of(place.get().match());
  }

  /** Why the vehicle has not been found. */
  String why() {
    return why;
  }

  private boolean isDue(Pose2 expected) {
    return searchedAt == null
        || ++scansSince >= AGAIN_SCANS
        || expected.distance(searchedAt) > AGAIN_M
        || Math.abs(Pose2.wrapped(expected.theta() - searchedAt.theta())) > AGAIN_RAD;
  }
}
