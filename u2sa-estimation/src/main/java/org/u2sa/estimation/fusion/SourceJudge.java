package org.u2sa.estimation.fusion;

import org.u2sa.estimation.measurement.AltitudeDifference;
import org.u2sa.estimation.measurement.KnownOffset;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.MotionHeading;

/**
 * Decides which sources are trusted: detects sources that repeat a value while the vehicle moves
 * (frozen), sources that contradict others in one direction (biased), and when the estimate itself
 * must be reset.
 */
final class SourceJudge {
  private static final double MICROS = 1e6;
  private static final int BIASED_AFTER = 8;
  private static final int TRUSTED_AFTER = 5;
  private static final int RESET_AFTER = 3;
  private static final double FROZEN_RUN = 3.0;
  private static final double LONGEST_HOLD_S = 0.2; // of a heading while the vehicle turns
  private static final double KNOWN_RAD = 0.26; // sigma of a heading
  private static final double SILENT_AFTER_S = 1.0;
  private static final double SILENT_INTERVALS = 5.0;
  private static final double LATELY_S = 1.0;

  private final FilterTuning tuning;
  private final SourceTrust trust;

  SourceJudge(FilterTuning tuning, SourceTrust trust) {
    this.tuning = tuning;
    this.trust = trust;
  }

  /**
   * Whether an inertial sensor repeats its noise and other sources contradict the estimate, or have
   * done so since its values stopped changing.
   */
  boolean isStuck(FilterState s, int source) {
    double[] t = s.trust;
    int at = trust.of(s, source);
    boolean isKnown = t[at + SourceTrust.IS_FROZEN] != 0.0;
    boolean isStuck =
        t[at + SourceTrust.RUN] >= 10.0 * FROZEN_RUN && (isKnown || isContradicted(s, source));
    if (isStuck) {
      t[at + SourceTrust.IS_FROZEN] = 1.0;
      t[trust.of(s, source, SensedQuantity.BODY_RATES) + SourceTrust.GATED]++;
    }
    return isStuck;
  }

  /**
   * Leaves out a vector of a source that is frozen. It contradicts nothing either: what it repeats
   * says nothing about the estimate.
   */
  boolean leavesOutFrozen(FilterState s, int source, int at) {
    boolean isFrozen = s.trust[trust.of(s, source) + SourceTrust.IS_FROZEN] != 0.0;
    if (isFrozen) {
      s.trust[at + SourceTrust.GATED]++;
      s.trust[at + SourceTrust.STREAK] = 0.0;
    }
    return isFrozen;
  }

  /** Finds whether a source repeats its values while the vehicle moves. */
  void lookWhetherFrozen(
      FilterState s,
      Linearization model,
      double[] expected,
      int source,
      SensedQuantity quantity,
      int at) {
    double[] t = s.trust;
    int own = trust.of(s, source);
    double began = t[own + SourceTrust.MESSAGES] - t[own + SourceTrust.RUN];
    boolean isFirst = t[at + SourceTrust.RUN_OF] != began;
    t[at + SourceTrust.RUN_OF] = began;
    for (int i = 0; i < model.rows; i++) {
      if (isFirst) {
        t[at + SourceTrust.RUN_START + i] = model.predicted[i];
        continue;
      }
      double moved = model.predicted[i] - t[at + SourceTrust.RUN_START + i];
      if (quantity == SensedQuantity.HEADING) {
        moved = Math.IEEEremainder(moved, 2.0 * Math.PI);
      }
      // Positions never repeat while the vehicle moves. Speeds and angles may for a while, so the
      // estimate must have changed by more than its uncertainty.
      double limit2 =
          quantity == SensedQuantity.PLACE
              ? model.variance[i]
              : 4.0 * model.variance[i] + 16.0 * expected[i];
      boolean isApart =
          quantity == SensedQuantity.PLACE
              || model.innovation[i] * model.innovation[i] > limit2; // estimate not dragged along
      if (t[own + SourceTrust.RUN] >= FROZEN_RUN && isApart && moved * moved > limit2) {
        t[own + SourceTrust.IS_FROZEN] = 1.0;
      }
    }
  }

