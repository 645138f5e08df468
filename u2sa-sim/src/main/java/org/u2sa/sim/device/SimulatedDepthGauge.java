package org.u2sa.sim.device;

import java.util.OptionalDouble;
import java.util.function.DoubleSupplier;
import org.u2sa.device.port.DepthGauge;
import org.u2sa.device.port.Pressure;
import org.u2sa.device.pressure.PressureAltitude;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.sim.sensor.NoiseStreams;

/** A pressure sensor in still water. */
public final class SimulatedDepthGauge extends NoisyDevice<Pressure> implements DepthGauge {
  private static final double WATER_K = 288.15;

  private final double biasPa;
  private final double densityKgPerM3;
  private final DoubleSupplier depthM;

  /**
   * Uses the random stream {@code depth gauge}.
   *
   * @param errors in Pa
   * @param densityKgPerM3 water density [kg/m³]
   * @param depthM current depth below the surface [m]; negative in air
   */
  public SimulatedDepthGauge(
      SensorErrors errors, double densityKgPerM3, NoiseStreams streams, DoubleSupplier depthM) {
    super(errors, streams, "depth gauge");
    this.densityKgPerM3 = densityKgPerM3;
    this.depthM = depthM;
    biasPa = bias();
  }

  @Override
  protected Pressure measure(double timeS, long measuredAtMicros) {
    double waterPa = densityKgPerM3 * Gravity.STANDARD_MPS2 * Math.max(0.0, depthM.getAsDouble());
    return new Pressure(
        measuredAtMicros,
        noisy(PressureAltitude.SEA_LEVEL_PA + waterPa + biasPa),
        OptionalDouble.of(WATER_K));
  }
}
