package org.u2sa.trials.run;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.core.safety.Fence;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.report.score.FenceBreaches;
import org.u2sa.report.score.RunOutcome;
import org.u2sa.report.score.RunPlan;

/**
 * Judges the vehicle's true position by the fence in force at that moment, which operators can
 * change. Confined to the observer's thread, except at the end.
 */
final class FenceRecord {
  private final Supplier<Optional<Fence>> inForce;
  private final Geodetic local;
  private final FenceBreaches breaches = new FenceBreaches();
  private Fence fence; // the one of the corners; null: none
  private List<RunPlan.Corner> keepIn = List.of();
  private List<List<RunPlan.Corner>> keepOuts = List.of();

  /**
   * @param inForce the fence in force now, another object after each change; empty if none
   * @param local origin of local frames
   */
  FenceRecord(Supplier<Optional<Fence>> inForce, Geodetic local) {
    this.inForce = inForce;
    this.local = local;
  }

  /** Processes a position of the vehicle, later than the previous one. */
  void see(double longitudeDeg, double latitudeDeg) {
    Optional<Fence> now = inForce.get();
    if (now.orElse(null) != fence) {
      fence = now.orElse(null);
      keepIn = now.map(each -> corners(each.corners(local))).orElse(List.of());
      keepOuts =
          now.map(each -> each.keepOutCorners(local).stream().map(FenceRecord::corners).toList())
              .orElse(List.of());
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
