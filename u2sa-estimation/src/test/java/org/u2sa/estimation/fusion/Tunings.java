package org.u2sa.estimation.fusion;

/** Tunings for tests. */
final class Tunings {
  private Tunings() {}

  /** For motions that do slip sideways. */
  static FilterTuning withoutConstraint(MotionDomain domain) {
    FilterTuning t = FilterTuning.of(domain);
    return new FilterTuning(
        domain,
        t.accelerationNoise(),
        t.verticalNoise(),
        t.turnSigma(),
        t.sideSlipSigma(),
        0.0,
        t.gyroBiasSigma(),
        0.0,
        t.forceBiasSigma(),
        0.0,
        t.flowSigma(),
        0.0,
        t.speedBiasSigma(),
        t.logYawSigmaRad(),
        t.gate(),
        t.window(),
        0.0,
        0.0,
        0.0,
        t.resetAfterS(),
        t.lostSigmaM(),
        t.horizonS(),
        t.history());
  }

  /** For sources whose errors persist so long [s]. */
  static FilterTuning persistent(double positionS, double headingS) {
    FilterTuning t = FilterTuning.of(MotionDomain.GROUND);
    return new FilterTuning(
        t.domain(),
        t.accelerationNoise(),
        t.verticalNoise(),
        t.turnSigma(),
        t.sideSlipSigma(),
        t.constraintS(),
        t.gyroBiasSigma(),
        t.gyroBiasNoise(),
        t.forceBiasSigma(),
        t.forceBiasNoise(),
        t.flowSigma(),
        t.wheelScaleSigma(),
        t.speedBiasSigma(),
        t.logYawSigmaRad(),
        t.gate(),
        t.window(),
        positionS,
        headingS,
        t.delaySigmaS(),
        t.resetAfterS(),
        t.lostSigmaM(),
        t.horizonS(),
        t.history());
  }
}
