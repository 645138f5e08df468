package org.u2sa.estimation.fusion;

/**
 * What the filter is told of vehicle and sensors.
 *
 * @param domain gives the defaults for motion
 * @param accelerationNoise by which the horizontal velocity wanders without an accelerometer [m/s
 *     per √s]
 * @param verticalNoise the same of the vertical velocity [m/s per √s]
 * @param turnSigma turn rate where none is measured, 1 σ [rad/s]
 * @param sideSlipSigma speed sideways, 1 σ [m/s]
 * @param constraintS time between two statements that the vehicle does not slip sideways [s]; 0:
 *     none
 * @param gyroBiasSigma bias of an angular rate at the start, 1 σ [rad/s]
 * @param gyroBiasNoise by which it wanders [rad/s per √s]
 * @param forceBiasSigma bias of a specific force at the start, 1 σ [m/s²]
 * @param forceBiasNoise by which it wanders [m/s² per √s]
 * @param flowSigma wind or current at the start, 1 σ of each component [m/s]
 * @param wheelScaleSigma error of the wheel-speed scale at the start, 1 σ; 0: not estimated
 * @param gate normal deviations beyond which a measurement is gated
 * @param window measurements over which a source's true standard deviation is learnt
 * @param positionCorrelationS time for which a position error persists [s]; 0: each is new
 * @param headingCorrelationS time for which a heading error persists [s]; 0: each is new
 * @param delaySigmaS by how much later than it says a position source may measure, 1 σ [s]; 0: none
 * @param resetAfterS time after which a quantity that all sources contradict starts anew [s]
 * @param lostSigmaM horizontal standard deviation beyond which the position is lost [m]
 * @param horizonS age at which a late measurement is still fused [s]
 * @param history measurements kept for that
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
    double gate,
    int window,
    double positionCorrelationS,
    double headingCorrelationS,
    double delaySigmaS,
    double resetAfterS,
    double lostSigmaM,
    double horizonS,
    int history) {

  /** Useful values for a domain. */
  public static FilterTuning of(MotionDomain domain) {
    boolean isGround = domain == MotionDomain.GROUND;
    return new FilterTuning(
        domain,
        domain.accelerationNoise(),
        domain.verticalNoise(),
        domain.turnSigmaRadPerS(),
        domain.sideSlipSigmaMps(),
        0.2,
        0.02,
        1e-4,
        0.2,
        1e-3,
        5.0,
        isGround ? 0.03 : 0.0,
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
