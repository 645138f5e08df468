package org.u2sa.scenarios.vrx;

import java.util.Collection;
import java.util.List;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypeProvider;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.PlannerStateProvider;
import org.u2sa.planning.PlannerView;

/** Registers VRX's goal classes and their planner states. */
public final class VrxGoals implements MessageTypeProvider, PlannerStateProvider {
  @Override
  public Collection<MessageType<?>> messageTypes() {
    return List.of(GateCourse.TYPE, CircleObjects.TYPE, DockBySign.TYPE);
  }

  @Override
  public Collection<PlannerState> plannerStates(
      Configurator configuration, PlannerView surroundings) {
    return List.of(
        new GateCourseState(surroundings),
        new CircleState(surroundings),
        new DockBySignState(surroundings));
  }
}
