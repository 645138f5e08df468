package org.u2sa.core.control.cascade;

import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.vehicle.VehicleRun;

/** The service of one thruster of a simulated vessel; its configuration describes the effect. */
final class SimulatedThruster extends Actuator {
  private static final double FULL_PERCENT = 100.0;

  private final VehicleRun run;
  private volatile boolean isBroken;

  SimulatedThruster(ServiceContext context, String name, VehicleRun run) {
    super(context, name);
    this.run = run;
  }

  @Override
  protected void actuate(double percentage) {
    run.command(clock().micros(), actuatorName(), isBroken ? 0.0 : percentage / FULL_PERCENT);
  }

  @Override
  protected void neutral() {
    run.command(clock().micros(), actuatorName(), 0.0);
  }

  /** Loses its propeller without noticing: obeys, announces itself, and nothing moves. */
  void breaks() {
    isBroken = true;
    neutral();
  }

  /** Says that only a share of its thrust is left [%]. */
  void derate(double percent) {
    available(percent);
  }
}
