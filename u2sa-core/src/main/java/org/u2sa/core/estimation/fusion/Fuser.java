package org.u2sa.core.estimation.fusion;

/**
 * Fuses one measurement into a state: carries the state ahead, begins what was unknown, and
 * corrects by each vector that the gate lets through and the source is trusted with.
 */
final class Fuser {
  private static final double MICROS = 1e6;
  private static final double UNUSED_INERTIAL_SIGMA = 1.0; // m/s²: acceleration taken for gravity
  private static final double TRACK_SIGMA_RAD = 0.2; // of a direction of motion as heading
  private static final double TRACK_AFTER_S = 3.0;
  private static final double FLUID_FRESH_S = 2.0;
  private static final double READABLE_SIGMAS = 3.0;
  private static final int BIASED_AFTER = 8;
  private static final int TRUSTED_AFTER = 5;
  private static final int RESET_AFTER = 3;
  private static final double FROZEN_RUN = 3.0;

  private final FilterTuning tuning;
  private final SourceTrust trust;
  private final ProcessModel process;
  private final InertialInput inertial;
  private final MeasurementModel model = new MeasurementModel();
  private final KalmanUpdate update = new KalmanUpdate();
  private final double[] gates = new double[4];

  Fuser(FilterTuning tuning, SourceTrust trust, ProcessModel process) {
    this.tuning = tuning;
    this.trust = trust;
    this.process = process;
    inertial = new InertialInput(tuning);
    for (int rows = 1; rows < gates.length; rows++) {
      gates[rows] = threshold(rows, tuning.gate());
    }
  }

  /**
   * χ² of that many degrees of freedom, as far out as z normal deviations (Wilson, Hilferty 1931).
   */
  static double threshold(int rows, double z) {
    double spread = 2.0 / (9.0 * rows);
    return rows * Math.pow(1.0 - spread + z * Math.sqrt(spread), 3.0);
  }

  /** Fuses a measurement that is not older than the state. */
  void fuse(FilterState s, Measurement m, int source) {
    if (!s.isStarted) {
      Alignment.start(s, m.micros(), tuning);
    }
    trust.heard(s, m, source);
    boolean drives = m.isWhole(SensedQuantity.BODY_RATES) && inertial.isMain(s, source, m.micros());
    if (drives && !isStuck(s, source)) {
      inertial.take(s, m, source, process);
      count(s, trust.of(s, source, SensedQuantity.BODY_RATES), SourceTrust.USED);
    } else {
      process.predict(s, m.micros());
      if (!m.isWhole(SensedQuantity.BODY_RATES)) {
        vector(s, m, source, SensedQuantity.BODY_RATES);
      }
    }
    if (drives && !s.isStrapdown && s.hasTilt) {
      vector(s, m, source, SensedQuantity.SPECIFIC_FORCE);
    }
    for (int q = SensedQuantity.PLACE.ordinal(); q < SensedQuantity.count(); q++) {
      vector(s, m, source, SensedQuantity.at(q));
    }
    headingOfMotion(s);
    constrain(s);
  }

  /** An inertial sensor whose noise stands still does not measure, if others say so too. */
  private boolean isStuck(FilterState s, int source) {
    double[] t = s.trust;
    int at = trust.of(s, source);
    boolean isStuck = t[at + SourceTrust.RUN] >= 10.0 * FROZEN_RUN && isContradicted(s, source);
    if (isStuck) {
      t[at + SourceTrust.IS_FROZEN] = 1.0;
      count(s, trust.of(s, source, SensedQuantity.BODY_RATES), SourceTrust.GATED);
    }
    return isStuck;
  }

  private boolean isContradicted(FilterState s, int source) {
    for (int other = 0; other < trust.sources(); other++) {
      for (int q = SensedQuantity.PLACE.ordinal(); q < SensedQuantity.count(); q++) {
        SensedQuantity quantity = SensedQuantity.at(q);
        if (other != source
            && trust.isKnown(other, quantity)
            && s.trust[trust.of(s, other, quantity) + SourceTrust.STREAK] >= RESET_AFTER) {
          return true;
        }
      }
    }
    return false;
  }

