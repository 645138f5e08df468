package org.u2sa.scenarios.roboboat.subvehicle;

import java.util.Collection;
import java.util.List;
import org.u2sa.interfaces.configuration.Configurator;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.MessageTypeProvider;
import org.u2sa.planning.PlannerState;
import org.u2sa.planning.PlannerStateProvider;
import org.u2sa.planning.PlannerView;

/** Registers the sub-vehicle's goal class, and the planner states of both vehicles. */
public final class SubVehicleTasks implements MessageTypeProvider, PlannerStateProvider {
  private static final VariableDeclaration<Boolean> CARRIER =
      VariableDeclaration.flag("SUB VEHICLE FETCHES")
          .ifAbsent(false)
          .describedAs(
              "Whether a sub-vehicle carries out goals of the class fetchGoal while this vehicle waits.");
  private static final VariableDeclaration<Boolean> FELT =
      VariableDeclaration.flag("GRIPPER FELT")
          .ifAbsent(false)
          .describedAs(
              "Whether a GripperSensor reports if the gripper holds an object after a fetchGoal; if not, another attempt follows.");

  @Override
  public Collection<MessageType<?>> messageTypes() {
    return List.of(FetchGoal.TYPE);
  }

  @Override
  public Collection<PlannerState> plannerStates(
      Configurator configuration, PlannerView surroundings) {
    boolean isCarrier = configuration.getVariable(CARRIER);
    boolean isFelt = configuration.getVariable(FELT);
    return List.of(
        isCarrier
            ? new AwaitState()
            : new FetchState(() -> !isFelt || GripperSensor.isHolding(surroundings.objects())));
  }
}
