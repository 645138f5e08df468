package org.u2sa.estimation.fusion;

import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;

/**
 * Compares the inertial sensor that drives the prediction with those on standby. Excludes and
 * reports any that differs from it by more than biases and noise allow. The driving sensor itself
 * is excluded and replaced if no other agrees with it and either two others agree with each other
 * for some time, or one differs while other kinds of sensors contradict the estimate. If all three
 * differ from each other, the faulty one cannot be identified: the driving one is kept until other
 * sensors contradict it.
 *
 * <p>Sensors are not averaged: another sensor's sample is up to an interval old, and on a turning
 * vehicle that error exceeds the noise averaging would remove. The comparison therefore allows for
 * the change during the other sample's age, and uses means over about ten samples.
 */
final class InertialVote {
  private static final int AXES = 6; // angular rates, then specific forces
  private static final double FRESH_INTERVALS = 3.0;
  private static final double MEAN_SHARE = 0.1; // weight of a new difference in the mean
  private static final double UNLIKELY = 4.0; // number of standard deviations
  private static final double AGREED = 25.0; // consecutive samples: faults may agree by chance
  private static final double LEFT_OUT_S = 30.0; // long, because some faults only show in turns
  private static final double SHORTEST_S = 1e-3; // minimum sample interval
  private static final double LONGEST_S = 0.6; // maximum interval to differentiate a rate
  private static final double MISLED_RAD = 0.5; // assumed error until a fault is detected
  private static final double MISLED_MPS = 3.0;

  private final FilterTuning tuning;
  private final SourceTrust trust;
  private final double[] limits = new double[AXES];
  private final double[] rate = new double[3];
  private final double[] change = new double[3];

  InertialVote(FilterTuning tuning, SourceTrust trust) {
    this.tuning = tuning;
    this.trust = trust;
  }

  /** Records a source that measures all angular rates, along with its latest values. */
  void heard(FilterState s, Measurement m, int source) {
    int at = trust.of(s, source, SensedQuantity.BODY_RATES);
    boolean hasForce = m.isWhole(SensedQuantity.SPECIFIC_FORCE);
    s.trust[trust.of(s, source) + SourceTrust.INERTIAL] = hasForce ? AXES : AXES / 2;
    release(s, m, trust.of(s, source));
    if (isLeftOut(s, source)) {
      s.trust[at + SourceTrust.GATED]++;
    }
  }

  /**
   * Removes lever-arm effects: while the vehicle turns, sensors at different places correctly
   * measure different specific forces.
   */
  private void release(FilterState s, Measurement m, int own) {
    double[] t = s.trust;
    double seconds = (m.micros() - t[own + SourceTrust.RATES_MICROS]) * 1e-6;
    boolean continues = seconds < LONGEST_S && t[own + SourceTrust.MESSAGES] > 1.0;
    for (int i = 0; i < 3; i++) {
      rate[i] = m.value(SensedQuantity.BODY_RATES, i);
      double turned = rate[i] - t[own + SourceTrust.RATES + i];
      change[i] = continues ? turned / Math.max(SHORTEST_S, seconds) : 0.0;
      t[own + SourceTrust.CHANGE + i] = continues ? turned : 0.0;
      t[own + SourceTrust.CHANGE + 3 + i] = -t[own + SourceTrust.RELEASED + i];
      t[own + SourceTrust.RATES + i] = rate[i];
      t[own + SourceTrust.RELEASED + i] = m.value(SensedQuantity.SPECIFIC_FORCE, i);
    }
    t[own + SourceTrust.RATES_MICROS] = m.micros();
    LeverArm.release(m, rate, change, t, own + SourceTrust.RELEASED);
    for (int i = 0; i < 3; i++) {
      int at = own + SourceTrust.CHANGE + 3 + i;
      t[at] = continues ? t[at] + t[own + SourceTrust.RELEASED + i] : 0.0;
    }
  }

  /** Whether a source was recently excluded; updates its mark. */
  boolean isLeftOut(FilterState s, int source) {
    int at = trust.of(s, source, SensedQuantity.BODY_RATES);
    double since = s.trust[at + SourceTrust.STREAK_SINCE];
    boolean isLeftOut = since > 0.0 && (s.micros - since) * 1e-6 < LEFT_OUT_S;
    s.trust[at + SourceTrust.IS_BIASED] = isLeftOut ? 1.0 : 0.0;
    return isLeftOut;
  }

  /**
   * Whether the source that drives the prediction remains trusted; excludes it otherwise.
   *
   * @param m its measurement
   * @param judge knows which other sensors contradict the estimate
   */
  boolean isBelieved(FilterState s, Measurement m, int main, SourceJudge judge) {
    boolean hasSupport = false;
    int against = FilterState.NO_SOURCE;
    int accuser = FilterState.NO_SOURCE;
    for (int source = 0; source < trust.sources(); source++) {
      if (source != main && isFresh(s, source, m.micros())) {
        if (!differs(s, m, main, source)) {
          hasSupport = true;
        } else if (against != FilterState.NO_SOURCE && agree(s, against, source)) {
          accuser = source;
        } else {
          against = source;
        }
      }
    }
    int agreed = trust.of(s, main, SensedQuantity.BODY_RATES) + SourceTrust.PASSED;
    boolean isOutnumbered = accuser != FilterState.NO_SOURCE && !hasSupport;
    s.trust[agreed] = isOutnumbered ? s.trust[agreed] + 1.0 : 0.0;
    if (s.trust[agreed] < AGREED) {
      boolean isDoubted =
          against != FilterState.NO_SOURCE && judge.isContradicted(s, main, against);
      accuser = isDoubted && !hasSupport ? against : FilterState.NO_SOURCE;
    }
    boolean isOutvoted = accuser != FilterState.NO_SOURCE && mayAccuse(s) && !hasSupport;
    if (isOutvoted) {
      accuse(s, main);
    }
    return !isOutvoted;
  }

