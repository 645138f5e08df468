package org.u2sa.estimation.fusion;

import java.util.ArrayList;
import java.util.List;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;

/**
 * Interprets positions that drift away from the estimate rather than keep a constant offset. A
 * receiver whose error jumped differs by the same amount each time; a difference that grows at half
 * the speed or more means that the speed is wrong (spinning wheels, dead encoder) or, if nothing
 * measures the heading, that the heading is wrong.
 */
final class SpeedDoubt {
  private static final double SHORTEST_S = 1.0; // minimum duration of a drift
  private static final double UNLIKELY = 2.5; // standard deviations, after several rejections
  private static final double MIN_MPS = 0.5; // a receiver's error drifts more slowly
  private static final double SLOW_MPS = 0.1; // the same if two speeds contradict the positions
  private static final double CALM_S = 3.0; // over which positions must keep their offset
  private static final double MIN_SHARE = 0.5; // fraction of the speed
  private static final double SIGNIFICANT = 2.0; // standard deviations of a mean velocity
  private static final double JUMP_SHARE = 0.7; // fraction of a difference; drift has no jumps
  private static final double SAME_SPEED = 0.4; // relative difference of two speeds
  private static final double MEMORY_S = 6.0; // time constant of the mean that decides a doubt
  private static final double HEADING_SIGMA_RAD = 0.2;
  private static final double UNMEASURED_S = 5.0; // until an unmeasured heading counts as guessed
  private static final double LATELY_S = 5.0;
  private static final double AGREES_MPS = 0.3;
  private static final double AGREES_SHARE = 0.15; // fraction of the drift that raised the doubt

  private final SourceTrust trust;

  SpeedDoubt(SourceTrust trust) {
    this.trust = trust;
  }

  static boolean isOfSpeed(SensedQuantity quantity) {
    return quantity == SensedQuantity.VELOCITY || quantity == SensedQuantity.BODY_VELOCITY;
  }

  /** Whether no source has measured the heading for some time. */
  static boolean isHeadingGuessed(FilterState s) {
    return s.hasHeading
        && (s.headingMicros == 0 || (s.micros - s.headingMicros) * 1e-6 > UNMEASURED_S);
  }

  /**
   * Examines a rejected position that no other source supports.
   *
   * @param wanderRate process noise of its error, per axis [m²/s]
   * @return whether speed or heading are now considered wrong
   */
  boolean isRaised(
      FilterState s, Measurement m, Linearization model, int source, int at, double wanderRate) {
    double[] t = s.trust;
    double seconds = (s.micros - t[at + SourceTrust.STREAK_SINCE]) * 1e-6;
    if (model.rows != 2 || t[at + SourceTrust.STREAK] < 3.0 || seconds < SHORTEST_S) {
      return false;
    }
    double north = (model.innovation[0] - t[at + SourceTrust.STREAK_FIRST]) / seconds;
    double east = (model.innovation[1] - t[at + SourceTrust.STREAK_FIRST + 1]) / seconds;
    double drift = Math.hypot(north, east);
    double variance = variance(s, model, at);
    double sigma = driftSigma(s, model, at, wanderRate, seconds);
    double vn = s.x[FilterState.V] + north;
    double ve = s.x[FilterState.V + 1] + east;
    double speed = Math.hypot(s.x[FilterState.V], s.x[FilterState.V + 1]);
    double least = Math.max(MIN_MPS, MIN_SHARE * Math.max(speed, Math.hypot(vn, ve)));
    double jump = t[at + SourceTrust.STREAK_JUMP];
    boolean isNoise = jump < UNLIKELY * Math.sqrt(2.0 * variance);
    boolean isJump = !isNoise && jump > JUMP_SHARE * drift * seconds;
    boolean isContradicted = isContradicted(s, source, at, drift, -SIGNIFICANT);
    if (isJump || drift < (isContradicted ? SLOW_MPS : least) || drift < UNLIKELY * sigma) {
      return false;
    }
    if (isContradicted) {
      leaveOut(s, model, at, drift);
      return false;
    }
    if (isOtherWay(s, vn, ve)) {
      head(s, vn, ve, sigma);
    } else if (!doubt(s, source, drift)) {
      return false;
    }
    s.speedSource = FilterState.NO_SOURCE;
    Alignment.velocity(s, 0, vn, sigma * sigma + least * least);
    Alignment.velocity(s, 1, ve, sigma * sigma + least * least);
    return true;
  }

  private static double variance(FilterState s, Linearization model, int at) {
    return SourceTrust.factor(s, at) * (model.variance[0] + model.variance[1]);
  }

  private static double driftSigma(
      FilterState s, Linearization model, int at, double wanderRate, double seconds) {
    return Math.sqrt(variance(s, model, at) + 2.0 * wanderRate * seconds) / seconds;
  }

