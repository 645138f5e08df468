package org.u2sa.sim.device;

import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.u2sa.device.port.PitotTube;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.StandardAtmosphere;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;

/** A forward-facing pitot tube; reverse flow reads zero. */
public final class SimulatedPitotTube extends NoisyDevice<PitotTube.Impact> implements PitotTube {
  private final double blockedAtS;
  private final double biasPa;
  private final Supplier<VehicleTruth> truth;
  private final Supplier<Point> wind;
  private final DoubleSupplier altitudeM;
  private double trappedPa = Double.NaN; // total pressure behind the blockage

  /**
   * Uses the random stream {@code pitot tube}.
   *
   * @param errors errors of the differential pressure [Pa]
   * @param truth current state of the vehicle
   * @param wind current air velocity: east, north, up [m/s]
   * @param altitudeM current altitude above mean sea level [m]
   * @param blockedAtS time of the vehicle at which its opening is blocked [s]: the total pressure
   *     of that moment is trapped, so that the reading follows altitude instead of speed
   */
  public SimulatedPitotTube(
      SensorErrors errors,
      NoiseStreams streams,
      Supplier<VehicleTruth> truth,
      Supplier<Point> wind,
      DoubleSupplier altitudeM,
      double blockedAtS) {
    super(errors, streams, "pitot tube");
    this.truth = truth;
    this.wind = wind;
    this.altitudeM = altitudeM;
    this.blockedAtS = blockedAtS;
    biasPa = bias();
  }

  @Override
  protected Impact measure(double timeS, long measuredAtMicros) {
    VehicleTruth now = truth.get();
    double forwardMps = Math.max(0.0, VehicleAxes.of(now, now.velocity().minus(wind.get())).x());
    StandardAtmosphere.Air air = StandardAtmosphere.at(altitudeM.getAsDouble());
    double mach = forwardMps / air.soundSpeedMps();
    // isentropic, subsonic (Gracey, NASA RP-1046, chapter 3)
    double impactPa = air.pressurePa() * (StrictMath.pow(1.0 + 0.2 * mach * mach, 3.5) - 1.0);
    if (now.timeS() >= blockedAtS) {
      trappedPa = Double.isNaN(trappedPa) ? air.pressurePa() + impactPa : trappedPa;
      impactPa = trappedPa - air.pressurePa();
    }
    return new Impact(
        measuredAtMicros,
        noisy(impactPa + biasPa),
        OptionalDouble.of(air.pressurePa()),
        OptionalDouble.of(air.temperatureK()));
  }
}