  private static void count(FilterState s, int at, int what) {
    s.trust[at + what]++;
    if (what == SourceTrust.USED) {
      s.trust[at + SourceTrust.LAST_USED] = s.micros;
      s.trust[at + SourceTrust.STREAK] = 0.0;
    }
  }

  private void vector(FilterState s, Measurement m, int source, SensedQuantity quantity) {
    if (!m.has(quantity)) {
      return;
    }
    int at = trust.of(s, source, quantity);
    if (begin(s, m, quantity, at)) {
      count(s, at, SourceTrust.USED);
      used(s, quantity);
      return;
    }
    boolean isReadable = quantity != SensedQuantity.FLUID_VELOCITY || isReadable(m);
    if (!isReadable || !model.look(s, m, quantity) || model.rows == 0) {
      return;
    }
    if (quantity == SensedQuantity.SPECIFIC_FORCE) {
      for (int i = 0; i < model.rows; i++) {
        model.variance[i] += UNUSED_INERTIAL_SIGMA * UNUSED_INERTIAL_SIGMA;
      }
    }
    if (quantity == SensedQuantity.LOCAL_PLACE || quantity == SensedQuantity.LOCAL_DOWN) {
      shift(s, quantity, at);
    }
    double nis = update.prepare(s, model, SourceTrust.factor(s, at));
    if (isFrozen(s, source, quantity, at)) {
      s.trust[at + SourceTrust.GATED]++;
      return;
    }
    trust.learn(s, at, model, update.expected);
    SourceTrust.notedNis(s, at, nis);
    if (nis > gates[model.rows]) {
      gated(s, m, source, quantity, at);
    } else if (passes(s, at)) {
      correct(s, source, quantity, at);
    }
  }

  /**
   * A pitot tube reads about nothing in slow air, whether that comes from the front, the side or
   * behind: near its noise it says nothing of the wind.
   */
  private boolean isReadable(Measurement m) {
    return tuning.domain() != MotionDomain.AIR
        || !m.has(SensedQuantity.FLUID_VELOCITY, 0)
        || m.value(SensedQuantity.FLUID_VELOCITY, 0)
            > READABLE_SIGMAS * m.sigma(SensedQuantity.FLUID_VELOCITY, 0);
  }

  private void correct(FilterState s, int source, SensedQuantity quantity, int at) {
    boolean persists =
        quantity == SensedQuantity.PLACE
            || quantity == SensedQuantity.ALTITUDE
            || quantity == SensedQuantity.LOCAL_PLACE;
    if (persists && tuning.positionCorrelationS() > 0.0) {
      // Errors that persist for τ tell as much as independent ones at every 2 τ.
      double interval = Math.max(1e-3, s.trust[trust.of(s, source) + SourceTrust.INTERVAL]);
      double repeats = 1.0 + 2.0 * tuning.positionCorrelationS() / interval;
      update.weigh(model, SourceTrust.factor(s, at) * repeats);
    }
    update.apply(s, model);
    count(s, at, SourceTrust.USED);
    used(s, quantity);
  }

  private static void used(FilterState s, SensedQuantity quantity) {
    switch (quantity) {
      case PLACE:
      case LOCAL_PLACE:
        s.positionMicros = s.micros;
        break;
      case VELOCITY:
      case BODY_VELOCITY:
        s.velocityMicros = s.micros;
        break;
      case HEADING:
        s.headingMicros = s.micros;
        break;
      case FLUID_VELOCITY:
        s.fluidMicros = s.micros;
        break;
      default:
        break;
    }
  }

