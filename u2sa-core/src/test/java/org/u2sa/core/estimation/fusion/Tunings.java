package org.u2sa.core.estimation.fusion;

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
        t.gate(),
        t.window(),
        t.positionCorrelationS(),
        0.0,
        t.resetAfterS(),
        t.lostSigmaM(),
        t.horizonS(),
        t.history());
  }
}
