package org.u2sa.drivers.sonar;

import java.util.OptionalDouble;

/** MaxBotix sonar families: digits, unit and range. */
public enum SonarModel {
  /** LV-MaxSonar-EZ: R and 3 digits, inches, 6…254 (data sheet PD11832). */
  LV(3, 0.0254, 6.0, 254.0),
  /** XL-MaxSonar-EZ and -AE: R and 3 digits, centimetres, 20…765 (data sheet PD11838). */
  XL(3, 0.01, 20.0, 764.0),
  /** HRLV-MaxSonar-EZ: R and 4 digits, millimetres, 300…5000 (data sheet PD11721). */
  HR(4, 0.001, 300.0, 4999.0);

  private static final double ROUNDING = 0.5;

  private final int digits;
  private final double unitM;
  private final double nearest;
  private final double farthest;

  SonarModel(int digits, double unitM, double nearest, double farthest) {
    this.digits = digits;
    this.unitM = unitM;
    this.nearest = nearest;
    this.farthest = farthest;
  }

  int digits() {
    return digits;
  }

  /**
   * Range [m] for a count in the family's unit; clamped to the minimum range, empty beyond the
   * maximum.
   */
  public OptionalDouble rangeM(double count) {
    if (!(count >= 0.0) || count > farthest + ROUNDING) {
      return OptionalDouble.empty();
    }
    return OptionalDouble.of(Math.max(nearest, count) * unitM);
  }
}
