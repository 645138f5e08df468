package org.u2sa.sim.camera;

import org.u2sa.sim.motion.Arguments;

/**
 * Appearance of a body of water.
 *
 * @param surfaceM height of its still surface [m]
 * @param depthM depth of its floor below the surface [m]
 * @param scattering scattering coefficient, the same for all channels [1/m]; 0.05 in a pool
 * @param windMps wind that roughens the surface [m/s]
 * @param particles suspended particles per image
 */
public record WaterLook(
    double surfaceM,
    double depthM,
    WaterType type,
    double scattering,
    double windMps,
    int particles) {
  private static final double FORWARD = 0.5; // share of scatter that stays in a pixel

  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public WaterLook {
    Arguments.requireFinite("water surface", surfaceM);
    Arguments.requireInside("depth of the water", depthM, 0.1, 12_000.0);
    Arguments.requireInside("scattering", scattering, 0.0, 10.0);
    Arguments.requireInside("wind", windMps, 0.0, 40.0);
    Arguments.requireInside("particles", particles, 0.0, 10_000.0);
  }

  /** A lake or a harbour on a day with some wind. */
  public static WaterLook open(double windMps) {
    return new WaterLook(0.0, 6.0, WaterType.C3, 0.4, windMps, 0);
  }

  /** A pool of 5 m. */
  public static WaterLook pool() {
    return new WaterLook(0.0, 5.0, WaterType.IB, 0.06, 1.0, 40);
  }

  /** Attenuation of a beam that carries an image [1/m]. */
  public float beam(int channel) {
    return (float) (type.diffuse(channel) + FORWARD * scattering);
  }

  /**
   * Radiance of infinite water seen horizontally, relative to a white surface facing up at that
   * depth.
   */
  float veil(int channel) {
    return (float) (0.35 * FORWARD * scattering / beam(channel));
  }

  /** Brightness of light returned from below the surface, relative to a white level surface. */
  float upwelling(int channel) {
    // R = 0.33 b_b / a (Morel and Prieur, Limnol. Oceanogr. 22, 1977), b_b = 0.018 b (Petzold 1972)
    return (float) (0.33 * 0.018 * scattering / type.diffuse(channel)) + 0.004f;
  }

  /** Mean square slope of the surface (Cox and Munk, J. Opt. Soc. Am. 44, 1954). */
  double slopeVariance() {
    return 0.003 + 0.00512 * windMps;
  }
}
