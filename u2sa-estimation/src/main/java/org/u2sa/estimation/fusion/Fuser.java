package org.u2sa.estimation.fusion;

import org.u2sa.estimation.measurement.AltitudeDifference;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.RepeatedSightings;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.MotionHeading;
import org.u2sa.messages.frame.Gravity;

/**
 * Fuses one measurement into a state: predicts the state, initialises unknown quantities, and
 * updates with each vector that passes the gate and comes from a trusted source.
 */
final class Fuser {
  private static final double MICROS = 1e6;
  private static final double UNUSED_INERTIAL_SIGMA = 2.0; // m/s² mistaken for gravity
  private static final double LEVELLING_SIGMA = 1.0; // m/s² likewise, if the heading is known
  private static final double SHOWN_FROM_MPS2 = 2.0; // acceleration that a force's length shows
  private static final double TRACK_SIGMA_RAD = 0.2; // sigma of the course used as heading
  private static final double TRACK_AFTER_S = 3.0;
  private static final double FLUID_FRESH_S = 2.0;
  private static final double SPEED_FRESH_S = 2.0;
  private static final double ONLY_ALTIMETER_S = 1.0;
  private static final double STANDING_MPS = 0.1; // wheel speed
  private static final double HARD_MPS2 = 3.0; // acceleration of a vehicle that starts or brakes
  private static final double READABLE_SIGMAS = 3.0;
  private static final double TURNED_S = 2.0; // ago, at most
  private static final double TURN_STREAK = 3.0;
  private static final double TURN_DOUBT_S = 0.3;
  private static final double FIX_STREAK = 3.0; // altitudes of a receiver

  private final FilterTuning tuning;
  private final SourceTrust trust;
  private final ProcessModel process;
  private final InertialVote vote;
  private final InertialInput inertial;
  private final MotionInput motion;
  private final SourceJudge judge;
  private final SpeedDoubt doubts;
  private final RefusedScatter scatter;
  private final InertialContradiction contradiction;
  private final DepthPriority depths;
  private final WheelSlip slip;
  private final QuantityStart starts;
  private final PersistentErrors persistent;
  private final DelayErrors delays;
  private final MeasurementModel model = new MeasurementModel();
  private final Linearization linear = model.linear;
  private final KalmanUpdate update = new KalmanUpdate();
  private final double[] gates = new double[4];

  Fuser(FilterTuning tuning, SourceTrust trust, ProcessModel process) {
    this.tuning = tuning;
    this.trust = trust;
    this.process = process;
    vote = new InertialVote(tuning, trust);
    inertial = new InertialInput(tuning);
    slip = new WheelSlip(tuning);
    motion = new MotionInput(tuning, trust, slip);
    judge = new SourceJudge(tuning, trust);
    doubts = new SpeedDoubt(trust);
    scatter = new RefusedScatter(tuning);
    contradiction = new InertialContradiction(tuning, trust);
    depths = new DepthPriority(trust);
    starts = new QuantityStart(tuning);
    persistent = new PersistentErrors(tuning);
    delays = new DelayErrors(tuning);
    for (int rows = 1; rows < gates.length; rows++) {
      gates[rows] = threshold(rows, tuning.gate());
    }
  }

  /** χ² threshold for these degrees of freedom, equivalent to z sigmas (Wilson, Hilferty 1931). */
  static double threshold(int rows, double z) {
    double spread = 2.0 / (9.0 * rows);
    return rows * Math.pow(1.0 - spread + z * Math.sqrt(spread), 3.0);
  }

