package org.u2sa.scenarios.run;

import java.util.List;
import org.u2sa.messages.contract.ArmingState;
import org.u2sa.scenarios.report.RunOutcome;
import org.u2sa.sim.vehicle.VehicleTruth;

/** Judges a run by the truth, beside its waypoints. Belongs to the observer's thread. */
public interface Scorer {
  /** Looks at a moment, later than the last one. */
  default void see(VehicleTruth truth) {}

  /** Takes note of an arming state, with the truth at that moment. */
  default void armed(ArmingState state, VehicleTruth truth) {}

  /** What the vehicle does, in a word. */
  default String phase(boolean moves) {
    return moves ? "MOVES" : "STANDS";
  }

  /** How the run ended, once it has. */
  default RunOutcome outcome() {
    return new RunOutcome(0, false, List.of());
  }
}
