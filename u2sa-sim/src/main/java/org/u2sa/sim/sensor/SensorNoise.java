package org.u2sa.sim.sensor;

import java.util.Random;

/**
 * Bit-identical, unsynchronised {@link Random}, because its atomic updates and lock cost more than
 * the numbers. Not thread-safe.
 */
final class SensorNoise extends Random {
  private static final long serialVersionUID = 1L;
  private static final long MULTIPLIER = 0x5DEECE66DL; // from Random's documentation
  private static final long ADDEND = 0xBL;
  private static final long MASK = (1L << 48) - 1;

  private long state;
  private double second; // second value of a Gaussian pair
  private boolean hasSecond;

  SensorNoise(long seed) {
    super(seed); // calls setSeed
  }

  @Override
  public void setSeed(long seed) {
    state = (seed ^ MULTIPLIER) & MASK;
    hasSecond = false;
  }

  @Override
  protected int next(int bits) {
    state = (state * MULTIPLIER + ADDEND) & MASK;
    return (int) (state >>> 48 - bits);
  }

  /** Polar method of Box, Muller and Marsaglia, as in {@link Random#nextGaussian()}. */
  @Override
  public double nextGaussian() {
    if (hasSecond) {
      hasSecond = false;
      return second;
    }
    double x;
    double y;
    double square;
    do {
      x = 2.0 * nextDouble() - 1.0;
      y = 2.0 * nextDouble() - 1.0;
      square = x * x + y * y;
    } while (square >= 1.0 || square == 0.0);
    double scale = StrictMath.sqrt(-2.0 * StrictMath.log(square) / square);
    second = y * scale;
    hasSecond = true;
    return x * scale;
  }
}
