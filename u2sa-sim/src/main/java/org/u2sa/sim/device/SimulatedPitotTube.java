package org.u2sa.sim.device;

import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.u2sa.device.PitotTube;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.StandardAtmosphere;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/** A pitot tube that points forward; air from behind does not reach it. */
public final class SimulatedPitotTube extends NoisyDevice<PitotTube.Impact> implements PitotTube {
  private final double biasPa;
  private final Supplier<VehicleTruth> truth;
  private final Supplier<Point> wind;
  private final DoubleSupplier altitudeM;

  /**
   * Takes the stream {@code pitot tube}.
   *
   * @param errors in Pa, of the difference
   * @param truth of the vehicle, now
   * @param wind where the air goes to: east, north, up, now [m/s]
   * @param altitudeM above mean sea level, now [m]
   */
  public SimulatedPitotTube(
      SensorErrors errors,
      NoiseStreams streams,
      Supplier<VehicleTruth> truth,
      Supplier<Point> wind,
      DoubleSupplier altitudeM) {
    super(errors, streams, "pitot tube");
    this.truth = truth;
    this.wind = wind;
    this.altitudeM = altitudeM;
    biasPa = bias();
  }

  @Override
  Impact measure(double timeS, long measuredAtMicros) {
    VehicleTruth now = truth.get();
    double forwardMps = Math.max(0.0, VehicleAxes.of(now, now.velocity().minus(wind.get())).x());
    StandardAtmosphere.Air air = StandardAtmosphere.at(altitudeM.getAsDouble());
    double mach = forwardMps / air.soundSpeedMps();
    // isentropic, subsonic (Gracey, NASA RP-1046, chapter 3)
    double impactPa = air.pressurePa() * (StrictMath.pow(1.0 + 0.2 * mach * mach, 3.5) - 1.0);
    return new Impact(
        measuredAtMicros,
        noisy(impactPa + biasPa),
        OptionalDouble.of(air.pressurePa()),
        OptionalDouble.of(air.temperatureK()));
  }
}
