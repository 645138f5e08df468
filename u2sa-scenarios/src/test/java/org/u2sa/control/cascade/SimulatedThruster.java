package org.u2sa.control.cascade;

import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;
import org.u2sa.sim.vehicle.VehicleRun;

/** The service of one thruster of a simulated vessel; its configuration describes the effect. */
final class SimulatedThruster extends Actuator {
  private static final double FULL_PERCENT = 100.0;

  private final VehicleRun run;
  private volatile double strength = 1.0; // share of the command that its propeller carries out

  SimulatedThruster(ServiceContext context, String name, VehicleRun run) {
    super(context, name);
    this.run = run;
  }

  @Override
  protected void actuate(double percentage) {
    run.command(clock().micros(), actuatorName(), strength * percentage / FULL_PERCENT);
  }

  @Override
  protected void neutral() {
    run.command(clock().micros(), actuatorName(), 0.0);
  }

  /** Loses its propeller without noticing: obeys, announces itself, and nothing moves. */
  void breaks() {
    strength = 0.0;
    neutral();
  }

  /** Loses a part of its thrust without noticing: the effect grows by the square of the command. */
  void weakens(double left) {
    strength = Math.sqrt(left);
  }

  /** Says that only a share of its thrust is left [%]. */
  void derate(double percent) {
    available(percent);
  }
}
