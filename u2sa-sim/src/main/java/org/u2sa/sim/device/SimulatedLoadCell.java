package org.u2sa.sim.device;

import java.util.function.DoubleSupplier;
import org.u2sa.device.payload.LoadCell;
import org.u2sa.sim.sensor.NoiseStreams;

/** A load cell behind a thruster. */
public final class SimulatedLoadCell extends NoisyDevice<LoadCell.Load> implements LoadCell {
  private final DoubleSupplier thrustN;
  private final double biasN;

  /**
   * Uses the random stream {@code load cell}.
   *
   * @param errors in N
   * @param thrustN current thrust, forward positive [N]
   */
  public SimulatedLoadCell(SensorErrors errors, NoiseStreams streams, DoubleSupplier thrustN) {
    super(errors, streams, "load cell");
    this.thrustN = thrustN;
    biasN = bias();
  }

  @Override
  protected Load measure(double timeS, long measuredAtMicros) {
    return new Load(measuredAtMicros, noisy(thrustN.getAsDouble() + biasN));
  }
}
