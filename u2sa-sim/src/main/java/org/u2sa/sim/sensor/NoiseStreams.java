package org.u2sa.sim.sensor;

import java.util.Random;

/**
 * Named random streams of a run, all derived from one seed. Adding a sensor does not change the
 * noise of others.
 */
public final class NoiseStreams {
  private static final long GOLDEN = 0x9E3779B97F4A7C15L;

  private final long seed;

  public NoiseStreams(long seed) {
    this.seed = seed;
  }

  /**
   * Creates the generator for a name; the same name gives the same sequence. The generator is not
   * thread-safe.
   */
  public Random of(String sensor) {
    long mixed = seed;
    for (int i = 0; i < sensor.length(); i++) {
      mixed = mix(mixed + GOLDEN + sensor.charAt(i));
    }
    return new SensorNoise(mixed);
  }

  /** Finaliser of SplitMix64 (Steele, Lea and Flood 2014). */
  private static long mix(long value) {
    long z = (value ^ (value >>> 30)) * 0xBF58476D1CE4E5B9L;
    z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
    return z ^ (z >>> 31);
  }
}
