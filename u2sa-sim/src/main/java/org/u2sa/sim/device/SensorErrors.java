package org.u2sa.sim.device;

import org.u2sa.sim.motion.Arguments;

/**
 * What is wrong with a simulated sensor of one kind of number, in that number's unit.
 *
 * @param rateHz readings a second
 * @param latencyS from a measurement to its arrival [s]
 * @param sigma standard deviation of each reading's white noise
 * @param biasSigma standard deviation of the bias, drawn once
 * @param lost share of readings that never arrive, 0…1
 */
public record SensorErrors(
    double rateHz, double latencyS, double sigma, double biasSigma, double lost) {
  /**
   * @throws IllegalArgumentException if a value is outside its range
   */
  public SensorErrors {
    Arguments.requireInside("latency", latencyS, 0.0, 60.0);
    Arguments.requireInside("noise", sigma, 0.0, 1e6);
    Arguments.requireInside("bias", biasSigma, 0.0, 1e6);
    Arguments.requireInside("share of lost readings", lost, 0.0, 1.0);
  }

  /** Bosch's BMP388 by its data sheet: 3 Pa of noise, ±50 Pa of absolute accuracy. */
  public static SensorErrors barometer() {
    return new SensorErrors(20.0, 0.02, 3.0, 25.0, 0.0);
  }

  /** Blue Robotics' Bar30 (MS5837-30BA): 20 Pa of resolution, some 5 kPa of absolute accuracy. */
  public static SensorErrors depthGauge() {
    return new SensorErrors(10.0, 0.02, 20.0, 1_000.0, 0.0);
  }

  /** A differential sensor such as MS4525DO, zeroed before the start: 3 Pa of noise [Pa]. */
  public static SensorErrors pitotTube() {
    return new SensorErrors(20.0, 0.02, 3.0, 2.0, 0.0);
  }

  /**
   * Others' positions by ADS-B, of category NACp 9 (30 m in 95 %), with a tenth of the reports lost
   * [m].
   */
  public static SensorErrors transponder() {
    return new SensorErrors(1.0, 0.2, 12.0, 0.0, 0.1);
  }

  /** A small Doppler log: 1 cm/s of noise, a tenth of the readings lost [m/s]. */
  public static SensorErrors velocityLog() {
    return new SensorErrors(5.0, 0.1, 0.01, 0.002, 0.1);
  }
}