  /** Leaves out positions that drift, so that they do not become the estimate's. */
  private static void leaveOut(FilterState s, Linearization model, int at, double drift) {
    s.trust[at + SourceTrust.DOUBT_MPS] = drift;
    s.trust[at + SourceTrust.IS_BIASED] = 1.0;
    s.trust[at + SourceTrust.STREAK] = 0.0;
    differ(s, model); // the estimate may have followed before this was noticed
    mark(s, model, at);
  }

  /** Makes the estimate as uncertain as its difference from a position. */
  private static void differ(FilterState s, Linearization model) {
    for (int i = 0; i < 2; i++) {
      s.p.data[(FilterState.POSITION + i) * (FilterState.N + 1)] +=
          model.innovation[i] * model.innovation[i];
    }
  }

  private static void mark(FilterState s, Linearization model, int at) {
    s.trust[at + SourceTrust.STREAK_SINCE] = s.micros;
    s.trust[at + SourceTrust.STREAK_FIRST] = model.innovation[0];
    s.trust[at + SourceTrust.STREAK_FIRST + 1] = model.innovation[1];
  }

  /**
   * Whether positions are still left out because they drift. That ends when they keep their offset
   * from the estimate, of which either may then be wrong, or when no two speeds contradict them.
   *
   * @param wanderRate process noise of their error, per axis [m²/s]
   */
  boolean isLeftOut(
      FilterState s, Measurement m, Linearization model, int source, int at, double wanderRate) {
    double[] t = s.trust;
    double found = t[at + SourceTrust.DOUBT_MPS];
    compareVelocity(s, m, source, at);
    if (found == 0.0 || model.rows != 2) {
      return false;
    }
    t[at + SourceTrust.GATED]++;
    double seconds = (s.micros - t[at + SourceTrust.STREAK_SINCE]) * 1e-6;
    if (seconds < CALM_S) {
      return true;
    }
    double drift =
        Math.hypot(
                model.innovation[0] - t[at + SourceTrust.STREAK_FIRST],
                model.innovation[1] - t[at + SourceTrust.STREAK_FIRST + 1])
            / seconds;
    double sigma = driftSigma(s, model, at, wanderRate, seconds);
    boolean isCalm = drift < Math.max(SLOW_MPS / 2.0, UNLIKELY * sigma);
    if (isCalm || !isContradicted(s, source, at, Math.max(drift, found), SIGNIFICANT)) {
      t[at + SourceTrust.DOUBT_MPS] = 0.0;
      t[at + SourceTrust.IS_BIASED] = 0.0;
      differ(s, model);
    }
    mark(s, model, at);
    return true;
  }

  private boolean isContradicted(
      FilterState s, int source, int at, double drift, double toleratedSigmas) {
    return hasAgreeingVelocity(s, at, drift, toleratedSigmas) && !speeds(s, source).isEmpty();
  }

  /**
   * Whether the velocities that came with the positions agree with the estimate on average, as
   * another speed does: then the positions are wrong, such as those of a receiver that holds them
   * at low speed.
   *
   * @param toleratedSigmas standard deviations of their mean by which it may differ by more than
   *     half the drift; if negative, by which it must differ by less
   */
  private static boolean hasAgreeingVelocity(
      FilterState s, int at, double drift, double toleratedSigmas) {
    double[] t = s.trust;
    double count = t[at + SourceTrust.APART_COUNT];
    double sum = Math.hypot(t[at + SourceTrust.APART], t[at + SourceTrust.APART + 1]);
    double sigma = Math.sqrt(t[at + SourceTrust.APART_VARIANCE]);
    return count > 0.0 && sum < MIN_SHARE * drift * count + toleratedSigmas * sigma;
  }

  /** Compares the velocity that came with a position with the estimate's. */
  private void compareVelocity(FilterState s, Measurement m, int source, int at) {
    double[] t = s.trust;
    SensedQuantity velocity = SensedQuantity.VELOCITY;
    if (t[at + SourceTrust.APART_SINCE] != t[at + SourceTrust.STREAK_SINCE]) {
      t[at + SourceTrust.APART_SINCE] = t[at + SourceTrust.STREAK_SINCE];
      t[at + SourceTrust.APART_COUNT] = 0.0;
      t[at + SourceTrust.APART] = 0.0;
      t[at + SourceTrust.APART + 1] = 0.0;
      t[at + SourceTrust.APART_VARIANCE] = 0.0;
    }
    boolean isRepeated = t[trust.of(s, source) + SourceTrust.RUN] > 0.0; // no new evidence
    if (m.has(velocity, 0) && m.has(velocity, 1) && !isRepeated) {
      double sigma = Math.max(m.sigma(velocity, 0), m.sigma(velocity, 1));
      boolean isKnown = trust.isKnown(source, velocity);
      double factor = isKnown ? SourceTrust.factor(s, trust.of(s, source, velocity)) : 1.0;
      t[at + SourceTrust.APART_COUNT]++;
      t[at + SourceTrust.APART] += m.value(velocity, 0) - s.x[FilterState.V];
      t[at + SourceTrust.APART + 1] += m.value(velocity, 1) - s.x[FilterState.V + 1];
      t[at + SourceTrust.APART_VARIANCE] += factor * sigma * sigma;
    }
  }

