package org.u2sa.estimation.fusion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.u2sa.estimation.measurement.AltitudeDifference;
import org.u2sa.estimation.measurement.KnownOffset;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.PositionGrid;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.messages.SensorParts;

/**
 * Statistics of the sources: a block of numbers for each source and for each quantity it measures.
 * Names and offsets are kept here, the numbers in the {@link FilterState}, so that a replay
 * reproduces them.
 *
 * <p>The actual variance of a source is learned from innovations: the squared difference of
 * consecutive ones is 2 (H P Hᵀ + R) on average and is insensitive to constant errors, which are
 * handled separately (innovation-based adaptive estimation, Mehra 1970; difference as in von
 * Neumann 1941). The variance used is never below the claimed variance.
 */
final class SourceTrust {
  // Numbers of a source.
  static final int LAST_MICROS = 0;
  static final int INTERVAL = 1; // s, running mean
  static final int MESSAGES = 2;
  static final int RUN = 3; // consecutive messages that repeat the values before
  static final int IS_FROZEN = 4;
  static final int INERTIAL = 5; // number of rates and forces measured: 0, 3 or 6
  static final int KEPT = 6; // its newest values
  static final int RATES_MICROS = KEPT + Measurement.SIZE; // time of the newest angular rates
  static final int RATES = RATES_MICROS + 1; // newest angular rates: three
  static final int RELEASED = RATES + 3; // specific force at the reference point: three
  static final int CHANGE = RELEASED + 3; // of both since the message before: six
  private static final int SOURCE_SIZE = CHANGE + 6;

  // Numbers of a quantity of a source.
  static final int FACTOR = 0; // actual over claimed variance, unbounded estimate
  static final int LEARNT = 1; // number of innovations the factor was learned from
  static final int PREVIOUS = 2; // previous innovations, in claimed sigmas: three
  static final int HAS_PREVIOUS = 5;
  static final int USED = 6;
  static final int GATED = 7;
  static final int STREAK = 8; // consecutive gated vectors
  static final int STREAK_MEAN = 9; // mean innovation of the streak, in claimed sigmas: three
  static final int STREAK_SINCE = 12; // µs
  static final int LAST_USED = 13; // µs
  static final int IS_BIASED = 14;
  static final int PASSED = 15; // consecutive, while biased
  static final int RUN_START = 16; // prediction when the values stopped changing: three
  static final int OFFSET = 19; // three in another local frame; one of a wrong altitude [m]
  static final int HAS_OFFSET = 22; // whether it is subtracted
  static final int NIS = 23; // normalised squared innovation of the newest vector
  static final int RUN_OF = 24; // message at which the run of RUN_START began
  static final int STREAK_FIRST = 25; // first innovation of the streak: two
  static final int DISTRUST = 27; // minimum factor, if dead reckoning contradicts the claim
  static final int RESET_MICROS = 28; // last reset of the estimate from this source; 0: never
  static final int DOUBT_MPS = 29; // difference of positions from this speed; 0: none
  static final int DOUBT_MEAN = 30; // mean innovation since the doubt began: three
  static final int WANDER = 33; // actual over claimed variance of its persistent error; 0: unknown
  static final int WANDER_S = 34; // time over which that was learned
  static final int WANDER_MICROS = 35; // time of that update
  static final int STREAK_NEWEST = 36; // newest innovation of the streak: two
  static final int STREAK_JUMP = 38; // largest change between consecutive ones
  static final int STREAK_STEPS2 = 39; // sum of the squared changes
  static final int CLAIM = 40; // claimed variance of an altitude's persistent error [m²]
  static final int ALIGNED = 41; // variance of the altitude that the offset was compared with
  static final int OUTLIERS = 42; // fraction of lone vectors beyond the gate, running mean
  static final int APART_SINCE = 43; // STREAK_SINCE of the following sums
  static final int APART_COUNT = 44; // velocities that came with positions since then
  static final int APART = 45; // sum of their differences from the estimate: two
  static final int APART_VARIANCE = 47; // sum of their variances per axis
  static final int GRID = 48; // of its coordinates, see PositionGrid
  static final int KNOWN_OFFSET = GRID + PositionGrid.SIZE; // of its altitudes
  static final int DIFFERENCE = KNOWN_OFFSET + KnownOffset.SIZE; // of a barometer's altitudes
  private static final int QUANTITY_SIZE = DIFFERENCE + AltitudeDifference.SIZE;

