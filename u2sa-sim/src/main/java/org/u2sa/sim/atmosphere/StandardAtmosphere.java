package org.u2sa.sim.atmosphere;

import org.u2sa.messages.frame.Gravity;

/**
 * The troposphere of the ICAO standard atmosphere (ICAO Doc 7488/3; identical to ISO 2533 up to 11
 * km).
 */
public final class StandardAtmosphere {
  /** Pressure at sea level [Pa]. */
  public static final double SEA_LEVEL_PRESSURE_PA = 101_325.0;

  /** Temperature at sea level [K]. */
  public static final double SEA_LEVEL_TEMPERATURE_K = 288.15;

  /** Density at sea level [kg/m³]. */
  public static final double SEA_LEVEL_DENSITY_KG_PER_M3 = 1.225;

  /** Speed of sound at sea level [m/s]. */
  public static final double SEA_LEVEL_SOUND_SPEED_MPS = 340.294;

  /** Altitude range of the model [m], from the Dead Sea to the top of the troposphere. */
  public static final double LOWEST_M = -1_000.0;

  /** Top of the troposphere [m geopotential]. */
  public static final double HIGHEST_M = 11_000.0;

  private static final double LAPSE_K_PER_M = -0.0065;
  private static final double GAS_CONSTANT = 287.05287; // dry air [J/(kg K)]
  private static final double HEAT_RATIO = 1.4;
  private static final double EARTH_RADIUS_M = 6_356_766.0; // nominal radius of ICAO Doc 7488

  private StandardAtmosphere() {}

  /**
   * Standard atmosphere at an altitude.
   *
   * @param altitudeM geometric altitude above mean sea level [m]; outside {@link #LOWEST_M}…{@link
   *     #HIGHEST_M} the nearer bound applies, so that a diverging simulation does not throw
   * @throws IllegalArgumentException if the altitude is not finite
   */
  public static Air at(double altitudeM) {
    if (!Double.isFinite(altitudeM)) {
      throw new IllegalArgumentException("altitude: " + altitudeM + " is not a number of metres");
    }
    double geopotentialM = EARTH_RADIUS_M * altitudeM / (EARTH_RADIUS_M + altitudeM);
    double bounded = Math.min(HIGHEST_M, Math.max(LOWEST_M, geopotentialM));
    double temperature = SEA_LEVEL_TEMPERATURE_K + LAPSE_K_PER_M * bounded;
    double exponent = -Gravity.STANDARD_MPS2 / (LAPSE_K_PER_M * GAS_CONSTANT);
    double pressure =
        SEA_LEVEL_PRESSURE_PA * StrictMath.pow(temperature / SEA_LEVEL_TEMPERATURE_K, exponent);
    return new Air(
        temperature,
        pressure,
        pressure / (GAS_CONSTANT * temperature),
        StrictMath.sqrt(HEAT_RATIO * GAS_CONSTANT * temperature));
  }

  /**
   * Static air properties at one altitude.
   *
   * @param temperatureK static temperature [K]
   * @param pressurePa static pressure [Pa]
   * @param densityKgPerM3 density [kg/m³]
   * @param soundSpeedMps speed of sound [m/s]
   */
  public record Air(
      double temperatureK, double pressurePa, double densityKgPerM3, double soundSpeedMps) {

    /**
     * Calibrated airspeed [m/s] of an ideal pitot instrument: subsonic impact pressure converted at
     * sea-level standard conditions (Gracey, NASA RP-1046, chapter 3).
     *
     * @param trueAirspeedMps true airspeed [m/s], at least 0 and below the speed of sound
     */
    public double calibratedAirspeedMps(double trueAirspeedMps) {
      double mach = trueAirspeedMps / soundSpeedMps;
      double impactPa = pressurePa * (StrictMath.pow(1.0 + 0.2 * mach * mach, 3.5) - 1.0);
      double ratio =
          StrictMath.pow(impactPa / StandardAtmosphere.SEA_LEVEL_PRESSURE_PA + 1.0, 2.0 / 7.0)
              - 1.0;
      return StandardAtmosphere.SEA_LEVEL_SOUND_SPEED_MPS * StrictMath.sqrt(5.0 * ratio);
    }

    /**
     * The inverse of {@link #calibratedAirspeedMps(double)}: true airspeed [m/s] from calibrated
     * [m/s].
     */
    public double trueAirspeedMps(double calibratedAirspeedMps) {
      double ratio = calibratedAirspeedMps / StandardAtmosphere.SEA_LEVEL_SOUND_SPEED_MPS;
      double impactPa =
          StandardAtmosphere.SEA_LEVEL_PRESSURE_PA
              * (StrictMath.pow(1.0 + 0.2 * ratio * ratio, 3.5) - 1.0);
      double mach2 = 5.0 * (StrictMath.pow(impactPa / pressurePa + 1.0, 2.0 / 7.0) - 1.0);
      return soundSpeedMps * StrictMath.sqrt(mach2);
    }
  }
}
