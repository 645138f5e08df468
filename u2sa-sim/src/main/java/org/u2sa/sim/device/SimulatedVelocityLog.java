package org.u2sa.sim.device;

import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.u2sa.device.port.VelocityLog;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/** A Doppler velocity log with bottom track within its range, and water track always. */
public final class SimulatedVelocityLog extends NoisyDevice<VelocityLog.Speeds>
    implements VelocityLog {
  private final double reachM;
  private final Point bias;
  private final Supplier<VehicleTruth> truth;
  private final Supplier<Point> current;
  private final DoubleSupplier aboveBottomM;

  /**
   * Uses the random stream {@code velocity log}.
   *
   * @param errors errors per axis [m/s]
   * @param reachM maximum distance for bottom track [m]
   * @param truth current state of the vehicle
   * @param current current water velocity: east, north, up [m/s]
   * @param aboveBottomM current distance to the bottom [m]
   */
  public SimulatedVelocityLog(
      SensorErrors errors,
      double reachM,
      NoiseStreams streams,
      Supplier<VehicleTruth> truth,
      Supplier<Point> current,
      DoubleSupplier aboveBottomM) {
    super(errors, streams, "velocity log");
    this.reachM = reachM;
    this.truth = truth;
    this.current = current;
    this.aboveBottomM = aboveBottomM;
    bias = Point.of(bias(), bias(), bias());
  }

  @Override
  protected Speeds measure(double timeS, long measuredAtMicros) {
    VehicleTruth now = truth.get();
    Point ground = measured(VehicleAxes.of(now, now.velocity()));
    Point water = measured(VehicleAxes.of(now, now.velocity().minus(current.get())));
    boolean isLocked = aboveBottomM.getAsDouble() <= reachM;
    return new Speeds(
        measuredAtMicros,
        isLocked ? OptionalDouble.of(ground.x()) : OptionalDouble.empty(),
        isLocked ? OptionalDouble.of(ground.y()) : OptionalDouble.empty(),
        isLocked ? OptionalDouble.of(ground.z()) : OptionalDouble.empty(),
        OptionalDouble.of(water.x()),
        OptionalDouble.of(water.y()),
        OptionalDouble.of(water.z()));
  }

  private Point measured(Point exact) {
    return Point.of(
        noisy(exact.x() + bias.x()), noisy(exact.y() + bias.y()), noisy(exact.z() + bias.z()));
  }
}
