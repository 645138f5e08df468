package org.u2sa.sim.device;

import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.u2sa.device.VelocityLog;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/** A Doppler velocity log that sees the bottom within its reach, and always the water. */
public final class SimulatedVelocityLog extends NoisyDevice<VelocityLog.Speeds>
    implements VelocityLog {
  private final double reachM;
  private final Point bias;
  private final Supplier<VehicleTruth> truth;
  private final Supplier<Point> current;
  private final DoubleSupplier aboveBottomM;

  /**
   * Takes the stream {@code velocity log}.
   *
   * @param errors in m/s, of each axis
   * @param reachM greatest distance to the bottom [m]
   * @param truth of the vehicle, now
   * @param current where the water goes to: east, north, up, now [m/s]
   * @param aboveBottomM distance to the bottom, now [m]
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
  Speeds measure(double timeS, long measuredAtMicros) {
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