  /**
   * Factor on the variance of a heading. One that repeats exactly may have been measured at any
   * time since its value was new, so it is uncertain by the turn since, until it has repeated for
   * so long that the vehicle rather stands.
   *
   * @param factor on the claimed variance
   */
  double repeatedHeading(FilterState s, Linearization heading, int source, int at, double factor) {
    if (!isHeld(s, source)) {
      return 1.0;
    }
    double since = heading.predicted[0] - s.trust[at + SourceTrust.RUN_START];
    double turned = Math.IEEEremainder(since, 2.0 * Math.PI);
    return 1.0 + turned * turned / (factor * heading.variance[0]);
  }

  /**
   * Whether a source repeats its values, but not for so long that it rather measures them again.
   */
  boolean isHeld(FilterState s, int source) {
    int own = trust.of(s, source);
    double run = s.trust[own + SourceTrust.RUN];
    return run > 0.0 && run * s.trust[own + SourceTrust.INTERVAL] <= LONGEST_HOLD_S;
  }

  /** Whether a vector within the gate is used. A biased source must agree several times first. */
  static boolean passes(FilterState s, int at) {
    double[] t = s.trust;
    t[at + SourceTrust.STREAK] = 0.0;
    if (t[at + SourceTrust.IS_BIASED] == 0.0) {
      return true;
    }
    t[at + SourceTrust.PASSED]++;
    if (t[at + SourceTrust.PASSED] < TRUSTED_AFTER) {
      t[at + SourceTrust.GATED]++;
      return false;
    }
    t[at + SourceTrust.IS_BIASED] = 0.0;
    return true;
  }

  /**
   * Rejects a barometer that receivers have shown to be wrong. While it was used, it has drawn the
   * estimate towards itself: by the difference from the receivers less that from the estimate.
   */
  static void rejectWrong(FilterState s, int at) {
    double[] t = s.trust;
    if (t[at + SourceTrust.IS_BIASED] == 0.0) {
      double drawn =
          AltitudeDifference.metres(t, at + SourceTrust.DIFFERENCE)
              - KnownOffset.metres(t, at + SourceTrust.KNOWN_OFFSET);
      s.p.data[(FilterState.POSITION + 2) * (FilterState.N + 1)] += drawn * drawn;
    }
    t[at + SourceTrust.IS_BIASED] = 1.0;
    t[at + SourceTrust.PASSED] = 0.0;
    t[at + SourceTrust.GATED]++;
  }

  /**
   * Records a vector beyond the gate.
   *
   * @return whether the estimate must be reset from it, because no other source supports the
   *     estimate, or the motion shows that this heading is right and the estimate's is wrong
   */
  boolean gated(FilterState s, Linearization model, int source, SensedQuantity quantity, int at) {
    double[] t = s.trust;
    t[at + SourceTrust.GATED]++;
    t[at + SourceTrust.STREAK]++;
    t[at + SourceTrust.PASSED] = 0.0;
    double streak = t[at + SourceTrust.STREAK];
    if (streak == 1.0) {
      t[at + SourceTrust.STREAK_SINCE] = s.micros;
    }
    RefusedScatter.note(t, model, at);
    double mean2 = 0.0;
    for (int i = 0; i < model.rows; i++) {
      double inClaims = model.innovation[i] / Math.sqrt(model.variance[i]);
      double before = streak == 1.0 ? 0.0 : t[at + SourceTrust.STREAK_MEAN + i];
      t[at + SourceTrust.STREAK_MEAN + i] = before + (inClaims - before) / streak;
      mean2 += t[at + SourceTrust.STREAK_MEAN + i] * t[at + SourceTrust.STREAK_MEAN + i];
    }
    boolean isOneSided = mean2 > 9.0 * SourceTrust.factor(s, at);
    boolean isHeading = quantity == SensedQuantity.HEADING;
    boolean isRefuted = isHeading && isHeadingRefuted(s, model.innovation[0]);
    boolean isConfirmed = isHeading && isHeadingConfirmed(s, model.innovation[0]);
    boolean isAlone = !isRefuted && !isCorroborated(s, source, quantity);
    if (streak >= BIASED_AFTER && isOneSided && !isAlone) {
      t[at + SourceTrust.IS_BIASED] = 1.0;
    }
    double since = (s.micros - t[at + SourceTrust.STREAK_SINCE]) / MICROS;
    boolean isLasting = since >= tuning.resetAfterS() && isAlone;
    return streak >= RESET_AFTER && (isLasting || isConfirmed);
  }

