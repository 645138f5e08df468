package org.u2sa.sim.atmosphere;

import org.u2sa.sim.motion.Arguments;

/**
 * Wind profile: increase of the mean wind speed with height above ground.
 *
 * @param law its formula
 * @param parameter roughness length of the logarithmic law [m], or exponent of the power law
 * @param referenceM height of the stated speed [m]
 * @param lowestM lower limit [m], below which the wind no longer changes
 */
public record WindProfile(Law law, double parameter, double referenceM, double lowestM) {
  private static final double FOOT_M = 0.3048;
  private static final double HIGHEST_M = 1_000.0 * FOOT_M;

  /** Formula of a profile. */
  public enum Law {
    /** The same wind at every height. */
    UNIFORM,
    /** ln(h / z₀) / ln(h₀ / z₀). */
    LOGARITHMIC,
    /** (h / h₀) to the power of an exponent. */
    POWER
  }

  /** The same wind at every height. */
  public static WindProfile uniform() {
    return new WindProfile(Law.UNIFORM, 0.0, 1.0, 0.0);
  }

  /** The logarithmic law of MIL-F-8785C, 3.7.3.4, category C flight phases: from 6 m. */
  public static WindProfile military() {
    return new WindProfile(Law.LOGARITHMIC, 0.15 * FOOT_M, 20.0 * FOOT_M, 3.0 * FOOT_M);
  }

  /**
   * The logarithmic law over ground of any roughness.
   *
   * @param roughnessM 0.0002 over the sea, 0.03 over grass, 1 in towns [m]
   * @throws IllegalArgumentException if a value is outside its range
   */
  public static WindProfile logarithmic(double roughnessM, double referenceM) {
    Arguments.requireInside("roughness [m]", roughnessM, 1e-5, 3.0);
    Arguments.requireInside("height of the wind speed [m]", referenceM, 3.1 * roughnessM, 300.0);
    return new WindProfile(Law.LOGARITHMIC, roughnessM, referenceM, 3.0 * roughnessM);
  }

  /**
   * The power law.
   *
   * @param exponent 0.1 over the sea, 1/7 over open land, 0.3 in towns
   * @throws IllegalArgumentException if a value is outside its range
   */
  public static WindProfile power(double exponent, double referenceM) {
    Arguments.requireInside("exponent of the wind", exponent, 0.0, 1.0);
    Arguments.requireInside("height of the wind speed [m]", referenceM, 0.1, 300.0);
    return new WindProfile(Law.POWER, exponent, referenceM, 0.1);
  }

  /** Wind at a height above ground, as a fraction of the stated speed; constant above 1000 ft. */
  public double share(double heightM) {
    double height = Math.min(HIGHEST_M, Math.max(lowestM, heightM));
    return switch (law) {
      case UNIFORM -> 1.0;
      case LOGARITHMIC ->
          StrictMath.log(height / parameter) / StrictMath.log(referenceM / parameter);
      case POWER -> StrictMath.pow(height / referenceM, parameter);
    };
  }
}
