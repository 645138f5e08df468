package org.u2sa.report.score;

import java.util.List;

/** Number of times a vehicle left its fence, by ground truth. */
final class FenceBreaches {
  private FenceBreaches() {}

  /**
   * Counts the times the track leaves the keep-in area or enters a keep-out area, including a start
   * outside or inside one, respectively. Altitudes are ignored.
   */
  static int count(RunPlan plan, List<TrackSample> track) {
    int breaches = 0;
    boolean wasInside = true;
    for (TrackSample sample : track) {
      double longitude = sample.longitudeDeg();
      double latitude = sample.latitudeDeg();
      boolean isInside =
          (plan.fence().isEmpty() || contains(plan.fence(), longitude, latitude))
              && plan.keepOuts().stream().noneMatch(area -> contains(area, longitude, latitude));
      breaches += wasInside && !isInside ? 1 : 0;
      wasInside = isInside;
    }
    return breaches;
  }

  /** Whether a ray to the east crosses the outline an odd number of times. */
  private static boolean contains(List<RunPlan.Corner> fence, double longitude, double latitude) {
    boolean isInside = false;
    for (int i = 0; i < fence.size(); i++) {
      RunPlan.Corner a = fence.get(i);
      RunPlan.Corner b = fence.get((i + 1) % fence.size());
      boolean crosses = a.latitudeDeg() > latitude != b.latitudeDeg() > latitude;
      if (crosses) {
        double share = (latitude - a.latitudeDeg()) / (b.latitudeDeg() - a.latitudeDeg());
        double at = Math.IEEEremainder(a.longitudeDeg() - longitude, 360.0);
        double width = Math.IEEEremainder(b.longitudeDeg() - a.longitudeDeg(), 360.0);
        isInside ^= at + share * width > 0.0;
      }
    }
    return isInside;
  }
}
