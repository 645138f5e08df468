package org.u2sa.report.score;

import java.util.List;

/** Counts how often a vehicle left the fence then in force, by ground truth. */
public final class FenceBreaches {
  private boolean wasInside = true;
  private boolean hadFence;
  private int count;

  /**
   * Processes a sample. Leaving the keep-in area or entering a keep-out area counts, as does a
   * vehicle that is first seen outside or inside one, respectively. Altitudes are ignored.
   *
   * @param keepIn corners of the keep-in area now in force; empty if none
   * @param keepOuts corners of each keep-out area now in force
   */
  public void see(
      List<RunPlan.Corner> keepIn,
      List<List<RunPlan.Corner>> keepOuts,
      double longitudeDeg,
      double latitudeDeg) {
    hadFence |= !keepIn.isEmpty() || !keepOuts.isEmpty();
    boolean isInside =
        (keepIn.isEmpty() || contains(keepIn, longitudeDeg, latitudeDeg))
            && keepOuts.stream().noneMatch(area -> contains(area, longitudeDeg, latitudeDeg));
    count += wasInside && !isInside ? 1 : 0;
    wasInside = isInside;
  }

  /** Copy of an outcome with the number of breaches, if there was a fence. */
  public RunOutcome countedIn(RunOutcome outcome) {
    return hadFence ? outcome.counting(RunOutcome.FENCE_BREACHES, count) : outcome;
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