  private static final double OUTLIER_MEMORY = 100.0; // vectors
  private static final double PRIOR = 10.0; // weight of the claim, in innovations
  private static final double UNTESTED = 25.0; // factor assumed of a log's claim at first
  private static final double UNTESTED_PRIOR = 3.0; // weight of that, in innovations
  private static final double LARGEST = 25.0; // cap of one innovation, as a multiple of variance
  private static final double ROBUST = 3.0; // the same for sources with outliers
  private static final double ROBUST_MEAN = 0.858; // of a χ² of one degree of freedom, thus capped
  private static final double NOTEWORTHY = 1.4; // a smaller factor may be due to chance
  private static final double HIGHEST = 1e6;
  static final double FORGIVEN = 0.998; // decay of distrust per measurement used
  private static final double MEAN_SHARE = 0.05;
  private static final double MAX_ALONE = 2.0; // consecutive outliers; more contradict the estimate

  private final int window;
  private final List<String> names = new ArrayList<>();
  private final List<int[]> places = new ArrayList<>(); // per source: own offset, then quantities'
  private int size;

  SourceTrust(int window) {
    this.window = window;
  }

  /** Index of a source; registers an unknown one. */
  int source(String name) {
    for (int i = 0; i < names.size(); i++) {
      if (names.get(i).equals(name)) {
        return i;
      }
    }
    int[] place = new int[1 + SensedQuantity.count()];
    Arrays.fill(place, -1);
    place[0] = size;
    size += SOURCE_SIZE;
    names.add(name);
    places.add(place);
    return names.size() - 1;
  }

  int sources() {
    return names.size();
  }

  String name(int source) {
    return names.get(source);
  }

  /** Whether two sources are parts of the same sensor. */
  boolean isSameDevice(int one, int other) {
    return SensorParts.sensor(names.get(one)).equals(SensorParts.sensor(names.get(other)));
  }

  /** Offset of a source's own numbers. */
  int of(FilterState s, int source) {
    reserve(s);
    return places.get(source)[0];
  }

  /** Offset of the values of one quantity of a source. */
  int of(FilterState s, int source, SensedQuantity quantity) {
    int[] place = places.get(source);
    if (place[1 + quantity.ordinal()] < 0) {
      place[1 + quantity.ordinal()] = size;
      size += QUANTITY_SIZE;
    }
    reserve(s);
    return place[1 + quantity.ordinal()];
  }

  boolean isKnown(int source, SensedQuantity quantity) {
    return places.get(source)[1 + quantity.ordinal()] >= 0;
  }

  private void reserve(FilterState s) {
    if (s.trust.length < size) {
      s.trust = Arrays.copyOf(s.trust, size);
    }
  }

  /** Records a message before its vectors are processed. */
  void heard(FilterState s, Measurement m, int source) {
    int at = of(s, source);
    double[] t = s.trust;
    double interval = (m.micros() - t[at + LAST_MICROS]) * 1e-6;
    if (t[at + MESSAGES] == 1.0) {
      t[at + INTERVAL] = interval;
    } else if (t[at + MESSAGES] > 1.0) {
      t[at + INTERVAL] += MEAN_SHARE * (interval - t[at + INTERVAL]);
    }
    t[at + LAST_MICROS] = m.micros();
    boolean isSame = t[at + MESSAGES] > 0.0 && m.repeats(t, at + KEPT);
    t[at + MESSAGES]++;
    t[at + RUN] = isSame ? t[at + RUN] + 1.0 : 0.0;
    if (!isSame) {
      t[at + IS_FROZEN] = 0.0;
      m.keep(t, at + KEPT);
    }
  }

