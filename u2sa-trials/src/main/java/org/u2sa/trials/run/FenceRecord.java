package org.u2sa.trials.run;

import java.util.List;
import java.util.function.Supplier;
import org.u2sa.core.safety.FenceOutline;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.report.score.FenceBreaches;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;

/**
 * Judges the vehicle's true position by the fence in force at that moment, which operators can
 * change. Confined to the observer's thread, except at the end.
 */
final class FenceRecord {
  private final Supplier<FenceOutline> inForce;
  private final Geodetic local;
  private final FenceBreaches breaches = new FenceBreaches();
  private FenceOutline outline; // the one of the corners
  private List<RunPlan.Corner> keepIn = List.of();
  private List<List<RunPlan.Corner>> keepOuts = List.of();

  /**
   * @param inForce the fence in force now; another object after each change
   * @param local origin of local frames
   */
  FenceRecord(Supplier<FenceOutline> inForce, Geodetic local) {
    this.inForce = inForce;
    this.local = local;
  }

  /** Processes a position of the vehicle, later than the previous one. */
  void see(double longitudeDeg, double latitudeDeg) {
    FenceOutline now = inForce.get();
    if (now != outline) {
      outline = now;
      keepIn = corners(now.keepIn(local));
      keepOuts = now.keepOuts(local).stream().map(FenceRecord::corners).toList();
    }
    breaches.see(keepIn, keepOuts, longitudeDeg, latitudeDeg);
  }

  private static List<RunPlan.Corner> corners(List<Geodetic> places) {
    return places.stream()
        .map(place -> new RunPlan.Corner(place.longitudeDeg(), place.latitudeDeg()))
        .toList();
  }

  /** Copy of a plan with the fence that was in force last. */
  RunPlan fenced(RunPlan plan) {
    return plan.within(keepIn, keepOuts);
  }

  /** Copy of an outcome with the number of breaches. */
  RunOutcome counted(RunOutcome outcome) {
    return breaches.countedIn(outcome);
  }
}
