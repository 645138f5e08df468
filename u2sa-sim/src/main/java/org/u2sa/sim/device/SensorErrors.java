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
}