  /** A source that was biased must agree some times before it counts again. */
  private static boolean passes(FilterState s, int at) {
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

  private void gated(FilterState s, Measurement m, int source, SensedQuantity quantity, int at) {
    double[] t = s.trust;
    t[at + SourceTrust.GATED]++;
    t[at + SourceTrust.STREAK]++;
    t[at + SourceTrust.PASSED] = 0.0;
    double streak = t[at + SourceTrust.STREAK];
    if (streak == 1.0) {
      t[at + SourceTrust.STREAK_SINCE] = s.micros;
    }
    double mean2 = 0.0;
    for (int i = 0; i < model.rows; i++) {
      double inClaims = model.innovation[i] / Math.sqrt(model.variance[i]);
      double before = streak == 1.0 ? 0.0 : t[at + SourceTrust.STREAK_MEAN + i];
      t[at + SourceTrust.STREAK_MEAN + i] = before + (inClaims - before) / streak;
      mean2 += t[at + SourceTrust.STREAK_MEAN + i] * t[at + SourceTrust.STREAK_MEAN + i];
    }
    boolean isOneSided = mean2 > 9.0 * SourceTrust.factor(s, at);
    boolean isAlone = !isCorroborated(s, source, quantity);
    if (streak >= BIASED_AFTER && isOneSided && !isAlone) {
      t[at + SourceTrust.IS_BIASED] = 1.0;
    }
    double since = (s.micros - t[at + SourceTrust.STREAK_SINCE]) / MICROS;
    if (streak >= RESET_AFTER && since >= tuning.resetAfterS() && isAlone) {
      reset(s, m, quantity, at);
    }
  }

  /** Whether another source's measurements of the same thing were used lately. */
  private boolean isCorroborated(FilterState s, int source, SensedQuantity quantity) {
    for (int other = 0; other < trust.sources(); other++) {
      for (int q = 0; q < SensedQuantity.count(); q++) {
        SensedQuantity each = SensedQuantity.at(q);
        if (each.corroborates(quantity)
            && trust.isKnown(other, each)
            && !(other == source && each == quantity)) {
          double last = s.trust[trust.of(s, other, each) + SourceTrust.LAST_USED];
          if (last > 0.0 && (s.micros - last) / MICROS < tuning.resetAfterS()) {
            return true;
          }
        }
      }
    }
    return false;
  }

  private void reset(FilterState s, Measurement m, SensedQuantity quantity, int at) {
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
        s.hasAltitude = false;
        break;
      case HEADING:
        Alignment.heading(
            s, m.value(quantity, 0), factor * m.sigma(quantity, 0) * m.sigma(quantity, 0));
        break;
      case TILT:
        s.hasTilt = false;
        break;
      case VELOCITY:
      case BODY_VELOCITY:
        double speed = tuning.domain().speedSigmaMps();
        for (int i = 0; i < 3; i++) {
          s.isolate(FilterState.VELOCITY + i, speed * speed);
        }
        break;
      default:
        return;
    }
    s.resets++;
    s.trust[at + SourceTrust.STREAK] = 0.0;
    begin(s, m, quantity, at);
  }

