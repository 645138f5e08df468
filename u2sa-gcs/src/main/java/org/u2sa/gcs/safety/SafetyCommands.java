package org.u2sa.gcs.safety;

import java.util.List;
import org.u2sa.gcs.command.CommandProvider;

/** Adds the commands of an operator who answers for a vehicle. */
public final class SafetyCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(
        new Contribution(Group.TOP_LEVEL, new EmergencyStopCommand()),
        new Contribution(Group.TOP_LEVEL, new ArmVehicleCommand()),
        new Contribution(Group.TOP_LEVEL, new DisarmVehicleCommand()),
        new Contribution(Group.TOP_LEVEL, new OperatorCommand()));
  }
}
