package org.u2sa.device.port;

/**
 * A scanning sonar that reports echo strength over distance, one direction after another. A sonar
 * that only reports the distance of the nearest echo is a {@link RangeFinder}.
 */
public interface Sonar extends Device<Sonar.Ping> {
  /**
   * One ping and its echo.
   *
   * @param measuredAtMicros arrival of its bytes
   * @param bearingRad direction of the ping from straight ahead of the sonar, positive to the left
   *     [rad], −π…π
   * @param metresPerSample sample spacing [m], positive
   * @param strengths echo strengths as unsigned bytes, the first at half a sample's distance; not
   *     to be modified
   */
  record Ping(long measuredAtMicros, double bearingRad, double metresPerSample, byte[] strengths)
      implements Reading {
    /** Distance of a sample's centre [m]. */
    public double rangeM(int sample) {
      return (sample + 0.5) * metresPerSample;
    }

    /** Maximum range of the ping [m]. */
    public double reachM() {
      return strengths.length * metresPerSample;
    }
  }
}
