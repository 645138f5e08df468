package org.u2sa.sim.sensor;

import java.util.Random;
import org.u2sa.sim.motion.Arguments;

/**
 * A battery's voltage behind a divider, as an analog input gets it: resistors that are not what is
 * printed on them, and noise.
 */
public final class VoltmeterModel {
  private static final double TOLERANCE = 0.01; // of common resistors

  private final double ratio;
  private final double noiseV;
  private final Random noise;

  /**
   * Takes the stream {@code voltmeter}.
   *
   * @param ratio voltage at the input by the battery's, 0…1
   * @param noiseV at the input [V]
   */
  public VoltmeterModel(double ratio, double noiseV, NoiseStreams streams) {
    Arguments.requireInside("divider", ratio, 1e-3, 1.0);
    Arguments.requireInside("noise of the voltmeter", noiseV, 0.0, 1.0);
    this.noise = streams.of("voltmeter");
    this.ratio = ratio * (1.0 + TOLERANCE * (2.0 * noise.nextDouble() - 1.0));
    this.noiseV = noiseV;
  }

  /** Voltage at the input [V], 0 or more. */
  public double sample(double batteryV) {
    return Math.max(0.0, ratio * batteryV + noiseV * noise.nextGaussian());
  }
}
