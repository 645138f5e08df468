package org.u2sa.planning;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.Set;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.goal.GoalInformation;

/** States of a planner, looked up by the class of the goal. */
final class PlannerStates {
  private final List<PlannerState> states = new ArrayList<>();
  private final List<PlannerState> own;
  private final Set<String> substituted = new HashSet<>(); // classes of goals

  PlannerStates(List<PlannerState> states) {
    own = List.copyOf(states);
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

  /**
   * Remark on a goal of an extension for which only a state of the planner's own is known, for an
   * ancestor class; empty from the class's second goal on.
   */
  Optional<String> substitution(GoalInformation goal) {
    List<String> chain = goal.typeChain();
    String name = chain.get(chain.size() - 1);
    return forGoal(goal)
        .filter(own::contains)
        .map(state -> state.goalClass().getSimpleName())
        .filter(pursued -> !pursued.equals(name) && substituted.add(name))
        .map(
            pursued ->
                String.format(
                    "goal \"%s\": a %s is pursued as a %s; expected a PlannerState for %s, from a"
                        + " class listed in META-INF/services/%s",
                    goal.uid(), name, pursued, name, PlannerStateProvider.class.getName()));
  }
}
