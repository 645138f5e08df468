package org.u2sa.estimation.fusion;

/**
 * Estimates a source's noise from the scatter of its rejected positions. Positions at an offset
 * from the estimate, or drifting steadily away from it, contradict it. Positions that scatter by
 * more than they claim only show the source's own noise: its claimed sigma is wrong in any case.
 *
 * <p>Differences between consecutive rejected positions have twice the noise variance (von Neumann
 * 1941). Their mean is removed, so that a steady drift does not count as scatter, and the largest
 * deviation, which may be a jump, is also removed.
 */
final class RefusedScatter {
  private static final int MIN_STEPS = 4;
  private static final double LOST_STEPS = 2.0; // degrees of freedom lost to mean and largest step
  private static final double STEP_VARIANCES = 4.0; // per squared step: two axes, two positions
  private static final double MIN_GROWTH = 2.0; // of a variance; less may be due to chance

  private static final double MIN_TURN_STEPS = 2.0;
  private static final double MIN_TURN_S = 0.08;
  private static final double TURN_SIGMAS = 3.0;
  private static final double MIN_STEADINESS = 0.6; // 1: all steps are equal

  private final FilterTuning tuning;

  RefusedScatter(FilterTuning tuning) {
    this.tuning = tuning;
  }

  /** Records a rejected vector; called after its streak counter was incremented. */
  static void note(double[] t, Linearization model, int at) {
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

  /** Noise variance of the rejected positions per axis [m²]; 0 with too few positions. */
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
   * Whether headings that no gyroscope or wheel explains show that the turn rate is wrong: rejected
   * ones went on turning away from the estimate in one direction. Corrects the turn rate by that
   * and makes the heading uncertain.
   *
   * @param heading beyond the gate, not yet recorded
   */
  boolean showsTurn(FilterState s, Linearization heading, int at) {
    double[] t = s.trust;
    double steps = t[at + SourceTrust.STREAK];
    double seconds = (s.micros - t[at + SourceTrust.STREAK_SINCE]) * 1e-6;
    if (s.isInertial || s.hasTurnInput() || steps < MIN_TURN_STEPS || seconds < MIN_TURN_S) {
      return false;
    }
    double turned = heading.innovation[0] - t[at + SourceTrust.STREAK_FIRST];
    double step = heading.innovation[0] - t[at + SourceTrust.STREAK_NEWEST];
    double steps2 = t[at + SourceTrust.STREAK_STEPS2] + step * step;
    double noise2 = 2.0 * SourceTrust.factor(s, at) * heading.variance[0];
    boolean isSteady = turned * turned > MIN_STEADINESS * steps * steps2;
    if (!isSteady || turned * turned < TURN_SIGMAS * TURN_SIGMAS * noise2) {
      return false;
    }
    s.x[FilterState.W + 2] += turned / seconds;
    s.isolate(FilterState.RATE + 2, tuning.turnSigma() * tuning.turnSigma());
    double apart = heading.innovation[0];
    s.p.data[(FilterState.ATTITUDE + 2) * (FilterState.N + 1)] += apart * apart;
    return true;
  }

  /**
   * Uses the scatter instead of the claimed variance if it is much larger, and resets the streak.
   * If this is the only source, the position uncertainty grows by the same amount, and the wheel
   * scale, which may have been learned from it, is reset.
   *
   * @param isAlone whether no other source supports the position
   */
  boolean isBeyondClaim(FilterState s, Linearization model, int at, boolean isAlone) {
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