  /** Fuses a measurement, which must not be older than the state. */
  void fuse(FilterState s, Measurement m, int source) {
    if (!s.isStarted) {
      Alignment.start(s, m.micros(), tuning);
    }
    trust.heard(s, m, source);
    boolean isWhole = m.isWhole(SensedQuantity.BODY_RATES);
    if (isWhole) {
      vote.heard(s, m, source);
    }
    boolean drives =
        isWhole
            && inertial.isMain(s, source, m.micros())
            && !vote.isLeftOut(s, source)
            && !judge.isStuck(s, source)
            && vote.isBelieved(s, m, source, judge);
    if (drives) {
      inertial.meet(s, m, source);
      process.predict(s, m.micros());
      inertial.take(s, m, source);
      count(s, trust.of(s, source, SensedQuantity.BODY_RATES), SourceTrust.USED);
    } else {
      motion.meet(s, m, source);
      process.predict(s, m.micros());
      if (!isWhole) {
        vector(s, m, source, SensedQuantity.BODY_RATES);
      }
    }
    boolean isNew = s.trust[trust.of(s, source) + SourceTrust.RUN] == 0.0;
    if (isNew && delays.changes(s, m, source)) { // repeated values show no delay
      trust.admit(s, source);
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

  private static void count(FilterState s, int at, int what) {
    s.trust[at + what]++;
    if (what == SourceTrust.USED) {
      s.trust[at + SourceTrust.LAST_USED] = s.micros;
      s.trust[at + SourceTrust.STREAK] = 0.0;
      s.trust[at + SourceTrust.DISTRUST] *= SourceTrust.FORGIVEN;
    }
  }

  private void vector(FilterState s, Measurement m, int source, SensedQuantity quantity) {
    if (!m.has(quantity)) {
      return;
    }
    int at = trust.of(s, source, quantity);
    if (judge.leavesOutFrozen(s, source, at)) {
      return;
    }
    int slot = persistent.slot(s, m, quantity, source, at);
    if (PersistentErrors.isPosition(slot) && s.trust[at + SourceTrust.LEARNT] == 0.0) {
      SourceTrust.raise(s.trust, at, PersistentErrors.ALL_WHITE); // until the scatter is known
    }
    boolean isLog = quantity == SensedQuantity.BODY_VELOCITY && tuning.domain().isInWater();
    boolean isThroughWater =
        quantity == SensedQuantity.FLUID_VELOCITY && tuning.domain().isInWater();
    if (isLog || isThroughWater && m.has(quantity, 2)) {
      SourceTrust.suppose(s.trust, at);
    }
    int delay = delays.slot(s, quantity, source);
    int shown = DelayErrors.shownSlot(s, source);
    if (starts.begin(s, m, quantity, at, slot)) {
      delays.advance(s, quantity, shown);
      DelayErrors.share(s, delay);
      count(s, at, SourceTrust.USED);
      used(s, m, quantity);
      return;
    }
    boolean isReadable = quantity != SensedQuantity.FLUID_VELOCITY || isReadable(m);
    boolean isForward =
        quantity == SensedQuantity.BODY_VELOCITY && m.has(SensedQuantity.BODY_VELOCITY, 0);
    if (isForward) {
      HeadingSearch.speed(s, m);
      slip.alongTheWay(s, s.trust[trust.of(s, source) + SourceTrust.INTERVAL]);
    }
    if (!isReadable || !model.look(s, m, quantity) || linear.rows == 0) {
      return;
    }
    if (quantity == SensedQuantity.BODY_VELOCITY) {
      slip.widen(s, m, linear, s.trust[trust.of(s, source) + SourceTrust.INTERVAL]);
    }
    if (quantity == SensedQuantity.SPECIFIC_FORCE) {
      double own = accelerationVariance(s);
      for (int i = 0; i < linear.rows; i++) {
        linear.variance[i] += own;
      }
    }
    if (quantity == SensedQuantity.LOCAL_PLACE || quantity == SensedQuantity.LOCAL_DOWN) {
      QuantityStart.shift(s, linear, quantity, at);
    } else if (quantity == SensedQuantity.ALTITUDE) {
      compareAltitude(s, m, at);
      shiftAltitude(s, m, source, at);
    }
    if (quantity.isPlace()) {
      searchHeading(s, source);
    }
    if (quantity == SensedQuantity.VELOCITY
        && tuning.domain() == MotionDomain.AIR
        && linear.rows >= 2) {
      delays.compareHeading(s, linear, source, shown);
    }
    if (quantity == SensedQuantity.VELOCITY) {
      delays.lookAhead(s, m, linear, shown);
    } else if (quantity == SensedQuantity.ALTITUDE) {
      delays.lookDown(s, linear, shown);
    }
    boolean isLost = (s.micros - s.reopenedMicros) / MICROS < SPEED_FRESH_S;
    if (isLost && quantity == SensedQuantity.VELOCITY && m.isWhole(quantity)) {
      Alignment.velocity(s, linear, SourceTrust.factor(s, at));
      count(s, at, SourceTrust.USED);
      used(s, m, quantity);
      return;
    }
    boolean isGauge =
        tuning.domain() == MotionDomain.UNDERWATER && isOnlyAltimeter(s, m, source, quantity);
    if (isGauge) {
      depths.wander(s, source);
    }
    PersistentErrors.look(s, m, quantity, linear, slot);
    delays.look(s, m, quantity, linear, delay);
    double factor = SourceTrust.factor(s, at);
    double nis = update.prepare(s, linear, factor);
    boolean isInput = motion.takes(s, m, source, quantity, factor);
    if (isInput) {
      motion.expect(s, source, quantity, linear.rows, update.expected);
      nis = update.weigh(linear, factor);
    }
    judge.lookWhetherFrozen(s, linear, update.expected, source, quantity, at);
    if (judge.leavesOutFrozen(s, source, at)) {
      return;
    }
    trust.learn(s, at, linear, update.expected, isLog);
    SourceTrust.notedNis(s, at, nis);
    double runs =
        quantity == SensedQuantity.HEADING
            ? judge.repeatedHeading(s, linear, source, at, factor)
            : runs(s, source, quantity, isGauge);
    if (runs > 1.0) {
      nis = update.weigh(linear, factor * runs);
    }
    double wanderRate = persistent.wanderRate(s, slot);
    if (SpeedDoubt.isOfSpeed(quantity) && doubts.holds(s, linear, source, at)
        || quantity.isPlace() && doubts.isLeftOut(s, m, linear, source, at, wanderRate)) {
      return;
    }
    boolean isHeading = quantity == SensedQuantity.HEADING;
    if (isHeading && nis > gates[linear.rows] && judge.isHeld(s, source)) {
      s.trust[at + SourceTrust.GATED]++; // no evidence against the estimate
      return;
    }
    if (quantity == SensedQuantity.ALTITUDE && hasOffset(s, m, source, at)) {
      QuantityStart.learnOffset(s, linear, at);
    }
    if (quantity == SensedQuantity.ALTITUDE && isPressureWrong(s, m, source, at)) {
      SourceJudge.rejectWrong(s, at);
      return;
    }
    boolean isUnseenTurn =
        isHeading
            && nis > gates[linear.rows]
            && !judge.isCorroboratedSinceRejected(s, source, quantity, at)
            && scatter.showsTurn(s, linear, at);
    if (isUnseenTurn) {
      update.prepare(s, linear, factor);
    } else if (nis > gates[linear.rows]) {
      boolean mustGiveWay = judge.gated(s, linear, source, quantity, at);
      if (isHeading && isTurnDoubted(s, at)) {
        mustGiveWay = true;
        s.slipsInTurns = true;
      }
      mustGiveWay |= quantity == SensedQuantity.ALTITUDE && isPressureDoubted(s, m, at);
      if (contradiction.isOfHeading(s, quantity, at)) {
        contradiction.turnHeading(s);
        return;
      }
      if (contradiction.isOfGyroscopes(s)) {
        contradiction.reopenGyroscopes(s);
        return;
      }
      if (InertialContradiction.isOfMotion(quantity) && contradiction.isShown(s)) {
        contradiction.reopen(s);
        contradiction.admit(s);
        return;
      }
      if (isGauge && depths.isGiven(s, linear, source, at)) {
        return;
      }
      boolean isAlone = !judge.isCorroborated(s, source, quantity);
      boolean isJump = false;
      boolean isPosition = quantity.isPlace();
      if (isAlone && (isPosition || SpeedDoubt.isOfSpeed(quantity))) {
        supposeAcceleration(s, source);
      }
      if (isPosition && scatter.isBeyondClaim(s, linear, at, isAlone)) {
        return;
      }
      if (isPosition && isAlone && doubts.isRaised(s, m, linear, source, at, wanderRate)) {
        mustGiveWay = true;
      } else if (mustGiveWay) {
        QuantityStart.doubt(s, quantity, at);
        isJump = PersistentErrors.isPosition(slot) && s.hasHeading && s.hasSpeedInput();
      }
      if (mustGiveWay && isJump) {
        PersistentErrors.jumped(s, linear, slot, at);
      } else if (mustGiveWay) {
        if (s.isStrapdown && InertialContradiction.isOfMotion(quantity)) {
          contradiction.reopen(s);
        }
        starts.reset(s, m, quantity, at, slot);
        delays.advance(s, quantity, shown);
        DelayErrors.share(s, delay);
      }
      return;
    }
    if (isLog) {
      SourceTrust.countOutliers(s.trust, at);
    }
    if (SourceJudge.passes(s, at)) {
      if (isInput) {
        motion.take(s, m, source, quantity, linear, factor);
        count(s, at, SourceTrust.USED);
        used(s, m, quantity);
      } else {
        correct(s, m, source, quantity, at, slot, runs);
      }
    }
  }

  /** Whether an altitude is that of a barometer or depth gauge. */
  private static boolean isPressure(Measurement m) {
    return !m.has(SensedQuantity.PLACE) && !m.has(SensedQuantity.LOCAL_PLACE);
  }

  /**
   * Whether other altitudes show the offset of a barometer, or of a depth gauge that has been
   * rejected.
   */
  private boolean hasOffset(FilterState s, Measurement m, int source, int at) {
    boolean isDepth = tuning.domain() == MotionDomain.UNDERWATER;
    return isPressure(m)
        && !trust.isShifted(s, source, SensedQuantity.ALTITUDE)
        && (!isDepth || s.trust[at + SourceTrust.IS_BIASED] != 0.0)
        && judge.isSupported(s, source, SensedQuantity.ALTITUDE);
  }

  /**
   * Whether a receiver contradicts an altitude that nothing but pressure has shown: the weather
   * shifts that by tens of metres, for hours. Depth is measured from the surface.
   */
  private boolean isPressureDoubted(FilterState s, Measurement m, int at) {
    return tuning.domain() != MotionDomain.UNDERWATER
        && !isPressure(m)
        && s.trust[at + SourceTrust.STREAK] >= FIX_STREAK
        && !trust.hasReceiverAltitude(s);
  }

  private void compareAltitude(FilterState s, Measurement m, int at) {
    if (isPressure(m)) {
      int of = at + SourceTrust.DIFFERENCE;
      AltitudeDifference.barometer(s.trust, of, linear.innovation[0], s.micros);
    } else {
      trust.compareBarometers(s, linear);
    }
  }

  /**
   * Whether receivers have shown over some time that a barometer is off by more than it claims. The
   * estimate may be between them, within the gate of both.
   */
  private boolean isPressureWrong(FilterState s, Measurement m, int source, int at) {
    return tuning.domain() != MotionDomain.UNDERWATER
        && isPressure(m)
        && !trust.isShifted(s, source, SensedQuantity.ALTITUDE)
        && judge.isCorroborated(s, source, SensedQuantity.ALTITUDE)
        && AltitudeDifference.isContradicted(
            s.trust,
            at + SourceTrust.DIFFERENCE,
            linear.variance[0],
            tuning.positionCorrelationS());
  }

  /**
   * Subtracts the known offset of an altitude that is alone. Once another one returns, the
   * covariance takes up what it lacks of the offset's uncertainty, so that it is not rejected.
   */
  private void shiftAltitude(FilterState s, Measurement m, int source, int at) {
    if (isPressure(m)) {
      boolean isAlone = !judge.isCorroborated(s, source, SensedQuantity.ALTITUDE);
      QuantityStart.shiftKnown(s, linear, at, isAlone);
    }
    if (s.trust[at + SourceTrust.HAS_OFFSET] == 0.0 && trust.isAnyShifted(s)) {
      s.p.data[(FilterState.POSITION + 2) * (FilterState.N + 1)] += s.x[FilterState.ALTITUDE_ERROR];
      s.x[FilterState.ALTITUDE_ERROR] = 0.0;
    }
  }

  /**
   * Whether headings contradict a turn that only wheels measure: wheels slip in a turn on the spot
   * long before a compass errs by that much.
   */
  private static boolean isTurnDoubted(FilterState s, int at) {
    double since = (s.micros - s.trust[at + SourceTrust.STREAK_SINCE]) / MICROS;
    return s.hasTurnInput()
        && (s.micros - s.turnedMicros) / MICROS < TURNED_S
        && s.trust[at + SourceTrust.STREAK] >= TURN_STREAK
        && since >= TURN_DOUBT_S;
  }

  /**
   * If only the motion model contradicts the only source of velocity, increases the velocity's
   * uncertainty by that of hard acceleration since the last message.
   */
  private void supposeAcceleration(FilterState s, int source) {
    if (s.isStrapdown || s.hasSpeedInput()) {
      return; // acceleration or speed are measured
    }
    double mps = HARD_MPS2 * s.trust[trust.of(s, source) + SourceTrust.INTERVAL];
    for (int i = 0; i < 2; i++) {
      s.p.data[(FilterState.VELOCITY + i) * (FilterState.N + 1)] += mps * mps;
    }
  }

  /** Searches for an unmeasured heading from positions and wheel speeds. */
  private void searchHeading(FilterState s, int source) {
    if (!s.hasHeading && linear.rows == 2) {
      double north = linear.predicted[0] + linear.innovation[0];
      double east = linear.predicted[1] + linear.innovation[1];
      double variance = Math.max(linear.variance[0], linear.variance[1]);
      HeadingSearch.position(s, source, north, east, variance, tuning.positionCorrelationS());
    }
  }

  /**
   * Whether an airspeed is usable. In slow air a pitot tube reads about zero, whatever the air's
   * direction, so near its noise floor it carries no information about the wind.
   */
  private boolean isReadable(Measurement m) {
    return tuning.domain() != MotionDomain.AIR
        || !m.has(SensedQuantity.FLUID_VELOCITY, 0)
        || m.value(SensedQuantity.FLUID_VELOCITY, 0)
            > READABLE_SIGMAS * m.sigma(SensedQuantity.FLUID_VELOCITY, 0);
  }

  /** Factor on the variance of a log or depth gauge under water that repeats its values. */
  private double runs(FilterState s, int source, SensedQuantity quantity, boolean isGauge) {
    boolean isLog =
        quantity == SensedQuantity.BODY_VELOCITY || quantity == SensedQuantity.FLUID_VELOCITY;
    boolean isUnderWater = tuning.domain() == MotionDomain.UNDERWATER;
    return isUnderWater && (isLog || isGauge) ? depths.repeats(s, source, isGauge) : 1.0;
  }

  private void correct(
      FilterState s,
      Measurement m,
      int source,
      SensedQuantity quantity,
      int at,
      int slot,
      double runs) {
    boolean persists =
        quantity == SensedQuantity.PLACE && slot == PersistentErrors.NONE
            || quantity == SensedQuantity.ALTITUDE
            || quantity == SensedQuantity.LOCAL_PLACE;
    if (persists && tuning.positionCorrelationS() > 0.0) {
      double interval = s.trust[trust.of(s, source) + SourceTrust.INTERVAL];
      double repeats = repeats(correlationS(s, m, source, quantity), interval);
      update.weigh(linear, SourceTrust.factor(s, at) * runs * repeats);
    }
    if (quantity == SensedQuantity.LANDMARK) {
      update.weigh(linear, SourceTrust.factor(s, at) * RepeatedSightings.factor(s.sightings, m));
    }
    update.apply(s, linear);
    if (quantity == SensedQuantity.ALTITUDE || quantity == SensedQuantity.LOCAL_DOWN) {
      boolean isShifted = trust.isShifted(s, source, quantity);
      boolean isPersistent = !isShifted && (isPressure(m) || tuning.positionCorrelationS() > 0.0);
      double sigma = m.sigma(quantity, 0);
      if (!isShifted) {
        trust.endShifts(s);
      }
      trust.claim(s, at, isPersistent ? sigma * sigma : 0.0, tuning.resetAfterS() * MICROS);
    }
    count(s, at, SourceTrust.USED);
    used(s, m, quantity);
  }

  /**
   * Variance of the vehicle's own acceleration in a force that serves for levelling [m²/s⁴]. Once
   * the heading is known, acceleration lasts only as far as it makes the force longer than gravity:
   * otherwise levelling would be too slow for a board that turns.
   */
  private static double accelerationVariance(FilterState s) {
    double repeats = repeats(FilterTuning.ACCELERATION_MEMORY_S, s.x[FilterState.INPUT_INTERVAL]);
    if (!s.hasHeading) {
      return UNUSED_INERTIAL_SIGMA * UNUSED_INERTIAL_SIGMA * repeats;
    }
    double square = -Gravity.STANDARD_MPS2 * Gravity.STANDARD_MPS2;
    for (int i = 0; i < 3; i++) {
      double force = s.x[FilterState.FORCE + i] - s.x[FilterState.BF + i];
      square += force * force;
    }
    double shown = Math.max(0.0, square - SHOWN_FROM_MPS2 * SHOWN_FROM_MPS2);
    return LEVELLING_SIGMA * LEVELLING_SIGMA + shown * repeats;
  }

  /**
   * Factor on the variance of errors with a correlation time τ: they carry as much information as
   * independent ones every 2 τ.
   */
  private static double repeats(double correlationS, double intervalS) {
    return 1.0 + 2.0 * correlationS / Math.max(1e-3, intervalS);
  }

  /**
   * Correlation time of a position or altitude error [s]. The weather error of an aircraft's only
   * altimeter lasts for hours, but without following it an inertial altitude drifts away within
   * seconds.
   */
  private double correlationS(FilterState s, Measurement m, int source, SensedQuantity quantity) {
    return isOnlyAltimeter(s, m, source, quantity)
        ? Math.min(ONLY_ALTIMETER_S, tuning.positionCorrelationS())
        : tuning.positionCorrelationS();
  }

  private boolean isOnlyAltimeter(
      FilterState s, Measurement m, int source, SensedQuantity quantity) {
    return quantity == SensedQuantity.ALTITUDE
        && (tuning.domain() == MotionDomain.AIR || tuning.domain() == MotionDomain.UNDERWATER)
        && !m.has(SensedQuantity.PLACE)
        && !judge.isCorroborated(s, source, quantity);
  }

  private static void used(FilterState s, Measurement m, SensedQuantity quantity) {
    long now = Math.max(1L, s.micros); // 0 means never, but simulated time begins there
    boolean isAlongTheVehicle =
        quantity == SensedQuantity.BODY_VELOCITY || quantity == SensedQuantity.FLUID_VELOCITY;
    if (isAlongTheVehicle && m.has(quantity, 1)) {
      s.acrossMicros = now;
    }
    switch (quantity) {
      case PLACE:
      case LOCAL_PLACE:
      case LANDMARK:
        s.positionMicros = now;
        break;
      case VELOCITY:
      case BODY_VELOCITY:
        s.velocityMicros = now;
        break;
      case HEADING:
        s.headingMicros = now;
        MotionHeading.restored(s.motion);
        break;
      case TILT:
        s.tiltMicros = now;
        break;
      case FLUID_VELOCITY:
        s.fluidMicros = now;
        break;
      default:
        break;
    }
  }

  /**
   * Uses the course of a moving vehicle as its heading if no sensor measures the heading. If its
   * velocity follows from positions only and the wheels turn, {@link HeadingSearch} is more
   * accurate.
   */
  private void headingOfMotion(FilterState s) {
    double vn = s.x[FilterState.V];
    double ve = s.x[FilterState.V + 1];
    double speed = Math.sqrt(vn * vn + ve * ve);
    double sigma =
        Math.sqrt(Math.max(s.variance(FilterState.VELOCITY), s.variance(FilterState.VELOCITY + 1)));
    boolean isMeasured = (s.micros - s.velocityMicros) / MICROS < SPEED_FRESH_S;
    boolean isSearched = !isMeasured && Math.abs(HeadingSearch.forwardMps(s)) > STANDING_MPS;
    boolean isSlow = speed < tuning.domain().trackSpeedMps;
    if (s.hasHeading || isSearched || isSlow || sigma > 0.3 * speed) {
      s.movingMicros = s.micros;
    } else if ((s.micros - s.movingMicros) / MICROS >= TRACK_AFTER_S) {
      double of = Math.max(TRACK_SIGMA_RAD, sigma / speed);
      boolean isInReverse = HeadingSearch.forwardMps(s) < 0.0;
      Alignment.heading(s, StrictMath.atan2(ve, vn) + (isInReverse ? Math.PI : 0.0), of * of);
    }
  }

  /** Periodically applies the no-sideslip constraint, over ground or through the fluid. */
  private void constrain(FilterState s) {
    boolean isDue = (s.micros - s.constraintMicros) / MICROS >= tuning.constraintS();
    if (tuning.constraintS() <= 0.0 || !isDue || !s.hasHeading || s.hasSpeedInput()) {
      return;
    }
    boolean isGround = tuning.domain() == MotionDomain.GROUND;
    boolean isDriftMeasured = (s.micros - s.acrossMicros) / MICROS < FLUID_FRESH_S;
    boolean isInFlow =
        s.hasFlow && !isDriftMeasured && (s.micros - s.fluidMicros) / MICROS < FLUID_FRESH_S;
    // Without a speed source, the constraint with an uncertain heading would act as a speed
    // measurement.
    if (isGround && InertialInput.isAided(s, SPEED_FRESH_S) || isInFlow) {
      s.constraintMicros = s.micros;
      model.noSlip(s, tuning.sideSlipSigma(), !isGround, isGround);
      linear.variance[0] += slip.acrossVariance(s, tuning.constraintS());
      if (update.prepare(s, linear, 1.0) <= gates[linear.rows]) {
        update.apply(s, linear);
        s.slidingMicros = 0;
      } else if (s.slidingMicros == 0) {
        s.slidingMicros = s.micros;
      }
    }
  }
}
