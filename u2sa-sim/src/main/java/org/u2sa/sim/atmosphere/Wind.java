package org.u2sa.sim.atmosphere;

import org.u2sa.sim.motion.Arguments;

/**
 * Simulated wind: a steady part plus Dryden gusts, reproducible from its seed.
 *
 * @param fromRad direction the wind blows from, clockwise from true north [rad]
 * @param speedMps steady speed [m/s], at least 0, at the reference height of the profile
 * @param profile growth of the steady wind with height
 * @param gustSigmaMps root mean square of the vertical gusts [m/s], at least 0; MIL-F-8785C takes a
 *     tenth of the wind at 6 m: 0.8 is light, 1.5 moderate, 2.3 severe
 * @param seed seed of the gusts
 */
public record Wind(
    double fromRad, double speedMps, WindProfile profile, double gustSigmaMps, long seed) {

  private static final double STRONGEST_MPS = 60.0;
  private static final double SIGMA_PER_WIND = 0.1; // MIL-F-8785C, 3.7.3.2: σw = 0.1 u20

  /**
   * @throws IllegalArgumentException if a number is not finite, or a speed negative or above 60 m/s
   */
  public Wind {
    Arguments.requireFinite("wind direction [rad]", fromRad);
    Arguments.requireInside("wind speed [m/s]", speedMps, 0.0, STRONGEST_MPS);
    Arguments.requireInside("gust sigma [m/s]", gustSigmaMps, 0.0, STRONGEST_MPS);
  }

  /** Calm air. */
  public static Wind calm() {
    return constant(0.0, 0.0);
  }

  /** Steady wind, equal at every height, without gusts. */
  public static Wind constant(double fromRad, double speedMps) {
    return new Wind(fromRad, speedMps, WindProfile.uniform(), 0.0, 0L);
  }

  /** Wind that increases with height, with the matching MIL-F-8785C gusts. */
  public static Wind turbulent(double fromRad, double speedAt6MetresMps, long seed) {
    return new Wind(
        fromRad,
        speedAt6MetresMps,
        WindProfile.military(),
        SIGMA_PER_WIND * speedAt6MetresMps,
        seed);
  }

  /** Wind equal at every height, with the matching MIL-F-8785C gusts. */
  public static Wind gusty(double fromRad, double speedMps, long seed) {
    return constant(fromRad, speedMps).withGusts(SIGMA_PER_WIND * speedMps, seed);
  }

  /** Copy with or without the profile of MIL-F-8785C. */
  public Wind withShear(boolean growsWithHeight) {
    return with(growsWithHeight ? WindProfile.military() : WindProfile.uniform());
  }

  /** Copy with a different profile. */
  public Wind with(WindProfile newProfile) {
    return new Wind(fromRad, speedMps, newProfile, gustSigmaMps, seed);
  }

  /** Copy with new gusts. */
  public Wind withGusts(double sigmaMps, long gustSeed) {
    return new Wind(fromRad, speedMps, profile, sigmaMps, gustSeed);
  }
}
