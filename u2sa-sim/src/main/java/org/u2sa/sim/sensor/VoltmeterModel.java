package org.u2sa.sim.sensor;

import java.util.Random;
import org.u2sa.sim.motion.Arguments;

/** Battery voltage at an analog input behind a divider, with resistor tolerance and noise. */
public final class VoltmeterModel {
  private static final double TOLERANCE = 0.01; // relative tolerance of common resistors

  private final double ratio;
  private final double noiseV;
  private final Random noise;

  /**
   * Uses the random stream {@code voltmeter}.
   *
   * @param ratio input voltage relative to the battery voltage, 0…1
   * @param noiseV noise at the input [V]
   */
  public VoltmeterModel(double ratio, double noiseV, NoiseStreams streams) {
    Arguments.requireInside("divider", ratio, 1e-3, 1.0);
    Arguments.requireInside("noise of the voltmeter", noiseV, 0.0, 1.0);
    this.noise = streams.of("voltmeter");
    this.ratio = ratio * (1.0 + TOLERANCE * (2.0 * noise.nextDouble() - 1.0));
    this.noiseV = noiseV;
  }

  /** Voltage at the input [V], at least 0. */
  public double sample(double batteryV) {
    return Math.max(0.0, ratio * batteryV + noiseV * noise.nextGaussian());
  }
}
