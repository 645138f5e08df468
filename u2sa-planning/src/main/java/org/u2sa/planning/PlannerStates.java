package org.u2sa.planning;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.goal.GoalInformation;

/** States of a planner, looked up by the class of the goal. */
final class PlannerStates {
  private final List<PlannerState> states = new ArrayList<>();

  PlannerStates(List<PlannerState> states) {
    this.states.addAll(states);
  }

  /** Adds the states of extensions; these replace earlier ones for the same class of goals. */
  void discover(Configurator configuration, PlannerView surroundings) {
    for (PlannerStateProvider provider : ServiceLoader.load(PlannerStateProvider.class)) {
      states.addAll(provider.plannerStates(configuration, surroundings));
    }
  }

  /** State for the goal's class or its nearest ancestor class. */
  Optional<PlannerState> forGoal(GoalInformation goal) {
    PlannerState nearest = null;
    for (PlannerState state : states) {
      boolean nearer = nearest == null || nearest.goalClass().isAssignableFrom(state.goalClass());
      if (state.goalClass().isInstance(goal) && nearer) {
        nearest = state;
      }
    }
    return Optional.ofNullable(nearest);
  }
}
