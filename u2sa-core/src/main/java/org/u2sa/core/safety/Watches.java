package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.interfaces.configuration.Configurator;

/** Makes the watches that a configuration asks for. */
final class Watches {
  private Watches() {}

  static List<Watch> of(Configurator variables, Conditions conditions, FenceFile fence) {
    PositionWatch position = new PositionWatch(variables);
    List<Watch> watches = new ArrayList<>();
    watches.add(new OperatorWatch(variables));
    watches.add(position);
    watches.add(
        new EstimatorWatch(
            position,
            new ServiceWatch(
                Hazard.ESTIMATOR,
                conditions,
                () -> variables.getVariable(SafetyVariables.ESTIMATOR_SERVICE))));
    watches.add(
        new ServiceWatch(
            Hazard.ACTUATOR_LINK,
            conditions,
            () -> variables.getVariable(SafetyVariables.ACTUATOR_SERVICES)));
    watches.add(new ActuationWatch(variables));
    watches.add(new MonitorWatch(variables));
    watches.add(new GivenUpWatch(conditions));
    watches.add(
        new BatteryWatch(
            Hazard.LOW_BATTERY,
            variables,
            SafetyVariables.LOW_VOLTAGE,
            SafetyVariables.LOW_REMAINING));
    watches.add(
        new BatteryWatch(
            Hazard.CRITICAL_BATTERY,
            variables,
            SafetyVariables.CRITICAL_VOLTAGE,
            SafetyVariables.CRITICAL_REMAINING));
    watches.add(new FenceWatch(variables, fence, position));
    return watches;
  }
}