  private boolean isFresh(FilterState s, int source, long micros) {
    int at = trust.of(s, source);
    double age = (micros - s.trust[at + SourceTrust.LAST_MICROS]) * 1e-6;
    return s.trust[at + SourceTrust.INERTIAL] > 0.0
        && s.trust[at + SourceTrust.MESSAGES] > 1.0
        && age <= FRESH_INTERVALS * s.trust[at + SourceTrust.INTERVAL];
  }

  /** Index of a source's mean difference from the main source on an axis. */
  private int mean(FilterState s, int source, int axis) {
    int at = trust.of(s, source, SensedQuantity.BODY_RATES);
    return at + (axis < 3 ? SourceTrust.STREAK_MEAN : SourceTrust.RUN_START) + axis % 3;
  }

  private boolean differs(FilterState s, Measurement m, int main, int source) {
    double[] t = s.trust;
    int at = trust.of(s, source, SensedQuantity.BODY_RATES);
    int own = trust.of(s, source);
    boolean hasForce = m.isWhole(SensedQuantity.SPECIFIC_FORCE);
    int axes = Math.min((int) t[own + SourceTrust.INERTIAL], hasForce ? AXES : AXES / 2);
    int driving = trust.of(s, main);
    double ageS = (m.micros() - t[own + SourceTrust.LAST_MICROS]) * 1e-6;
    double late = ageS / Math.max(SHORTEST_S, t[driving + SourceTrust.INTERVAL]);
    boolean differs = false;
    for (int axis = 0; axis < axes; axis++) {
      boolean isRate = axis < 3;
      SensedQuantity quantity = isRate ? SensedQuantity.BODY_RATES : SensedQuantity.SPECIFIC_FORCE;
      double bias = isRate ? tuning.gyroBiasSigma() : tuning.forceBiasSigma();
      double noise = m.sigma(quantity, axis % 3);
      limits[axis] = UNLIKELY * Math.sqrt(2.0 * (bias * bias + MEAN_SHARE * noise * noise));
      int numbers = isRate ? SourceTrust.RATES : SourceTrust.RELEASED;
      double apart = t[own + numbers + axis % 3] - t[driving + numbers + axis % 3];
      double aged = late * Math.abs(t[driving + SourceTrust.CHANGE + axis]);
      apart = Math.copySign(Math.max(0.0, Math.abs(apart) - aged), apart);
      int mean = mean(s, source, axis);
      t[mean] += MEAN_SHARE * (apart - t[mean]);
      differs |= Math.abs(t[mean]) > limits[axis];
    }
    if (differs) {
      t[at + SourceTrust.STREAK_SINCE] = s.micros;
    } else if (!isLeftOut(s, source)) {
      t[at + SourceTrust.USED]++;
      t[at + SourceTrust.LAST_USED] = s.micros;
    }
    return differs;
  }

  /** Whether two sources that differ from the main source agree with each other. */
  private boolean agree(FilterState s, int one, int other) {
    for (int axis = 0; axis < AXES; axis++) {
      double apart = s.trust[mean(s, one, axis)] - s.trust[mean(s, other, axis)];
      if (Math.abs(apart) > limits[axis]) {
        return false;
      }
    }
    return true;
  }

  /**
   * Whether enough time has passed since the last exclusion. The estimate needs time to recover;
   * before that, two sensors would be excluded in turn.
   */
  private static boolean mayAccuse(FilterState s) {
    return s.accusedMicros == 0 || (s.micros - s.accusedMicros) * 1e-6 > LEFT_OUT_S;
  }

  /** Excludes the main source and clears the record of those compared with it. */
  private void accuse(FilterState s, int main) {
    for (int source = 0; source < trust.sources(); source++) {
      if (s.trust[trust.of(s, source) + SourceTrust.INERTIAL] > 0.0) {
        int at = trust.of(s, source, SensedQuantity.BODY_RATES);
        s.trust[at + SourceTrust.STREAK_SINCE] = source == main ? s.micros : 0.0;
        for (int axis = 0; axis < AXES; axis++) {
          s.trust[mean(s, source, axis)] = 0.0;
        }
      }
    }
    s.accusedMicros = s.micros;
    s.isInertial = false;
    s.isStrapdown = false;
    for (int i = 0; i < 3; i++) {
      s.p.data[(FilterState.ATTITUDE + i) * (FilterState.N + 1)] += MISLED_RAD * MISLED_RAD;
      s.p.data[(FilterState.VELOCITY + i) * (FilterState.N + 1)] += MISLED_MPS * MISLED_MPS;
    }
  }
}
