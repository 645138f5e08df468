package org.u2sa.sim.device;

import java.util.Random;
import org.u2sa.device.port.Device;
import org.u2sa.sim.sensor.NoiseStreams;

/** A simulated device with {@link SensorErrors}. */
public abstract class NoisyDevice<R extends Device.Reading> extends SimulatedDevice<R> {
  private final SensorErrors errors;
  private final Random noise;

  /** Uses the random stream {@code name}. */
  protected NoisyDevice(SensorErrors errors, NoiseStreams streams, String name) {
    super(errors.rateHz(), errors.latencyS());
    this.errors = errors;
    noise = streams.of(name);
  }

  /** Draws a constant bias for one quantity. */
  protected final double bias() {
    return errors.biasSigma() * noise.nextGaussian();
  }

  /** Adds white noise to a value. */
  protected final double noisy(double exact) {
    return exact + errors.sigma() * gaussian();
  }

  /** Draws from the standard normal distribution. */
  protected final double gaussian() {
    return noise.nextGaussian();
  }

  /** Draws from 0…1, uniformly. */
  protected final double uniform() {
    return noise.nextDouble();
  }

  @Override
  final boolean isDropped() {
    return errors.lost() > 0.0 && noise.nextDouble() < errors.lost();
  }
}
