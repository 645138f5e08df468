package org.u2sa.device;

/**
 * A sonar that says how strong the echo is at each distance, in one direction after another. One
 * that only says the distance of the nearest echo is a {@link RangeFinder}.
 */
public interface Sonar extends Device<Sonar.Ping> {
  /**
   * One ping and its echo.
   *
   * @param measuredAtMicros when its bytes arrived
   * @param bearingRad where it went, from straight ahead of the sonar, to the left positive [rad],
   *     −π…π
   * @param metresPerSample from each sample to the next [m], positive
   * @param strengths of the echo as unsigned bytes, the first at half a sample's distance; not to
   *     be changed
   */
  record Ping(long measuredAtMicros, double bearingRad, double metresPerSample, byte[] strengths)
      implements Reading {
    /** Distance of a sample's middle [m]. */
    public double rangeM(int sample) {
      return (sample + 0.5) * metresPerSample;
    }

    /** Farthest distance that it could hear [m]. */
    public double reachM() {
      return strengths.length * metresPerSample;
    }
  }
}
