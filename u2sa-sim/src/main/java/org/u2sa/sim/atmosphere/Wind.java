package org.u2sa.sim.atmosphere;

import org.u2sa.sim.motion.Arguments;

/**
 * The wind of a simulation: a steady part and Dryden gusts, repeatable from its seed.
 *
 * @param fromRad direction that the wind blows from, clockwise from true north [rad]
 * @param speedMps steady speed [m/s], at least 0: at 6 m above ground if {@code heightProfile},
 *     else everywhere
 * @param heightProfile whether the steady wind grows with height by the logarithmic law of
 *     MIL-F-8785C, 3.7.3.4
 * @param gustSigmaMps root mean square of the vertical gusts [m/s], at least 0; MIL-F-8785C takes a
 *     tenth of the wind at 6 m: 0.8 is light, 1.5 moderate, 2.3 severe
 * @param seed seed of the gusts
 */
public record Wind(
    double fromRad, double speedMps, boolean heightProfile, double gustSigmaMps, long seed) {

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

  /** No wind at all. */
  public static Wind calm() {
    return new Wind(0.0, 0.0, false, 0.0, 0L);
  }

  /** The same wind at every height, without gusts. */
  public static Wind constant(double fromRad, double speedMps) {
    return new Wind(fromRad, speedMps, false, 0.0, 0L);
  }

  /** A wind that grows with height, and the gusts that MIL-F-8785C expects with it. */
  public static Wind turbulent(double fromRad, double speedAt6MetresMps, long seed) {
    return new Wind(fromRad, speedAt6MetresMps, true, SIGMA_PER_WIND * speedAt6MetresMps, seed);
  }

  /** The same wind at every height, with the gusts that MIL-F-8785C expects with it. */
  public static Wind gusty(double fromRad, double speedMps, long seed) {
    return constant(fromRad, speedMps).withGusts(SIGMA_PER_WIND * speedMps, seed);
  }

  /** This wind, growing with height or the same at every height. */
  public Wind withShear(boolean growsWithHeight) {
    return new Wind(fromRad, speedMps, growsWithHeight, gustSigmaMps, seed);
  }

  /** This wind with other gusts. */
  public Wind withGusts(double sigmaMps, long gustSeed) {
    return new Wind(fromRad, speedMps, heightProfile, sigmaMps, gustSeed);
  }
}
