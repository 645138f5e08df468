package org.u2sa.sim.device;

import java.util.OptionalDouble;
import java.util.Random;
import java.util.function.DoubleSupplier;
import org.u2sa.device.port.RangeFinder;
import org.u2sa.sim.sensor.NoiseStreams;

/** A single-beam range finder with white noise, such as an ultrasonic sensor. */
public final class SimulatedRangeFinder extends SimulatedDevice<RangeFinder.Distance>
    implements RangeFinder {
  private final double farthestM;
  private final double sigmaM;
  private final DoubleSupplier distance;
  private final Random noise;

  /**
   * Uses the random stream {@code name}.
   *
   * @param rateHz measurements per second
   * @param farthestM maximum range [m]
   * @param sigmaM standard deviation of a range [m]
   * @param distance current range to the nearest object in the beam [m]; infinite if there is none
   */
  public SimulatedRangeFinder(
      String name,
      double rateHz,
      double farthestM,
      double sigmaM,
      NoiseStreams streams,
      DoubleSupplier distance) {
    super(rateHz, 0.0);
    this.farthestM = farthestM;
    this.sigmaM = sigmaM;
    this.distance = distance;
    noise = streams.of(name);
  }

  @Override
  protected Distance measure(double timeS, long measuredAtMicros) {
    double rangeM = Math.max(0.0, distance.getAsDouble() + sigmaM * noise.nextGaussian());
    return new Distance(
        measuredAtMicros, rangeM <= farthestM ? OptionalDouble.of(rangeM) : OptionalDouble.empty());
  }
}
