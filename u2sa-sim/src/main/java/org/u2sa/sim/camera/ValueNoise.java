package org.u2sa.sim.camera;

/** Smooth 2-D lattice noise, −1…1, reproducible per seed and position (Perlin 1985). */
final class ValueNoise {
  private final int seed;

  ValueNoise(long seed) {
    this.seed = (int) (seed ^ seed >>> 32);
  }

  /** Value at a position in lattice cells. */
  double at(double x, double y) {
    int column = (int) Math.floor(x);
    int row = (int) Math.floor(y);
    double u = smooth(x - column);
    double v = smooth(y - row);
    double top = lattice(column, row) + u * (lattice(column + 1, row) - lattice(column, row));
    double low =
        lattice(column, row + 1) + u * (lattice(column + 1, row + 1) - lattice(column, row + 1));
    return top + v * (low - top);
  }

  /** Fractal sum of octaves, each twice the frequency and half the amplitude, about −1…1. */
  double fractal(double x, double y, int octaves) {
    double sum = 0.0;
    double strength = 0.5;
    double scale = 1.0;
    for (int i = 0; i < octaves; i++) {
      sum += strength * at(x * scale + 17.0 * i, y * scale - 29.0 * i);
      strength *= 0.5;
      scale *= 2.0;
    }
    return sum;
  }

  private static double smooth(double t) {
    return t * t * (3.0 - 2.0 * t);
  }

  private double lattice(int column, int row) {
    return (mix(column * 0x1F1F1F1F ^ row * 0x5BD1E995 ^ seed) & 0xFFFF) / 32767.5 - 1.0;
  }

  /** Integer hash (finaliser of MurmurHash3, Appleby 2011). */
  static int mix(int value) {
    int h = value ^ value >>> 16;
    h *= 0x85EBCA6B;
    h ^= h >>> 13;
    h *= 0xC2B2AE35;
    return h ^ h >>> 16;
  }
}
