package org.u2sa.core.safety;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import org.u2sa.core.mission.MissionManager;
import org.u2sa.messages.U2SAData;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.contract.FailsafeAction;

/** Whether there is a mission to land by, if the matrix says LAND anywhere: it is asked for. */
final class LandMission {
  private final FailsafeDecision matrix;
  private boolean answered;
  private boolean there;

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

  /** Whether the Mission Manager's configuration is still to be asked for. */
  boolean isOpen() {
    return !there && !landings().isEmpty();
  }

  void see(U2SAData message) {
    if (message instanceof ConfigurationResponse response) {
      for (ConfigurationVariable variable : response.variables()) {
        if (variable.name().equals(MissionManager.LAND_MISSION.name())) {
          answered = true;
          there = !variable.value().isEmpty();
        }
      }
    }
  }

  /** What speaks against arming. */
  Optional<String> objection() {
    Set<Hazard> landings = landings();
    if (landings.isEmpty() || there) {
      return Optional.empty();
    }
    String entry = landings.iterator().next().action().name() + " is LAND, but ";
    return Optional.of(
        "failsafe matrix: "
            + entry
            + (answered
                ? "the Mission Manager has no LAND MISSION"
                : "no Mission Manager has answered whether it has a LAND MISSION"));
  }
}
