package org.u2sa.sim.device;

import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.device.port.Compass;
import org.u2sa.device.port.Heading;
import org.u2sa.sim.sensor.CompassModel;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.sensor.SpartonDevice;
import org.u2sa.sim.vehicle.VehicleTruth;

/** A magnetic compass with the errors of {@link CompassModel}. */
public final class SimulatedCompass extends SimulatedDevice<Heading> implements Compass {
  private static final int BAUD = 9600;

  private final CompassParameters parameters;
  private final NoiseStreams streams;
  private final CompassModel model;
  private final Supplier<VehicleTruth> truth;
  private final Supplier<CompassModel.Disturbance> field;

  /**
   * @param truth current state of the compass's vehicle
   * @param field current magnetic disturbance
   */
  public SimulatedCompass(
      CompassParameters parameters,
      NoiseStreams streams,
      Supplier<VehicleTruth> truth,
      Supplier<CompassModel.Disturbance> field) {
    super(parameters.rateHz(), 0.0);
    this.parameters = parameters;
    this.streams = streams;
    model = new CompassModel(parameters, streams);
    this.truth = truth;
    this.field = field;
  }

  @Override
  protected Heading measure(double timeS, long measuredAtMicros) {
    return new Heading(measuredAtMicros, model.sample(truth.get(), field.get()), false);
  }

  /** {@inheritDoc} Speaks the protocol of a Sparton compass at 9600 baud. */
  @Override
  public Optional<SerialInstrument> serial() {
    SpartonDevice device = new SpartonDevice(BAUD, parameters, streams);
    return Optional.of(
        new SerialInstrument(
            micros -> device.advance(micros, truth.get(), field.get()),
            device.line(),
            device::accept));
  }
}
