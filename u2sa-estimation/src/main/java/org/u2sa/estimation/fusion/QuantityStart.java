package org.u2sa.estimation.fusion;

import org.u2sa.estimation.measurement.KnownOffset;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;

/**
 * Initialises a quantity from its first measurement, and resets it from one that proves more
 * reliable than the estimate.
 */
final class QuantityStart {
  private static final double AGAIN_S = 30.0;
  private static final double DISTRUST_STEP = 4.0; // factor on a variance
  private static final double MAX_DISTRUST = 1e4;
  private static final double GONE_STREAK = 3.0; // rejected altitudes
  private static final double GONE_AFTER_S = 1.0;
  private final FilterTuning tuning;
  private final LeverArm lever = new LeverArm();

  QuantityStart(FilterTuning tuning) {
    this.tuning = tuning;
  }

  /** Resets a quantity that its source contradicts persistently. */
  void reset(FilterState s, Measurement m, SensedQuantity quantity, int at, int slot) {
    double factor = SourceTrust.factor(s, at);
    switch (quantity) {
      case PLACE:
        s.hasPlace = false;
        break;
      case LOCAL_PLACE:
        s.trust[at + SourceTrust.HAS_OFFSET] = 0.0;
        s.hasLocal = s.hasPlace;
        break;
      case ALTITUDE:
        if (s.trust[at + SourceTrust.HAS_OFFSET] != 0.0) {
          s.trust[at + SourceTrust.ALIGNED] += m.sigma(quantity, 0) * m.sigma(quantity, 0);
        }
        KnownOffset.forget(s.trust, at + SourceTrust.KNOWN_OFFSET);
        s.hasAltitude = false;
        break;
      case HEADING:
        Alignment.heading(
            s, m.value(quantity, 0), factor * m.sigma(quantity, 0) * m.sigma(quantity, 0));
        Alignment.gyroBias(s, 2);
        PersistentErrors.share(s, slot);
        break;
      case TILT:
        s.hasTilt = false;
        Alignment.gyroBias(s, 0);
        Alignment.gyroBias(s, 1);
        break;
      case VELOCITY:
      case BODY_VELOCITY:
        double speed = tuning.domain().speedSigmaMps;
        for (int i = 0; i < 3; i++) {
          s.isolate(FilterState.VELOCITY + i, speed * speed);
        }
        break;
      default:
        return;
    }
    s.resets++;
    s.trust[at + SourceTrust.STREAK] = 0.0;
    begin(s, m, quantity, at, slot);
  }

  /**
   * Called before a reset from this source. If resets recur within a short time, source and
   * estimate are inconsistent: an unmeasured heading is discarded; otherwise the source is
   * distrusted, because dead reckoning shows that its claimed sigma is too small.
   */
  static void doubt(FilterState s, SensedQuantity quantity, int at) {
    double[] t = s.trust;
    double since = (s.micros - t[at + SourceTrust.RESET_MICROS]) * 1e-6;
    boolean isAgain = t[at + SourceTrust.RESET_MICROS] > 0.0 && since < AGAIN_S;
    t[at + SourceTrust.RESET_MICROS] = s.micros;
    boolean isOfMotion = quantity.isPlace() || SpeedDoubt.isOfSpeed(quantity);
    if (!isAgain || !isOfMotion) {
      return;
    }
    if (SpeedDoubt.isHeadingGuessed(s)) {
      s.hasHeading = false;
      s.isolate(FilterState.ATTITUDE + 2, Math.PI * Math.PI / 3.0);
    } else if (quantity.isPlace() && s.hasSpeedInput()) {
      double factor = SourceTrust.factor(s, at);
      t[at + SourceTrust.DISTRUST] = Math.min(MAX_DISTRUST, DISTRUST_STEP * factor);
    }
  }

