package org.u2sa.estimation.fusion;

/**
 * Filter parameters of vehicle and sensors.
 *
 * @param domain provides the motion defaults
 * @param accelerationNoise random walk of the horizontal velocity without an accelerometer [m/s per
 *     √s]
 * @param verticalNoise random walk of the vertical velocity without an accelerometer [m/s per √s]
 * @param turnSigma turn rate if none is measured, 1 σ [rad/s]
 * @param sideSlipSigma sideslip velocity, 1 σ [m/s]
 * @param constraintS interval of the no-sideslip constraint [s]; 0: none
 * @param gyroBiasSigma initial gyroscope bias, 1 σ [rad/s]
 * @param gyroBiasNoise its random walk [rad/s per √s]
 * @param forceBiasSigma initial accelerometer bias, 1 σ [m/s²]
 * @param forceBiasNoise its random walk [m/s² per √s]
 * @param flowSigma initial wind or current, 1 σ per component [m/s]
 * @param wheelScaleSigma initial error of the wheel-speed scale, 1 σ; 0: not estimated
 * @param speedBiasSigma constant error of speeds over ground measured along the vehicle, 1 σ per
 *     component [m/s]; 0: not estimated
 * @param logYawSigmaRad error of a velocity log's mounting about the vertical, 1 σ [rad]; 0: not
 *     estimated
 * @param gate number of standard deviations beyond which a measurement is gated
 * @param window number of measurements over which a source's actual standard deviation is learned
 * @param positionCorrelationS correlation time of position errors [s]; 0: independent errors
 * @param headingCorrelationS correlation time of heading errors [s]; 0: independent errors
 * @param delaySigmaS residual delay of a position source, 1 σ [s]; 0: none
 * @param resetAfterS time after which a quantity contradicted by all sources is reset [s]
 * @param lostSigmaM horizontal standard deviation beyond which the position is lost [m]
 * @param horizonS age at which a late measurement is still fused [s]
 * @param history number of measurements kept for that
 */
public record FilterTuning(
    MotionDomain domain,
    double accelerationNoise,
    double verticalNoise,
    double turnSigma,
    double sideSlipSigma,
    double constraintS,
    double gyroBiasSigma,
    double gyroBiasNoise,
    double forceBiasSigma,
    double forceBiasNoise,
    double flowSigma,
    double wheelScaleSigma,
    double speedBiasSigma,
    double logYawSigmaRad,
    double gate,
    int window,
    double positionCorrelationS,
    double headingCorrelationS,
    double delaySigmaS,
    double resetAfterS,
    double lostSigmaM,
    double horizonS,
    int history) {

  static final double TURN_MEMORY_S = 1.0; // time constant of an unmeasured turn
  static final double ACCELERATION_MEMORY_S = 2.0; // of an acceleration of unknown direction

  /** Default values for a domain. */
  public static FilterTuning of(MotionDomain domain) {
    boolean isGround = domain == MotionDomain.GROUND;
    return new FilterTuning(
        domain,
        domain.accelerationNoise,
        domain.verticalNoise,
        domain.turnSigmaRadPerS,
        domain.sideSlipSigmaMps,
        0.2,
        0.02,
        1e-4,
        0.2,
        1e-3,
        5.0,
        isGround ? 0.03 : domain.isInWater() ? 0.02 : 0.0,
        domain.speedBiasSigmaMps,
        domain.isInWater() ? Math.toRadians(2.0) : 0.0,
        4.0,
        100,
        30.0,
        60.0,
        0.1,
        5.0,
        50.0,
        1.0,
        512);
  }
}