  /**
   * Whether the motion shows that a measured heading is wrong, or has shown it and the heading is
   * still known.
   */
  private static boolean isHeadingRefuted(FilterState s, double innovation) {
    boolean isKnown = s.variance(FilterState.ATTITUDE + 2) < KNOWN_RAD * KNOWN_RAD;
    boolean isFar = Math.abs(Math.IEEEremainder(innovation, 2.0 * Math.PI)) > KNOWN_RAD;
    return MotionHeading.refutes(s.motion, innovation)
        || isFar && isKnown && MotionHeading.isFollowed(s.motion);
  }

  /** Whether the motion shows that a measured heading is right, and that the estimate's is not. */
  private static boolean isHeadingConfirmed(FilterState s, double innovation) {
    return MotionHeading.refutes(s.motion, 0.0) && !MotionHeading.refutes(s.motion, innovation);
  }

  /**
   * Whether measurements of another source are being rejected repeatedly. Ignores sources that have
   * gone silent, and turn rates, which often come from the same gyroscopes as the rates in
   * question.
   */
  boolean isContradicted(FilterState s, int source) {
    for (int other = 0; other < trust.sources(); other++) {
      if (other != source && contradicts(s, other)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Whether that holds for sources of devices other than the accuser's: what one device measures,
   * late or wrong, is no evidence for the rest of it.
   */
  boolean isContradicted(FilterState s, int source, int accuser) {
    for (int other = 0; other < trust.sources(); other++) {
      if (other != source && !trust.isSameDevice(other, accuser) && contradicts(s, other)) {
        return true;
      }
    }
    return false;
  }

  private boolean contradicts(FilterState s, int source) {
    for (int q = SensedQuantity.PLACE.ordinal(); q < SensedQuantity.count(); q++) {
      SensedQuantity quantity = SensedQuantity.at(q);
      if (quantity != SensedQuantity.EULER_RATES
          && trust.isKnown(source, quantity)
          && s.trust[trust.of(s, source, quantity) + SourceTrust.STREAK] >= RESET_AFTER) {
        return isHeard(s, source);
      }
    }
    return false;
  }

  private boolean isHeard(FilterState s, int source) {
    int at = trust.of(s, source);
    double since = (s.micros - s.trust[at + SourceTrust.LAST_MICROS]) / MICROS;
    double interval = s.trust[at + SourceTrust.INTERVAL];
    return since <= Math.max(SILENT_AFTER_S, SILENT_INTERVALS * interval);
  }

  /**
   * Whether another source's measurements of the same quantity were used recently. An altitude with
   * an offset that others have shown supports nothing: they must be able to take over again.
   */
  boolean isCorroborated(FilterState s, int source, SensedQuantity quantity) {
    return isCorroborated(s, source, quantity, s.micros - tuning.resetAfterS() * MICROS);
  }

  /** Whether they were used so recently that the estimate is still theirs. */
  boolean isSupported(FilterState s, int source, SensedQuantity quantity) {
    return isCorroborated(s, source, quantity, s.micros - LATELY_S * MICROS);
  }

  /** Whether they were used since this source's were first rejected. */
  boolean isCorroboratedSinceRejected(FilterState s, int source, SensedQuantity quantity, int at) {
    return isCorroborated(s, source, quantity, s.trust[at + SourceTrust.STREAK_SINCE]);
  }

  private boolean isCorroborated(
      FilterState s, int source, SensedQuantity quantity, double afterMicros) {
    for (int other = 0; other < trust.sources(); other++) {
      for (int q = 0; q < SensedQuantity.count(); q++) {
        SensedQuantity each = SensedQuantity.at(q);
        if (each.corroborates(quantity)
            && trust.isKnown(other, each)
            && !(other == source && each == quantity)
            && !trust.isShifted(s, other, each)) {
          double last = s.trust[trust.of(s, other, each) + SourceTrust.LAST_USED];
          if (last > 0.0 && last > afterMicros) {
            return true;
          }
        }
      }
    }
    return false;
  }
}