  /** Whether the wheel speed matches that velocity, so that only a guessed heading can be wrong. */
  private static boolean isOtherWay(FilterState s, double vn, double ve) {
    double forward = HeadingSearch.forwardMps(s);
    double apart = Math.hypot(vn, ve) - Math.abs(forward);
    return isHeadingGuessed(s) && Math.abs(apart) < SAME_SPEED * Math.abs(forward);
  }

  private static void head(FilterState s, double vn, double ve, double sigma) {
    double of = Math.max(HEADING_SIGMA_RAD, sigma / Math.hypot(vn, ve));
    boolean isInReverse = HeadingSearch.forwardMps(s) < 0.0;
    Alignment.heading(s, StrictMath.atan2(ve, vn) + (isInReverse ? Math.PI : 0.0), of * of);
  }

  private boolean doubt(FilterState s, int accuser, double drift) {
    List<Integer> speeds = speeds(s, accuser);
    speeds.forEach(at -> accuse(s, at, drift));
    return !speeds.isEmpty();
  }

  /**
   * Begins to doubt a speed.
   *
   * @param mps difference from other speeds
   */
  static void accuse(FilterState s, int at, double mps) {
    s.trust[at + SourceTrust.DOUBT_MPS] = mps;
    s.trust[at + SourceTrust.IS_BIASED] = 1.0;
    for (int i = 0; i < 3; i++) {
      s.trust[at + SourceTrust.DOUBT_MEAN + i] = Double.NaN; // none yet
    }
  }

  /** Offsets of the speeds of other sources that were used lately. */
  private List<Integer> speeds(FilterState s, int accuser) {
    List<Integer> found = new ArrayList<>();
    for (int source = 0; source < trust.sources(); source++) {
      for (SensedQuantity each :
          new SensedQuantity[] {SensedQuantity.VELOCITY, SensedQuantity.BODY_VELOCITY}) {
        if (source != accuser && trust.isKnown(source, each)) {
          int at = trust.of(s, source, each);
          if ((s.micros - s.trust[at + SourceTrust.LAST_USED]) * 1e-6 < LATELY_S) {
            found.add(at);
          }
        }
      }
    }
    return found;
  }

  /**
   * Whether a speed is still doubted. The doubt ends when its mean difference from the estimate is
   * small, or when no more positions contradict it.
   */
  boolean holds(FilterState s, Linearization model, int source, int at) {
    double[] t = s.trust;
    double found = t[at + SourceTrust.DOUBT_MPS];
    if (found == 0.0) {
      return false;
    }
    double interval = t[trust.of(s, source) + SourceTrust.INTERVAL];
    double share = Math.min(1.0, interval / MEMORY_S);
    double limit2 = Math.pow(Math.max(AGREES_MPS, AGREES_SHARE * found), 2.0);
    double mean2 = 0.0;
    for (int i = 0; i < model.rows; i++) {
      int mean = at + SourceTrust.DOUBT_MEAN + i;
      double apart = model.innovation[i];
      t[mean] = Double.isNaN(t[mean]) ? apart : t[mean] + share * (apart - t[mean]);
      mean2 += t[mean] * t[mean];
    }
    double vn = s.x[FilterState.V];
    double ve = s.x[FilterState.V + 1];
    double speed = Math.hypot(vn, ve);
    double sigma =
        Math.sqrt(Math.max(s.variance(FilterState.VELOCITY), s.variance(FilterState.VELOCITY + 1)));
    boolean isKnown = speed > MIN_MPS && sigma < SAME_SPEED * speed;
    if (isKnown && mean2 >= limit2 && isOtherWay(s, vn, ve)) {
      head(s, vn, ve, sigma);
      mean2 = 0.0; // the heading was wrong, not the speed
    }
    boolean isUncontradicted = (s.micros - s.positionMicros) * 1e-6 > LATELY_S;
    if (isUncontradicted || mean2 < limit2) {
      t[at + SourceTrust.DOUBT_MPS] = 0.0;
      t[at + SourceTrust.IS_BIASED] = 0.0;
      return false;
    }
    t[at + SourceTrust.GATED]++;
    return true;
  }
}
