package org.u2sa.sim.device;

import java.util.OptionalDouble;
import org.u2sa.device.port.Servo;
import org.u2sa.sim.vehicle.VehicleRun;

/** A servo of a simulated vehicle, whose model includes its lag. It does not measure its angle. */
public final class VehicleServo extends SimulatedDevice<Servo.Position> implements Servo {
  private static final double RATE_HZ = 20.0;

  private final VehicleRun run;
  private final String actuator;
  private final double travelRad;
  private final double lowest;
  private double wanted; // applied at the next read

  /**
   * @param actuator name of the vehicle's actuator
   * @param travelRad angle at full command [rad]
   * @param lowest minimum command: −1, or 0 if it turns only one way
   */
  public VehicleServo(VehicleRun run, String actuator, double travelRad, double lowest) {
    super(RATE_HZ, 0.0);
    this.run = run;
    this.actuator = actuator;
    this.travelRad = travelRad;
    this.lowest = lowest;
  }

  @Override
  void tell(long nowMicros) {
    run.command(nowMicros, actuator, wanted);
  }

  @Override
  protected Position measure(double timeS, long measuredAtMicros) {
    return new Position(measuredAtMicros, OptionalDouble.empty());
  }

  @Override
  public void turn(double angleRad) {
    wanted = Math.max(lowest, Math.min(1.0, angleRad / travelRad));
  }

  @Override
  public void leave() {
    // it holds its angle
  }

  @Override
  public void close() {
    // it holds its angle
  }
}
