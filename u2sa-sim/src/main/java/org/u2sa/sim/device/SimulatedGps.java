package org.u2sa.sim.device;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.u2sa.device.port.GpsFix;
import org.u2sa.device.port.GpsReceiver;
import org.u2sa.sim.sensor.GpsModel;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.sensor.GpsSample;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.sensor.UbloxReceiver;
import org.u2sa.sim.sensor.UbloxSettings;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/** A satellite receiver with the errors of {@link GpsModel}. */
public final class SimulatedGps extends SimulatedDevice<GpsFix> implements GpsReceiver {
  private final GpsParameters parameters;
  private final LocalPlane plane;
  private final NoiseStreams streams;
  private final GpsModel model;
  private final Supplier<VehicleTruth> truth;
  private final BooleanSupplier blocked;

  /**
   * @param truth current state of the receiver's vehicle
   * @param blocked whether the sky is currently blocked
   */
  public SimulatedGps(
      GpsParameters parameters,
      LocalPlane plane,
      NoiseStreams streams,
      Supplier<VehicleTruth> truth,
      BooleanSupplier blocked) {
    super(parameters.rateHz(), parameters.latencyS());
    this.parameters = parameters;
    this.plane = plane;
    this.streams = streams;
    model = new GpsModel(parameters, plane, streams);
    this.truth = truth;
    this.blocked = blocked;
  }

  @Override
  protected GpsFix measure(double timeS, long measuredAtMicros) {
    GpsSample sample = model.sample(timeS, truth.get(), blocked.getAsBoolean());
    return sample.valid()
        ? new GpsFix(
            measuredAtMicros,
            sample.latitudeDeg(),
            sample.longitudeDeg(),
            OptionalDouble.of(sample.altitudeM()),
            OptionalDouble.of(sample.eastMps()),
            OptionalDouble.of(sample.northMps()),
            OptionalDouble.of(sample.upMps()),
            OptionalDouble.of(sample.horizontalSigmaM()),
            OptionalDouble.of(sample.verticalSigmaM()),
            sample.satellites(),
            true)
        : GpsFix.none(measuredAtMicros, sample.satellites());
  }

  /** {@inheritDoc} Speaks that of a u-blox receiver with factory settings: NMEA at 9600 baud. */
  @Override
  public Optional<SerialInstrument> serial() {
    UbloxReceiver receiver =
        new UbloxReceiver(
            UbloxSettings.factory(), parameters, plane, SerialInstrument.UTC, streams);
    return Optional.of(
        new SerialInstrument(
            micros -> receiver.advance(micros, truth.get(), blocked.getAsBoolean()),
            receiver.line(),
            receiver::accept));
  }
}
