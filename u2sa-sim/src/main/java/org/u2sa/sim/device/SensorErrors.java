package org.u2sa.sim.device;

import org.u2sa.sim.motion.Arguments;

/**
 * Error model of one measured quantity, in that quantity's unit.
 *
 * @param rateHz readings per second
 * @param latencyS from a measurement to its arrival [s]
 * @param sigma standard deviation of each reading's white noise
 * @param biasSigma standard deviation of the constant bias, drawn once
 * @param lost fraction of lost readings, 0…1
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

  /** Bosch BMP388, data sheet: 3 Pa noise, ±50 Pa absolute accuracy. */
  public static SensorErrors barometer() {
    return new SensorErrors(20.0, 0.02, 3.0, 25.0, 0.0);
  }

  /** Blue Robotics Bar30 (MS5837-30BA): 20 Pa resolution, about 5 kPa absolute accuracy. */
  public static SensorErrors depthGauge() {
    return new SensorErrors(10.0, 0.02, 20.0, 1_000.0, 0.0);
  }

  /** Differential pressure sensor such as the MS4525DO, zeroed before start: 3 Pa noise. */
  public static SensorErrors pitotTube() {
    return new SensorErrors(20.0, 0.02, 3.0, 2.0, 0.0);
  }

  /** A small Doppler velocity log: 1 cm/s noise, 10 % of readings lost [m/s]. */
  public static SensorErrors velocityLog() {
    return new SensorErrors(5.0, 0.1, 0.01, 0.002, 0.1);
  }
}
