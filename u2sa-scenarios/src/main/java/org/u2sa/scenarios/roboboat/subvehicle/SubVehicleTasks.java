package org.u2sa.scenarios.roboboat.subvehicle;

import java.util.Collection;
import java.util.List;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypeProvider;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.PlannerStateProvider;
import org.u2sa.planning.PlannerView;

/** Registers the sub-vehicle's goal class and planner state. */
public final class SubVehicleTasks implements MessageTypeProvider, PlannerStateProvider {
  @Override
  public Collection<MessageType<?>> messageTypes() {
    return List.of(FetchGoal.TYPE);
  }

  @Override
  public Collection<PlannerState> plannerStates(
      Configurator configuration, PlannerView surroundings) {
    return List.of(new FetchState());
  }
}