  /**
   * Initialises an unknown quantity from its first measurement.
   *
   * @param slot slot of the source in {@link PersistentErrors}
   * @return whether the measurement is thereby used up
   */
  boolean begin(FilterState s, Measurement m, SensedQuantity quantity, int at, int slot) {
    lever.look(s, m);
    double factor = SourceTrust.factor(s, at);
    double v0 = factor * m.sigma(quantity, 0) * m.sigma(quantity, 0);
    double v1 = factor * m.sigma(quantity, 1) * m.sigma(quantity, 1);
    switch (quantity) {
      case PLACE:
        if (s.hasPlace || !m.isWhole(quantity)) {
          return false;
        }
        Alignment.place(
            s,
            m.value(quantity, 0),
            m.value(quantity, 1),
            v0 + lever.apartVariance(0),
            v1 + lever.apartVariance(1));
        HeadingSearch.restart(s);
        s.x[FilterState.LATITUDE] -= lever.apartM(0) / s.northRadiusM();
        double longitude = s.x[FilterState.LONGITUDE] - lever.apartM(1) / s.axisDistanceM();
        s.x[FilterState.LONGITUDE] = Math.IEEEremainder(longitude, 2.0 * Math.PI);
        PersistentErrors.share(s, slot);
        return true;
      case ALTITUDE:
        if (s.hasAltitude) {
          return false;
        }
        double known = s.trust[at + SourceTrust.OFFSET];
        Alignment.altitude(s, m.value(quantity, 0) - known + lever.apartM(2), v0);
        return true;
      case LOCAL_PLACE:
        if (s.hasLocal || s.hasPlace || !m.isWhole(quantity)) {
          return false;
        }
        Alignment.local(
            s,
            m.value(quantity, 0) - lever.apartM(0),
            m.value(quantity, 1) - lever.apartM(1),
            v0 + lever.apartVariance(0),
            v1 + lever.apartVariance(1));
        s.trust[at + SourceTrust.HAS_OFFSET] = 1.0;
        return true;
      case LOCAL_DOWN:
        if (s.hasAltitude) {
          return false;
        }
        s.x[FilterState.NORTH + 2] = m.value(quantity, 0) - lever.apartM(2);
        Alignment.altitude(s, -s.x[FilterState.NORTH + 2], v0);
        s.trust[at + SourceTrust.HAS_OFFSET] = 1.0;
        return true;
      case HEADING:
        if (s.hasHeading) {
          return false;
        }
        Alignment.heading(s, m.value(quantity, 0), v0);
        PersistentErrors.share(s, slot);
        return true;
      case TILT:
        if (s.hasTilt || !m.isWhole(quantity)) {
          return false;
        }
        Alignment.tilt(
            s,
            m.value(quantity, 0),
            m.value(quantity, 1),
            m.sigma(quantity, 0),
            m.sigma(quantity, 1));
        return true;
      case FLUID_VELOCITY:
        if (!s.hasFlow && s.hasHeading) {
          Alignment.flow(s, tuning.flowSigma());
        }
        return false;
      default:
        return false;
    }
  }

  /** Aligns a local frame with a different origin so that its first position fits. */
  static void shift(FilterState s, Linearization model, SensedQuantity quantity, int at) {
    double[] t = s.trust;
    if (t[at + SourceTrust.HAS_OFFSET] == 0.0) {
      boolean isElsewhere = quantity == SensedQuantity.LOCAL_DOWN || s.hasPlace;
      for (int i = 0; i < model.rows; i++) {
        t[at + SourceTrust.OFFSET + i] = isElsewhere ? model.innovation[i] : 0.0;
      }
      if (quantity == SensedQuantity.LOCAL_DOWN) {
        t[at + SourceTrust.ALIGNED] =
            s.variance(FilterState.POSITION + 2) + s.x[FilterState.ALTITUDE_ERROR];
      }
      t[at + SourceTrust.HAS_OFFSET] = 1.0;
    }
    for (int i = 0; i < model.rows; i++) {
      model.innovation[i] -= t[at + SourceTrust.OFFSET + i];
    }
  }

  /**
   * Subtracts the known offset of a barometer or depth gauge from its altitude while no other
   * source measures the altitude: its value is wrong, but its changes are right.
   *
   * @param isAlone whether no other source's altitudes were used lately
   */
  static void shiftKnown(FilterState s, Linearization model, int at, boolean isAlone) {
    double[] t = s.trust;
    boolean isShifted = t[at + SourceTrust.HAS_OFFSET] != 0.0;
    if (isShifted && isOffsetGone(s, model, at)) {
      SourceTrust.shift(s, at, false);
      KnownOffset.forget(t, at + SourceTrust.KNOWN_OFFSET);
      isShifted = false;
    }
    boolean isKnown = KnownOffset.isKnown(t, at + SourceTrust.KNOWN_OFFSET);
    if (!isShifted && isAlone && isKnown) {
      SourceTrust.shift(s, at, true);
      isShifted = true;
    }
    if (isShifted && isKnown) {
      double altitude = s.x[FilterState.ALTITUDE];
      t[at + SourceTrust.ALIGNED] =
          KnownOffset.variance(t, at + SourceTrust.KNOWN_OFFSET, altitude, s.micros);
    }
    if (isShifted) {
      model.shift(t[at + SourceTrust.OFFSET], 0.0);
      model.variance[0] =
          PersistentErrors.NEW_VARIANCE * model.variance[0] + t[at + SourceTrust.ALIGNED];
    }
  }

  /**
   * Learns the offset of an altitude that is rated biased, or less certain than the estimate by its
   * own claim.
   */
  static void learnOffset(FilterState s, Linearization model, int at) {
    double reference = s.variance(FilterState.POSITION + 2) + s.x[FilterState.ALTITUDE_ERROR];
    boolean isBiased = s.trust[at + SourceTrust.IS_BIASED] != 0.0;
    if (isBiased || reference < model.variance[0]) {
      KnownOffset.learn(
          s.trust,
          at + SourceTrust.KNOWN_OFFSET,
          model.innovation[0],
          model.variance[0],
          s.x[FilterState.ALTITUDE],
          reference,
          s.micros);
    }
  }

  /** Whether rejected altitudes agree better without their offset, as after a corrected QNH. */
  private static boolean isOffsetGone(FilterState s, Linearization altitude, int at) {
    double apart = altitude.innovation[0];
    double[] t = s.trust;
    return t[at + SourceTrust.STREAK] >= GONE_STREAK
        && (s.micros - t[at + SourceTrust.STREAK_SINCE]) * 1e-6 >= GONE_AFTER_S
        && Math.abs(apart) < Math.abs(apart - t[at + SourceTrust.OFFSET]);
  }
}
