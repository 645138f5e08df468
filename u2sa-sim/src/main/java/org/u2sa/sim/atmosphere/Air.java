package org.u2sa.sim.atmosphere;

/**
 * Air at rest at one altitude.
 *
 * @param temperatureK static temperature [K]
 * @param pressurePa static pressure [Pa]
 * @param densityKgPerM3 density [kg/m³]
 * @param soundSpeedMps speed of sound [m/s]
 */
public record Air(
    double temperatureK, double pressurePa, double densityKgPerM3, double soundSpeedMps) {

  /**
   * Calibrated airspeed [m/s] that an ideal pitot instrument shows in this air: subsonic impact
   * pressure read back at sea-level standard conditions (Gracey, NASA RP-1046, chapter 3).
   *
   * @param trueAirspeedMps true airspeed [m/s], at least 0 and below the speed of sound
   */
  public double calibratedAirspeedMps(double trueAirspeedMps) {
    double mach = trueAirspeedMps / soundSpeedMps;
    double impactPa = pressurePa * (StrictMath.pow(1.0 + 0.2 * mach * mach, 3.5) - 1.0);
    double ratio =
        StrictMath.pow(impactPa / StandardAtmosphere.SEA_LEVEL_PRESSURE_PA + 1.0, 2.0 / 7.0) - 1.0;
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
