package org.u2sa.sim.device;

import java.util.OptionalDouble;
import org.u2sa.device.port.Thruster;
import org.u2sa.sim.vehicle.VehicleRun;

/**
 * A thruster of a simulated vehicle, whose model includes thrust, lag and dead band. It has no
 * measurements.
 */
public final class VehicleThruster extends SimulatedDevice<Thruster.Turning> implements Thruster {
  private static final double RATE_HZ = 20.0;
  private static final double FULL_PERCENT = 100.0;
  private static final long TIMEOUT_MICROS = 500_000;

  private final VehicleRun run;
  private final String actuator;
  private double wanted; // applied at the next read

  /**
   * @param actuator name of the vehicle's actuator
   */
  public VehicleThruster(VehicleRun run, String actuator) {
    super(RATE_HZ, 0.0);
    this.run = run;
    this.actuator = actuator;
  }

  @Override
  void tell(long nowMicros) {
    run.command(nowMicros, actuator, wanted, nowMicros + TIMEOUT_MICROS);
  }

  @Override
  protected Turning measure(double timeS, long measuredAtMicros) {
    return new Turning(
        measuredAtMicros,
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        OptionalDouble.empty());
  }

  @Override
  public void thrust(double percent) {
    wanted = Math.max(-1.0, Math.min(1.0, percent / FULL_PERCENT));
  }

  @Override
  public void stop(long nowMicros) {
    wanted = 0.0;
    if (isConnected()) {
      tell(nowMicros);
    }
  }

  @Override
  public void leave() {
    // it keeps turning until the time-out
  }

  @Override
  public void close() {
    wanted = 0.0; // the vehicle stops it at the time-out
  }
}
