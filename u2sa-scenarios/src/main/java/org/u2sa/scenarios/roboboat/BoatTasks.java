package org.u2sa.scenarios.roboboat;

import java.util.Collection;
import java.util.List;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypeProvider;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.PlannerStateProvider;
import org.u2sa.planning.PlannerView;

/** Registers RoboBoat's goal classes and their planner states. */
public final class BoatTasks implements MessageTypeProvider, PlannerStateProvider {
  @Override
  public Collection<MessageType<?>> messageTypes() {
    return List.of(
        BoatTask.TYPE,
        BuoyChannel.TYPE,
        DockBoat.TYPE,
        FindTarget.TYPE,
        HulaHoop.TYPE,
        PressButton.TYPE,
        TargetReport.TYPE);
  }

  @Override
  public Collection<PlannerState> plannerStates(
      Configurator configuration, PlannerView surroundings) {
    return List.of(
        new ChannelState(surroundings),
        new DockState(surroundings),
        new FindTargetState(surroundings),
        new HulaHoopState(surroundings),
        new PressButtonState(surroundings));
  }
}
