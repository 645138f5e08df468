package org.u2sa.device.pressure;

import org.u2sa.messages.frame.Gravity;

/**
 * Altitude and air data from static pressure in the ICAO standard atmosphere (ICAO Doc 7488/3; ISO
 * 2533), −5…20 km.
 */
public final class PressureAltitude {
  /** Pressure at sea level [Pa]. */
  public static final double SEA_LEVEL_PA = 101_325.0;

  private static final double SEA_LEVEL_K = 288.15;
  private static final double LAPSE_K_PER_M = 0.0065;
  private static final double GAS_CONSTANT = 287.05287; // dry air [J/(kg K)]
  private static final double EXPONENT = LAPSE_K_PER_M * GAS_CONSTANT / Gravity.STANDARD_MPS2;
  private static final double TROPOPAUSE_M = 11_000.0;
  private static final double TROPOPAUSE_K = SEA_LEVEL_K - LAPSE_K_PER_M * TROPOPAUSE_M;
  private static final double TROPOPAUSE_PA =
      SEA_LEVEL_PA * StrictMath.pow(TROPOPAUSE_K / SEA_LEVEL_K, 1.0 / EXPONENT);
  private static final double EARTH_RADIUS_M = 6_356_766.0; // nominal radius of Doc 7488

  private PressureAltitude() {}

  /**
   * Pressure altitude [m], as an altimeter set to 1013.25 hPa shows (geopotential), of a static
   * pressure [Pa].
   */
  public static double standardM(double pascals) {
    if (pascals < TROPOPAUSE_PA) { // isothermal, ibid.
      double scaleM = GAS_CONSTANT * TROPOPAUSE_K / Gravity.STANDARD_MPS2;
      return TROPOPAUSE_M + scaleM * StrictMath.log(TROPOPAUSE_PA / pascals);
    }
    // H = T₀/β · (1 − (p/p₀)^(βR/g)) (Doc 7488/3, pressure against geopotential altitude)
    return SEA_LEVEL_K / LAPSE_K_PER_M * (1.0 - StrictMath.pow(pascals / SEA_LEVEL_PA, EXPONENT));
  }

  /**
   * Geometric altitude above mean sea level [m] for an altimeter setting (ICAO Doc 8168, definition
   * of QNH).
   *
   * @param pascals static pressure [Pa], positive
   * @param qnhPa pressure at sea level today [Pa]
   */
  public static double altitudeM(double pascals, double qnhPa) {
    return aboveSeaM(standardM(pascals), qnhPa);
  }

  /** Like {@link #altitudeM}, from a pressure altitude [m], as reported by transponders. */
  public static double aboveSeaM(double standardM, double qnhPa) {
    double geopotentialM = standardM - standardM(qnhPa);
    return EARTH_RADIUS_M * geopotentialM / (EARTH_RADIUS_M - geopotentialM);
  }

  /**
   * Static pressure [Pa] at a geometric altitude above mean sea level [m]; the inverse of {@link
   * #altitudeM}.
   */
  public static double pascalsAt(double altitudeM, double qnhPa) {
    return standardPa(geopotentialM(altitudeM) + standardM(qnhPa));
  }

  /**
   * Pressure at sea level [Pa] on a day on which a pressure [Pa] was measured at an altitude [m].
   */
  public static double qnhOf(double pascals, double altitudeM) {
    return standardPa(standardM(pascals) - geopotentialM(altitudeM));
  }

  private static double standardPa(double standardM) {
    if (standardM > TROPOPAUSE_M) {
      double scaleM = GAS_CONSTANT * TROPOPAUSE_K / Gravity.STANDARD_MPS2;
      return TROPOPAUSE_PA * StrictMath.exp((TROPOPAUSE_M - standardM) / scaleM);
    }
    double share = 1.0 - LAPSE_K_PER_M * standardM / SEA_LEVEL_K;
    return SEA_LEVEL_PA * StrictMath.pow(share, 1.0 / EXPONENT);
  }

  private static double geopotentialM(double altitudeM) {
    return EARTH_RADIUS_M * altitudeM / (EARTH_RADIUS_M + altitudeM);
  }

  /** Temperature at an altitude above mean sea level in the standard atmosphere [K]. */
  public static double temperatureAt(double altitudeM) {
    return SEA_LEVEL_K - LAPSE_K_PER_M * Math.min(TROPOPAUSE_M, geopotentialM(altitudeM));
  }
}
