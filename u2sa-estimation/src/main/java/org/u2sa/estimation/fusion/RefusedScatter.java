package org.u2sa.estimation.fusion;

/**
 * What the refused positions of a source say of each other. Positions that lie beside the estimate,
 * or walk away from it steadily, contradict it. Those that scatter by more than they claim tell of
 * nothing but the source's own noise: its claim is wrong, whatever else may be.
 *
 * <p>The steps from one refused position to the next have twice the variance of the noise (von
 * Neumann 1941). Their mean is left out, so that a steady drift is no scatter, and so is the
 * largest one, which may be a jump.
 */
final class RefusedScatter {
  private static final int MIN_STEPS = 4;
  private static final double LOST_STEPS = 2.0; // which mean and largest step take away
  private static final double STEP_VARIANCES = 4.0; // in a squared step: two axes, two positions
  private static final double MIN_GROWTH = 2.0; // of a variance; less is chance

  private final FilterTuning tuning;

  RefusedScatter(FilterTuning tuning) {
    this.tuning = tuning;
  }

  /** Takes note of a refused vector, after the streak that it belongs to has been counted. */
  static void note(double[] t, MeasurementModel model, int at) {
    double first = model.innovation[0];
    double second = model.rows > 1 ? model.innovation[1] : 0.0;
    if (t[at + SourceTrust.STREAK] == 1.0) {
      t[at + SourceTrust.STREAK_FIRST] = first;
      t[at + SourceTrust.STREAK_FIRST + 1] = second;
      t[at + SourceTrust.STREAK_JUMP] = 0.0;
      t[at + SourceTrust.STREAK_STEPS2] = 0.0;
    } else {
      double step =
          Math.hypot(
              first - t[at + SourceTrust.STREAK_NEWEST],
              second - t[at + SourceTrust.STREAK_NEWEST + 1]);
      t[at + SourceTrust.STREAK_JUMP] = Math.max(step, t[at + SourceTrust.STREAK_JUMP]);
      t[at + SourceTrust.STREAK_STEPS2] += step * step;
    }
    t[at + SourceTrust.STREAK_NEWEST] = first;
    t[at + SourceTrust.STREAK_NEWEST + 1] = second;
  }

  /** Variance of the noise of refused positions, of each axis [m²]; 0 if too few were refused. */
  private static double variance(double[] t, int at) {
    double steps = t[at + SourceTrust.STREAK] - 1.0;
    if (steps < MIN_STEPS) {
      return 0.0;
    }
    double north = t[at + SourceTrust.STREAK_NEWEST] - t[at + SourceTrust.STREAK_FIRST];
    double east = t[at + SourceTrust.STREAK_NEWEST + 1] - t[at + SourceTrust.STREAK_FIRST + 1];
    double largest = t[at + SourceTrust.STREAK_JUMP];
    double drift2 = (north * north + east * east) / steps;
    double sum2 = t[at + SourceTrust.STREAK_STEPS2] - largest * largest - drift2;
    return Math.max(0.0, sum2 / (STEP_VARIANCES * (steps - LOST_STEPS)));
  }

  /**
   * Believes the scatter instead of the claim if it is larger by much, and then lets the streak
   * begin anew. What the estimate took from this source by its claim is as uncertain, and the scale
   * of the wheels, which it may have learnt of it, is to be learnt anew.
   *
   * @param isAlone whether no other source supports the position
   */
  boolean isBeyondClaim(FilterState s, MeasurementModel model, int at, boolean isAlone) {
    double[] t = s.trust;
    double shown = model.rows == 2 ? variance(t, at) : 0.0;
    double claimed = (model.variance[0] + model.variance[1]) / 2.0;
    if (shown <= MIN_GROWTH * SourceTrust.factor(s, at) * claimed) {
      return false;
    }
    SourceTrust.raise(t, at, shown / claimed);
    t[at + SourceTrust.STREAK] = 0.0;
    if (isAlone) {
      for (int i = 0; i < 2; i++) {
        s.p.data[(FilterState.POSITION + i) * (FilterState.N + 1)] += shown;
      }
      Alignment.wheelScale(s, tuning);
    }
    return true;
  }
}
