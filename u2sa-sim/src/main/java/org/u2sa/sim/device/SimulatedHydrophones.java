package org.u2sa.sim.device;

import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.u2sa.device.payload.HydrophoneArray;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/** A hydrophone array that receives one pinger in open water, without echoes, at any distance. */
public final class SimulatedHydrophones extends NoisyDevice<HydrophoneArray.Heard>
    implements HydrophoneArray {
  private final double frequencyHz;
  private final Point pinger;
  private final Supplier<VehicleTruth> truth;
  private final double sigmaRad;
  private final double azimuthBiasRad;
  private final double elevationBiasRad;

  /**
   * Uses the random stream {@code hydrophones}.
   *
   * @param errors of the angles [rad]; their rate is that of the pings
   * @param frequencyHz frequency of the pinger [Hz]
   * @param pinger position of the pinger: east, north, up [m]
   * @param truth current state of the array
   */
  public SimulatedHydrophones(
      SensorErrors errors,
      double frequencyHz,
      Point pinger,
      NoiseStreams streams,
      Supplier<VehicleTruth> truth) {
    super(errors, streams, "hydrophones");
    this.frequencyHz = frequencyHz;
    this.pinger = pinger;
    this.truth = truth;
    sigmaRad = Math.hypot(errors.sigma(), errors.biasSigma());
    azimuthBiasRad = bias();
    elevationBiasRad = bias();
  }

  @Override
  protected Heard measure(double timeS, long measuredAtMicros) {
    VehicleTruth now = truth.get();
    Point seen = VehicleAxes.of(now, pinger.minus(now.position()));
    double azimuth = noisy(StrictMath.atan2(seen.y(), seen.x()) + azimuthBiasRad);
    double level = StrictMath.hypot(seen.x(), seen.y());
    double elevation = noisy(StrictMath.atan2(-seen.z(), level) + elevationBiasRad);
    double most = Math.PI / 2.0;
    return new Ping(
        measuredAtMicros,
        frequencyHz,
        Math.IEEEremainder(azimuth, 2.0 * Math.PI),
        Math.max(-most, Math.min(most, elevation)),
        OptionalDouble.of(sigmaRad));
  }
}
