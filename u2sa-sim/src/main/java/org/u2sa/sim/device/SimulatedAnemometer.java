package org.u2sa.sim.device;

import java.util.function.Supplier;
import org.u2sa.device.port.Anemometer;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/** An anemometer in the undisturbed air around the vehicle. */
public final class SimulatedAnemometer extends NoisyDevice<Anemometer.Wind> implements Anemometer {
  private final Supplier<VehicleTruth> truth;
  private final Supplier<Point> air;
  private final double biasMps;
  private final double directionSigmaRad;

  /**
   * Uses the random stream {@code anemometer}.
   *
   * @param errors errors of the speed [m/s]
   * @param directionSigmaRad standard deviation of the direction [rad]
   * @param truth current state of the instrument
   * @param air current air velocity: east, north, up [m/s]
   */
  public SimulatedAnemometer(
      SensorErrors errors,
      double directionSigmaRad,
      NoiseStreams streams,
      Supplier<VehicleTruth> truth,
      Supplier<Point> air) {
    super(errors, streams, "anemometer");
    this.truth = truth;
    this.air = air;
    this.directionSigmaRad = directionSigmaRad;
    biasMps = bias();
  }

  @Override
  protected Wind measure(double timeS, long measuredAtMicros) {
    VehicleTruth now = truth.get();
    Point through = VehicleAxes.of(now, now.velocity().minus(air.get()));
    double speedMps = Math.max(0.0, noisy(Math.hypot(through.x(), through.y()) + biasMps));
    double fromRad = Math.atan2(through.y(), through.x()) + directionSigmaRad * gaussian();
    return new Wind(measuredAtMicros, speedMps, Math.IEEEremainder(fromRad, 2.0 * Math.PI));
  }
}