  /** Factor on the claimed variance, at least 1. */
  static double factor(FilterState s, int at) {
    double learnt = s.trust[at + LEARNT] == 0.0 ? 1.0 : s.trust[at + FACTOR];
    double shown = Math.max(learnt, s.trust[at + DISTRUST]);
    return shown < NOTEWORTHY ? 1.0 : Math.min(HIGHEST, shown);
  }

  /**
   * Assumes a factor until the first innovations show the actual one: a few vectors used with too
   * small a sigma give the accelerometer biases wrong values, and the following ones are rejected.
   */
  static void suppose(double[] t, int at) {
    if (t[at + LEARNT] == 0.0) {
      t[at + FACTOR] = UNTESTED;
      t[at + LEARNT] = UNTESTED_PRIOR;
    }
  }

  /** Ends what has been held against a source, because the reason is known. */
  void admit(FilterState s, int source) {
    for (SensedQuantity each :
        new SensedQuantity[] {
          SensedQuantity.PLACE, SensedQuantity.ALTITUDE, SensedQuantity.VELOCITY
        }) {
      if (isKnown(source, each)) {
        int at = of(s, source, each);
        for (int i = 0; i < 2 && each.isPlace() && s.trust[at + STREAK] > 0.0; i++) {
          double apart = s.trust[at + STREAK_NEWEST + i];
          s.p.data[(FilterState.POSITION + i) * (FilterState.N + 1)] += apart * apart;
        }
        s.trust[at + STREAK] = 0.0;
        s.trust[at + IS_BIASED] = 0.0;
        s.trust[at + DISTRUST] = 0.0;
        s.trust[at + DOUBT_MPS] = 0.0;
        s.trust[at + HAS_PREVIOUS] = 0.0;
        s.trust[at + LEARNT] = 0.0;
      }
    }
  }

  /** Restarts learning from the given factor. */
  static void raise(double[] t, int at, double factor) {
    t[at + FACTOR] = factor;
    t[at + LEARNT] = PRIOR;
  }

  /**
   * Learns from an innovation.
   *
   * @param expected variance of each component due to the state's uncertainty
   * @param hasOutliers whether up to a seventh of the vectors may be wrong: they are rejected, so
   *     they must not count as scatter of the others, unless many are rejected in a row
   */
  void learn(FilterState s, int at, Linearization model, double[] expected, boolean hasOutliers) {
    double[] t = s.trust;
    boolean isRobust = hasOutliers && t[at + STREAK] <= MAX_ALONE;
    double cap = isRobust ? ROBUST : LARGEST;
    double mean = isRobust ? ROBUST_MEAN : 1.0;
    if (t[at + LEARNT] == 0.0) {
      t[at + FACTOR] = 1.0;
      t[at + LEARNT] = PRIOR;
    }
    boolean hasPrevious = t[at + HAS_PREVIOUS] == model.rows;
    boolean wasRefused = t[at + STREAK] > 0.0; // so there was no update in between
    double sum = 0.0;
    double ofState = 0.0;
    for (int i = 0; i < model.rows; i++) {
      double inClaims = model.innovation[i] / Math.sqrt(model.variance[i]);
      double step = inClaims - t[at + PREVIOUS + i];
      double own = wasRefused ? 0.0 : expected[i] / model.variance[i];
      sum += Math.min(step * step / 2.0 - own, cap * Math.max(1.0, t[at + FACTOR])) / mean;
      ofState += own / model.rows;
      t[at + PREVIOUS + i] = inClaims;
    }
    t[at + HAS_PREVIOUS] = model.rows;
    if (hasPrevious) {
      // An uncertain state hides the source's own scatter: weight by the inverse variance of shown.
      double assumed = Math.max(1.0, t[at + FACTOR]);
      double visible = assumed / (assumed + ofState);
      double weight = visible * visible;
      t[at + LEARNT] = Math.min(window, t[at + LEARNT] + weight);
      t[at + FACTOR] += weight * (sum / model.rows - t[at + FACTOR]) / t[at + LEARNT];
      t[at + FACTOR] = Math.max(0.01, t[at + FACTOR]);
    }
  }

