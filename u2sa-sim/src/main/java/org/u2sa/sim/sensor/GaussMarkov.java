package org.u2sa.sim.sensor;

import java.util.Random;

/**
 * A bias that wanders but stays bounded: the first-order Gauss-Markov process (Gelb, Applied
 * Optimal Estimation, chapter 2), discretised exactly, stationary from the beginning.
 */
final class GaussMarkov {
  private final double sigma;
  private final double tauS;
  private final Random noise;
  private double value;

  /**
   * @param sigma its standard deviation
   * @param tauS time in which it forgets all but 1/e of its value [s]
   */
  GaussMarkov(double sigma, double tauS, Random noise) {
    this.sigma = sigma;
    this.tauS = tauS;
    this.noise = noise;
    this.value = sigma * noise.nextGaussian();
  }

  double step(double dtS) {
    double kept = StrictMath.exp(-dtS / tauS);
    value = kept * value + sigma * StrictMath.sqrt(1.0 - kept * kept) * noise.nextGaussian();
    return value;
  }
}
