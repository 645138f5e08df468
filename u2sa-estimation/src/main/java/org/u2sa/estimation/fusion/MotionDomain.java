package org.u2sa.estimation.fusion;

/** Domain in which a vehicle moves, with the filter's assumptions about unmeasured motion. */
public enum MotionDomain {
  /**
   * Wheeled or tracked vehicles: level unless an inertial sensor measures tilt, no sideways motion.
   */
  GROUND(2.0, 0.7, 0.1, 0.5, 0.1, 1.0, 0.05, 0.0, 0.0),
  /**
   * Aircraft of any kind. Gusts are about 1 m/s with correlation times of 1 to 10 s at their speed
   * (light turbulence of MIL-F-8785C), modelled by σ √(2/τ).
   */
  AIR(30.0, 2.0, 1.0, 0.3, 2.0, 5.0, 0.7, 0.0, 0.0),
  /** Surface vessels. */
  WATER(5.0, 0.3, 0.1, 0.2, 0.3, 1.5, 0.02, 0.0, 0.02),
  /** Underwater vehicles. Their weight rights them slowly: under way they pitch. */
  UNDERWATER(2.0, 0.3, 0.2, 0.2, 0.2, 1.0, 0.01, 0.2, 0.002);

  final double speedSigmaMps; // initial speed, 1 σ per component
  final double accelerationNoise; // of the horizontal velocity, unmeasured [m/s per √s]
  final double verticalNoise; // of the vertical velocity, unmeasured [m/s per √s]
  final double turnSigmaRadPerS; // turn rate if none is measured, 1 σ
  final double sideSlipSigmaMps; // sideslip over ground or through the fluid, 1 σ
  final double trackSpeedMps; // minimum at which the course may replace an unknown heading
  final double flowNoise; // random walk of wind or current [m/s per √s]
  final double tiltSigmaRad; // roll and pitch if none are measured, 1 σ; 0: level
  final double speedBiasSigmaMps; // constant error of measured speeds over ground, 1 σ; 0: none

  MotionDomain(
      double speedSigmaMps,
      double accelerationNoise,
      double verticalNoise,
      double turnSigmaRadPerS,
      double sideSlipSigmaMps,
      double trackSpeedMps,
      double flowNoise,
      double tiltSigmaRad,
      double speedBiasSigmaMps) {
    this.speedSigmaMps = speedSigmaMps;
    this.accelerationNoise = accelerationNoise;
    this.verticalNoise = verticalNoise;
    this.turnSigmaRadPerS = turnSigmaRadPerS;
    this.sideSlipSigmaMps = sideSlipSigmaMps;
    this.trackSpeedMps = trackSpeedMps;
    this.flowNoise = flowNoise;
    this.tiltSigmaRad = tiltSigmaRad;
    this.speedBiasSigmaMps = speedBiasSigmaMps;
  }

  /** Whether speeds over ground come from a velocity log rather than from wheels. */
  boolean isInWater() {
    return this == WATER || this == UNDERWATER;
  }
}
