package org.u2sa.estimation.fusion;

import org.u2sa.estimation.measurement.SensedQuantity;

/**
 * Lets the depth gauge of an underwater vehicle prevail over the vertical speed of a velocity log.
 * A pressure gauge measures the depth itself; a log that is mounted at an angle, or repeats its
 * last value, carries the depth away from it while claiming more certainty than the gauge.
 */
final class DepthPriority {
  private static final double ERROR_WALK = 0.01; // vertical error of a log [m/s per √s]
  private static final double WRONG_MPS = 0.5; // of a log that the gauge contradicts, 1 σ
  private static final double UNSEEN_MPS = 0.2; // change of speed that a frozen log has hidden, 1 σ
  private static final int MIN_STREAK = 3;
  private static final double SINCE_S = 0.3; // minimum duration of a contradiction
  private static final double LATELY_S = 5.0;
  private static final double MAX_GAUGE_REPEATS = 100.0; // if no log carries the depth
  private static final double REPEATS = 3.0; // consecutive messages with the same values

  private final SourceTrust trust;

  DepthPriority(SourceTrust trust) {
    this.trust = trust;
  }

  /**
   * Lets the vertical error of a log's speeds change before a depth corrects it, unless gauge or
   * log repeat their values: such an error would explain what is frozen.
   */
  void wander(FilterState s, int gauge) {
    for (int source = 0; source < trust.sources(); source++) {
      boolean isLog = trust.isKnown(source, SensedQuantity.BODY_VELOCITY);
      if ((isLog || source == gauge) && isRepeating(s, source)) {
        return;
      }
    }
    double seconds = Math.min(1.0, s.trust[trust.of(s, gauge) + SourceTrust.INTERVAL]);
    if (s.variance(FilterState.SPEED_BIAS + 2) > WRONG_MPS * WRONG_MPS) {
      return;
    }
    add(s, FilterState.SPEED_BIAS + 2, ERROR_WALK * ERROR_WALK * seconds);
  }

  private boolean isRepeating(FilterState s, int source) {
    return s.trust[trust.of(s, source) + SourceTrust.RUN] >= REPEATS;
  }

  /**
   * Factor on the variance of a log or gauge. Values that repeat exactly are one measurement,
   * however often they arrive: after n of them, 1 / n² sums up to less than two.
   */
  double repeats(FilterState s, int source, boolean isGauge) {
    double n = 1.0 + s.trust[trust.of(s, source) + SourceTrust.RUN];
    double limit = isGauge && !isCarried(s, source) ? MAX_GAUGE_REPEATS : Double.MAX_VALUE;
    return s.isStrapdown && isRepeating(s, source) ? Math.min(limit, n * n) : 1.0;
  }

  private boolean isCarried(FilterState s, int gauge) {
    boolean isCarried = false;
    for (int source = 0; source < trust.sources(); source++) {
      if (source != gauge && trust.isKnown(source, SensedQuantity.BODY_VELOCITY)) {
        int at = trust.of(s, source, SensedQuantity.BODY_VELOCITY);
        isCarried |= (s.micros - s.trust[at + SourceTrust.LAST_USED]) * 1e-6 < LATELY_S;
      }
    }
    return isCarried;
  }

  /**
   * After a rejected depth, names the logs that carry the depth and makes depth and vertical speed
   * uncertain.
   *
   * @param at numbers of the gauge, whose contradiction has been recorded
   * @return whether the depth is followed from now on
   */
  boolean isGiven(FilterState s, Linearization depth, int source, int at) {
    double[] t = s.trust;
    double since = (s.micros - t[at + SourceTrust.STREAK_SINCE]) * 1e-6;
    boolean isBrief = t[at + SourceTrust.STREAK] < MIN_STREAK || since < SINCE_S;
    if (isBrief || isRepeating(s, source)) {
      return false;
    }
    boolean isCarried = false;
    for (int other = 0; other < trust.sources(); other++) {
      isCarried |= other != source && accuse(s, other);
    }
    if (isCarried) {
      double apart = depth.innovation[0];
      add(s, FilterState.POSITION + 2, apart * apart);
      s.isolate(FilterState.VELOCITY + 2, WRONG_MPS * WRONG_MPS);
      s.isolate(FilterState.SPEED_BIAS + 2, WRONG_MPS * WRONG_MPS);
      t[at + SourceTrust.STREAK] = 0.0;
    }
    return isCarried;
  }

  /** Names a log used lately as biased, or as frozen if it repeats its values. */
  private boolean accuse(FilterState s, int source) {
    boolean isUsed = false;
    for (SensedQuantity each :
        new SensedQuantity[] {SensedQuantity.BODY_VELOCITY, SensedQuantity.FLUID_VELOCITY}) {
      if (trust.isKnown(source, each)) {
        int at = trust.of(s, source, each);
        double since = (s.micros - s.trust[at + SourceTrust.LAST_USED]) * 1e-6;
        if (s.trust[at + SourceTrust.LAST_USED] > 0.0 && since < LATELY_S) {
          s.trust[at + SourceTrust.IS_BIASED] = 1.0;
          s.trust[at + SourceTrust.PASSED] = 0.0;
          isUsed = true;
        }
      }
    }
    if (isUsed && isRepeating(s, source)) {
      s.trust[trust.of(s, source) + SourceTrust.IS_FROZEN] = 1.0;
      add(s, FilterState.VELOCITY, UNSEEN_MPS * UNSEEN_MPS);
      add(s, FilterState.VELOCITY + 1, UNSEEN_MPS * UNSEEN_MPS);
    }
    return isUsed;
  }

  private static void add(FilterState s, int i, double variance) {
    s.p.data[i * (FilterState.N + 1)] += variance;
  }
}
