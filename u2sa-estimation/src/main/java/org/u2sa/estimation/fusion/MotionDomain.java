package org.u2sa.estimation.fusion;

/** Domain in which a vehicle moves, with the filter's assumptions about unmeasured motion. */
public enum MotionDomain {
  /**
   * Wheeled or tracked vehicles: level unless an inertial sensor measures tilt, no sideways motion.
   */
  GROUND(2.0, 0.7, 0.1, 0.5, 0.1, 1.0, 0.05),
  /**
   * Aircraft of any kind. Gusts are about 1 m/s with correlation times of 1 to 10 s at their speed
   * (light turbulence of MIL-F-8785C), modelled by σ √(2/τ).
   */
  AIR(30.0, 2.0, 1.0, 0.3, 2.0, 5.0, 0.7),
  /** Surface vessels. */
  WATER(5.0, 0.3, 0.1, 0.2, 0.3, 1.5, 0.02),
  /** Underwater vehicles. */
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

  /** Initial speed, 1 σ per component [m/s]. */
  double speedSigmaMps() {
    return speedSigmaMps;
  }

  /** Random walk of the horizontal velocity without an accelerometer [m/s per √s]. */
  double accelerationNoise() {
    return accelerationNoise;
  }

  /** Random walk of the vertical velocity without an accelerometer [m/s per √s]. */
  double verticalNoise() {
    return verticalNoise;
  }

  /** Turn rate if none is measured, 1 σ [rad/s]. */
  double turnSigmaRadPerS() {
    return turnSigmaRadPerS;
  }

  /** Sideslip velocity over ground or through the fluid, 1 σ [m/s]. */
  double sideSlipSigmaMps() {
    return sideSlipSigmaMps;
  }

  /** Minimum speed at which the course may replace an unknown heading [m/s]. */
  double trackSpeedMps() {
    return trackSpeedMps;
  }

  /** Random walk of wind or current [m/s per √s]. */
  double flowNoise() {
    return flowNoise;
  }
}