  /** Records a vector within the gate, and how many directly before it were beyond. */
  static void countOutliers(double[] t, int at) {
    double alone = t[at + STREAK] <= MAX_ALONE ? t[at + STREAK] : 0.0;
    t[at + OUTLIERS] += (alone - t[at + OUTLIERS]) / OUTLIER_MEMORY;
  }

  /**
   * Records the claimed variance of an altitude that has been used, and what the covariance lacks
   * of the persistent errors of all altitudes used lately.
   *
   * @param claim 0 if its errors do not persist
   * @param latelyMicros how long ago at most
   */
  void claim(FilterState s, int at, double claim, double latelyMicros) {
    s.trust[at + CLAIM] = claim + s.trust[at + ALIGNED];
    double information = 0.0;
    for (int source = 0; source < names.size(); source++) {
      for (SensedQuantity each :
          new SensedQuantity[] {SensedQuantity.ALTITUDE, SensedQuantity.LOCAL_DOWN}) {
        int other = isKnown(source, each) ? of(s, source, each) : at;
        boolean isOther = other != at && s.trust[other + USED] > 0.0;
        if (isOther && s.micros - s.trust[other + LAST_USED] < latelyMicros) {
          information += 1.0 / s.trust[other + CLAIM];
        }
      }
    }
    double persistent = 1.0 / (information + 1.0 / s.trust[at + CLAIM]);
    s.x[FilterState.ALTITUDE_ERROR] =
        Math.max(0.0, persistent - s.variance(FilterState.POSITION + 2));
  }

  /** Whether an altitude has been used that came with positions. */
  boolean hasReceiverAltitude(FilterState s) {
    for (int source = 0; source < names.size(); source++) {
      boolean isReceiver =
          isKnown(source, SensedQuantity.PLACE) || isKnown(source, SensedQuantity.LOCAL_PLACE);
      if (isReceiver
          && isKnown(source, SensedQuantity.ALTITUDE)
          && s.trust[of(s, source, SensedQuantity.ALTITUDE) + USED] > 0.0) {
        return true;
      }
    }
    return false;
  }

  /**
   * Compares the newest altitudes of all barometers with one of a receiver.
   *
   * @param model the receiver's altitude
   */
  void compareBarometers(FilterState s, Linearization model) {
    for (int source = 0; source < names.size(); source++) {
      if (isKnown(source, SensedQuantity.ALTITUDE)) {
        AltitudeDifference.receiver(
            s.trust,
            of(s, source, SensedQuantity.ALTITUDE) + DIFFERENCE,
            model.innovation[0],
            model.variance[0],
            s.micros);
      }
    }
  }

  /** Whether an altitude is subject to an offset that was learnt from other altitudes. */
  boolean isShifted(FilterState s, int source, SensedQuantity quantity) {
    return quantity == SensedQuantity.ALTITUDE
        && isKnown(source, quantity)
        && s.trust[of(s, source, quantity) + HAS_OFFSET] != 0.0;
  }

  /** Whether that holds for any source. */
  boolean isAnyShifted(FilterState s) {
    boolean isAny = false;
    for (int source = 0; source < names.size(); source++) {
      isAny |= isShifted(s, source, SensedQuantity.ALTITUDE);
    }
    return isAny;
  }

  /** Subtracts known offsets no longer, because an altitude without one has been used. */
  void endShifts(FilterState s) {
    for (int source = 0; source < names.size(); source++) {
      if (isShifted(s, source, SensedQuantity.ALTITUDE)) {
        shift(s, of(s, source, SensedQuantity.ALTITUDE), false);
      }
    }
  }

  /** Subtracts the known offset of an altitude from now on, or no longer. */
  static void shift(FilterState s, int at, boolean isOn) {
    double[] t = s.trust;
    t[at + HAS_OFFSET] = isOn ? 1.0 : 0.0;
    t[at + OFFSET] = isOn ? KnownOffset.metres(t, at + KNOWN_OFFSET) : 0.0;
    t[at + ALIGNED] = 0.0;
    t[at + STREAK] = 0.0;
    t[at + HAS_PREVIOUS] = 0.0;
  }

  static void notedNis(FilterState s, int at, double nis) {
    s.trust[at + NIS] = nis;
  }
}
