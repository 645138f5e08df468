package org.u2sa.estimation.fusion;

/** Where a vehicle moves: what the filter assumes of motion that nothing measures. */
public enum MotionDomain {
  /** Wheels or tracks: level unless an inertial sensor says otherwise, no motion sideways. */
  GROUND(2.0, 0.7, 0.1, 0.5, 0.1, 1.0, 0.05),
  /**
   * Aircraft of any kind. The wind that they feel has gusts: about 1 m/s, of 1 to 10 s at their
   * speed (light turbulence of MIL-F-8785C), which σ √(2/τ) drives.
   */
  AIR(30.0, 2.0, 1.0, 0.3, 2.0, 5.0, 0.7),
  /** On the water. */
  WATER(5.0, 0.3, 0.1, 0.2, 0.3, 1.5, 0.02),
  /** In the water. */
  UNDERWATER(2.0, 0.3, 0.2, 0.2, 0.2, 1.0, 0.01);

  private final double speedSigmaMps;
  private final double accelerationNoise;
  private final double verticalNoise;
  private final double turnSigmaRadPerS;
  private final double sideSlipSigmaMps;
  private final double trackSpeedMps;
  private final double flowNoise;

  MotionDomain(
      double speedSigmaMps,
      double accelerationNoise,
      double verticalNoise,
      double turnSigmaRadPerS,
      double sideSlipSigmaMps,
      double trackSpeedMps,
      double flowNoise) {
    this.speedSigmaMps = speedSigmaMps;
    this.accelerationNoise = accelerationNoise;
    this.verticalNoise = verticalNoise;
    this.turnSigmaRadPerS = turnSigmaRadPerS;
    this.sideSlipSigmaMps = sideSlipSigmaMps;
    this.trackSpeedMps = trackSpeedMps;
    this.flowNoise = flowNoise;
  }

  /** Speed at the start, 1 σ of each component [m/s]. */
  double speedSigmaMps() {
    return speedSigmaMps;
  }

  /** By which the horizontal velocity wanders without an accelerometer [m/s per √s]. */
  double accelerationNoise() {
    return accelerationNoise;
  }

  /** The same of the vertical velocity [m/s per √s]. */
  double verticalNoise() {
    return verticalNoise;
  }

  /** Turn rate where none is measured, 1 σ [rad/s]. */
  double turnSigmaRadPerS() {
    return turnSigmaRadPerS;
  }

  /** Speed sideways, over ground or through the fluid, 1 σ [m/s]. */
  double sideSlipSigmaMps() {
    return sideSlipSigmaMps;
  }

  /** Speed from which the direction of motion may stand for an unknown heading [m/s]. */
  double trackSpeedMps() {
    return trackSpeedMps;
  }

  /** By which wind or current wanders [m/s per √s]. */
  double flowNoise() {
    return flowNoise;
  }
}
