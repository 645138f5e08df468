package org.u2sa.sim.camera;

import java.util.Random;

/**
 * Slopes of the ripples visible in reflections: sinusoids in random directions with the mean square
 * slope of Cox and Munk, each with the phase speed of deep water. Immutable.
 */
final class WaveSlopes {
  private static final int COUNT = 14;
  private static final double SHORTEST_M = 0.12;
  private static final double RATIO = 1.38; // ratio of successive wavelengths
  private static final double GRAVITY = 9.81;

  private final float[] east = new float[COUNT]; // wave number [rad/m]
  private final float[] north = new float[COUNT];
  private final float[] speed = new float[COUNT]; // [rad/s]
  private final float[] phase = new float[COUNT];
  private final float[] length = new float[COUNT];
  private final float steep; // slope amplitude of each

  WaveSlopes(double slopeVariance, long seed) {
    Random random = new Random(seed);
    double main = 2.0 * Math.PI * random.nextDouble();
    double lengthM = SHORTEST_M;
    for (int i = 0; i < COUNT; i++) {
      double way = main + 1.2 * (random.nextDouble() + random.nextDouble() - 1.0);
      double number = 2.0 * Math.PI / lengthM;
      east[i] = (float) (number * StrictMath.sin(way));
      north[i] = (float) (number * StrictMath.cos(way));
      speed[i] = (float) Math.sqrt(GRAVITY * number); // deep water (Airy)
      phase[i] = (float) (2.0 * Math.PI * random.nextDouble());
      length[i] = (float) lengthM;
      lengthM *= RATIO;
    }
    steep = (float) Math.sqrt(2.0 * slopeVariance / COUNT);
  }

  /**
   * Slope at a position.
   *
   * @param pixelM extent of a pixel there; shorter waves only add variance [m]
   * @param into receives the slopes to the east and north and the variance within the pixel
   */
  void at(float x, float y, double timeS, float pixelM, float[] into) {
    float slopeEast = 0.0f;
    float slopeNorth = 0.0f;
    float variance = 4.0e-4f; // capillary waves
    for (int i = 0; i < COUNT; i++) {
      if (length[i] < 2.0f * pixelM) {
        variance += 0.5f * steep * steep;
        continue;
      }
      double angle = east[i] * x + north[i] * y - speed[i] * timeS + phase[i];
      float slope = steep * (float) Math.cos(angle);
      slopeEast += slope * east[i] * length[i] * (float) (0.5 / Math.PI);
      slopeNorth += slope * north[i] * length[i] * (float) (0.5 / Math.PI);
    }
    into[0] = slopeEast;
    into[1] = slopeNorth;
    into[2] = variance;
  }
}
