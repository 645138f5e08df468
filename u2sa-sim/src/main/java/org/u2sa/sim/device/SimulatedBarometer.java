package org.u2sa.sim.device;

import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import org.u2sa.device.port.Barometer;
import org.u2sa.device.port.Pressure;
import org.u2sa.device.pressure.PressureAltitude;
import org.u2sa.sim.sensor.NoiseStreams;

/** A barometer in the standard atmosphere, offset by the day's sea-level pressure. */
public final class SimulatedBarometer extends NoisyDevice<Pressure> implements Barometer {
  private final double biasPa;
  private final double qnhPa;
  private final DoubleSupplier altitudeM;

  /**
   * Uses the random stream {@code barometer}.
   *
   * @param errors in Pa
   * @param qnhPa pressure at sea level [Pa]
   * @param altitudeM current altitude above mean sea level [m]
   */
  public SimulatedBarometer(
      SensorErrors errors, double qnhPa, NoiseStreams streams, DoubleSupplier altitudeM) {
    super(errors, streams, "barometer");
    this.qnhPa = qnhPa;
    this.altitudeM = altitudeM;
    biasPa = bias();
  }

  @Override
  protected Pressure measure(double timeS, long measuredAtMicros) {
    double altitude = altitudeM.getAsDouble();
    return new Pressure(
        measuredAtMicros,
        noisy(PressureAltitude.pascalsAt(altitude, qnhPa) + biasPa),
        OptionalDouble.of(PressureAltitude.temperatureAt(altitude)));
  }
}
