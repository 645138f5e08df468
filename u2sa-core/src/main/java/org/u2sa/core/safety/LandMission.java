package org.u2sa.core.safety;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import org.u2sa.messages.GoalList;
import org.u2sa.messages.contract.FailsafeAction;
import org.u2sa.messages.schema.U2SAData;

/** Whether a mission to land by is loaded, if the matrix says LAND anywhere. */
final class LandMission {
  private final FailsafeDecision matrix;
  private boolean said;
  private boolean loaded;

  LandMission(FailsafeDecision matrix) {
    this.matrix = matrix;
  }

  private Set<Hazard> landings() {
    Set<Hazard> landings = EnumSet.noneOf(Hazard.class);
    for (Hazard hazard : Hazard.values()) {
      if (matrix.matrix(hazard) == FailsafeAction.LAND) {
        landings.add(hazard);
      }
    }
    return landings;
  }

  void see(U2SAData message) {
    if (message instanceof GoalList goals && goals.landGoals().isPresent()) {
      said = true;
      loaded = goals.landGoals().getAsLong() > 0;
    }
  }

  /** What speaks against arming. */
  Optional<String> objection() {
    Set<Hazard> landings = landings();
    if (landings.isEmpty() || loaded) {
      return Optional.empty();
    }
    String entry = landings.iterator().next().action().name() + " is LAND, but ";
    return Optional.of(
        "failsafe matrix: "
            + entry
            + (said
                ? "the Mission Manager has loaded no LAND MISSION"
                : "no Mission Manager has said that it has loaded a LAND MISSION"));
  }
}
