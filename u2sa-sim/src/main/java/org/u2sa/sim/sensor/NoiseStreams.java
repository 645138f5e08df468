package org.u2sa.sim.sensor;

import java.util.Random;

/**
 * The random streams of a run: one for each name, all from one seed. A sensor that is added takes a
 * stream of its own, so that no other sensor's noise changes.
 */
public final class NoiseStreams {
  private static final long GOLDEN = 0x9E3779B97F4A7C15L;

  private final long seed;

  public NoiseStreams(long seed) {
    this.seed = seed;
  }

  /**
   * A new generator for a sensor, for one thread at a time; the same name gives the same numbers.
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