  /** Takes a quantity that was unknown from its first measurement. */
  private boolean begin(FilterState s, Measurement m, SensedQuantity quantity, int at) {
    double factor = SourceTrust.factor(s, at);
    double v0 = factor * m.sigma(quantity, 0) * m.sigma(quantity, 0);
    double v1 = factor * m.sigma(quantity, 1) * m.sigma(quantity, 1);
    switch (quantity) {
      case PLACE:
        if (s.hasPlace || !m.isWhole(quantity)) {
          return false;
        }
        Alignment.place(s, m.value(quantity, 0), m.value(quantity, 1), v0, v1);
        return true;
      case ALTITUDE:
        if (s.hasAltitude) {
          return false;
        }
        Alignment.altitude(s, m.value(quantity, 0), v0);
        return true;
      case LOCAL_PLACE:
        if (s.hasLocal || s.hasPlace || !m.isWhole(quantity)) {
          return false;
        }
        Alignment.local(s, m.value(quantity, 0), m.value(quantity, 1), v0, v1);
        s.trust[at + SourceTrust.HAS_OFFSET] = 1.0;
        return true;
      case LOCAL_DOWN:
        if (s.hasAltitude) {
          return false;
        }
        s.x[FilterState.NORTH + 2] = m.value(quantity, 0);
        Alignment.altitude(s, -m.value(quantity, 0), v0);
        s.trust[at + SourceTrust.HAS_OFFSET] = 1.0;
        return true;
      case HEADING:
        if (s.hasHeading) {
          return false;
        }
        Alignment.heading(s, m.value(quantity, 0), v0);
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

  /** A local frame whose origin is not the filter's is laid so that its first position fits. */
  private void shift(FilterState s, SensedQuantity quantity, int at) {
    double[] t = s.trust;
    if (t[at + SourceTrust.HAS_OFFSET] == 0.0) {
      boolean isElsewhere = quantity == SensedQuantity.LOCAL_DOWN || s.hasPlace;
      for (int i = 0; i < model.rows; i++) {
        t[at + SourceTrust.OFFSET + i] = isElsewhere ? model.innovation[i] : 0.0;
      }
      t[at + SourceTrust.HAS_OFFSET] = 1.0;
    }
    for (int i = 0; i < model.rows; i++) {
      model.innovation[i] -= t[at + SourceTrust.OFFSET + i];
    }
  }

  /** Whether a source repeats itself while the vehicle moved on. */
  private boolean isFrozen(FilterState s, int source, SensedQuantity quantity, int at) {
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
      // Positions never repeat on the move. Speeds and angles may, for a while: the estimate must
      // have moved by more than it is unsure of.
      double limit2 =
          quantity == SensedQuantity.PLACE
              ? model.variance[i]
              : 4.0 * model.variance[i] + 16.0 * update.expected[i];
      boolean isApart =
          quantity == SensedQuantity.PLACE
              || model.innovation[i] * model.innovation[i] > limit2; // not drawn there by itself
      if (t[own + SourceTrust.RUN] >= FROZEN_RUN && isApart && moved * moved > limit2) {
        t[own + SourceTrust.IS_FROZEN] = 1.0;
      }
    }
    return t[own + SourceTrust.IS_FROZEN] != 0.0;
  }

  /** Where nothing measures the heading, a moving vehicle is taken to look where it goes. */
  private void headingOfMotion(FilterState s) {
    double vn = s.x[FilterState.V];
    double ve = s.x[FilterState.V + 1];
    double speed = Math.sqrt(vn * vn + ve * ve);
    double sigma =
        Math.sqrt(Math.max(s.variance(FilterState.VELOCITY), s.variance(FilterState.VELOCITY + 1)));
    if (s.hasHeading || speed < tuning.domain().trackSpeedMps() || sigma > 0.3 * speed) {
      s.movingMicros = s.micros;
    } else if ((s.micros - s.movingMicros) / MICROS >= TRACK_AFTER_S) {
      double of = Math.max(TRACK_SIGMA_RAD, sigma / speed);
      Alignment.heading(s, StrictMath.atan2(ve, vn), of * of);
    }
  }

  /**
   * Says at times that the vehicle does not slip: over ground, or through the fluid it flies in.
   */
  private void constrain(FilterState s) {
    boolean isDue = (s.micros - s.constraintMicros) / MICROS >= tuning.constraintS();
    if (tuning.constraintS() <= 0.0 || !isDue || !s.hasHeading) {
      return;
    }
    boolean isGround = tuning.domain() == MotionDomain.GROUND;
    boolean isInFlow = s.hasFlow && (s.micros - s.fluidMicros) / MICROS < FLUID_FRESH_S;
    if (isGround || isInFlow) {
      s.constraintMicros = s.micros;
      model.noSlip(s, tuning.sideSlipSigma(), !isGround, isGround);
      if (update.prepare(s, model, 1.0) <= gates[model.rows]) {
        update.apply(s, model);
      }
    }
  }
}
