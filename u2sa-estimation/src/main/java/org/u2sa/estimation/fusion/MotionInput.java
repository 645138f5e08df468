package org.u2sa.estimation.fusion;

import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.Quaternions;

/**
 * Uses measured forward speed and turn rate as inputs of the prediction if no inertial sensor
 * drives it (velocity motion model, Thrun, Burgard and Fox 2005, section 5.3): the newest values
 * are held until the next arrive, their errors are independent between samples and along the
 * vehicle's axes, and on the ground the vehicle moves where its wheels point, but for slip in
 * turns. Values that arrive too rarely, or are noisier than the filter's assumptions without them,
 * are fused as measurements instead.
 */
final class MotionInput {
  private static final double SHORTEST_S = 0.15; // minimum hold time of an input
  private static final double INTERVALS = 3.0;
  private static final double LONGEST_INTERVAL_S = 0.5;
  private static final double KNOWN_AFTER = 3.0; // messages until the interval is known
  private static final double UNLIKELY = 4.0; // standard deviations
  private static final double LEVEL = 0.95; // cos of the tilt up to which yaw rate is heading rate
  private static final double UNIFORM = 12.0; // inverse variance of the uniform distribution

  private static final double TURNS_RAD_PER_S = 0.1; // slower ones do not slip
  private static final double SLOW_MPS = 0.1; // slip is negligible below this speed

  private final FilterTuning tuning;
  private final SourceTrust trust;
  private final WheelSlip slip;
  private final Transition f = new Transition();
  private final double[] r = new double[9];
  private final double[] variance = new double[3];

  MotionInput(FilterTuning tuning, SourceTrust trust, WheelSlip slip) {
    this.tuning = tuning;
    this.trust = trust;
    this.slip = slip;
  }

  /** Drops inputs that were not renewed. */
  static void expire(FilterState s) {
    if (s.micros >= s.speedUntilMicros) {
      s.speedSource = FilterState.NO_SOURCE;
    }
    if (s.micros >= s.turnUntilMicros) {
      s.turnSource = FilterState.NO_SOURCE;
    }
  }

  /**
   * Uses the mean of two speed samples between them: sets it for the prediction to m and corrects
   * the displacement so far. Turn rates need no such correction: the lag at the start of a turn
   * cancels at its end.
   */
  void meet(FilterState s, Measurement m, int source) {
    boolean isNext = s.hasSpeedInput() && s.speedSource == source;
    if (!isNext || !m.has(SensedQuantity.BODY_VELOCITY, 0)) {
      return;
    }
    double scale = 1.0 + s.x[FilterState.WHEEL_SCALE];
    double half = (m.value(SensedQuantity.BODY_VELOCITY, 0) / scale - s.heldMps) / 2.0;
    double sigma = m.sigma(SensedQuantity.BODY_VELOCITY, 0);
    double usual2 = 2.0 * sigma * sigma + speedChange2(s, source);
    if (4.0 * half * half > UNLIKELY * UNLIKELY * usual2) {
      return;
    }
    Quaternions.matrix(s.x, FilterState.Q, r);
    double way = half * (s.micros - s.heldMicros) * 1e-6;
    s.move(r[0] * way, r[3] * way, r[6] * way);
    for (int i = 0; i < 3; i++) {
      s.x[FilterState.V + i] += r[3 * i] * half;
    }
  }

  private double forward(FilterState s) {
    double[] x = s.x;
    return r[0] * x[FilterState.V] + r[3] * x[FilterState.V + 1] + r[6] * x[FilterState.V + 2];
  }

  private double intervalS(FilterState s, int source) {
    return s.trust[trust.of(s, source) + SourceTrust.INTERVAL];
  }

  /** Variance of the speed change between samples. */
  private double speedChange2(FilterState s, int source) {
    return tuning.accelerationNoise() * tuning.accelerationNoise() * intervalS(s, source);
  }

  /** Variance of the turn-rate change between samples. */
  private double turnChange2(FilterState s, int source) {
    double share = Math.min(1.0, 2.0 * intervalS(s, source) / FilterTuning.TURN_MEMORY_S);
    return tuning.turnSigma() * tuning.turnSigma() * share;
  }

  private boolean isSteady(FilterState s, int source) {
    double messages = s.trust[trust.of(s, source) + SourceTrust.MESSAGES];
    double interval = intervalS(s, source);
    return messages >= KNOWN_AFTER && interval > 0.0 && interval <= LONGEST_INTERVAL_S;
  }

  /**
   * Whether a vector should drive the prediction.
   *
   * @param factor factor on its claimed variances
   */
  boolean takes(FilterState s, Measurement m, int source, SensedQuantity quantity, double factor) {
    if (!isSteady(s, source)) {
      return false;
    }
    switch (quantity) {
      case BODY_VELOCITY:
        double speed2 = factor * square(m.sigma(quantity, 0));
        boolean isGround = tuning.domain() == MotionDomain.GROUND && tuning.constraintS() > 0.0;
        boolean isKnown = isGround && s.hasHeading && !s.isStrapdown && m.has(quantity, 0);
        return isKnown
            && speed2 <= speedChange2(s, source)
            && (!s.hasSpeedInput() || s.speedSource == source);
      case EULER_RATES:
      case BODY_RATES:
        double density = factor * square(m.sigma(quantity, 2)) * intervalS(s, source);
        double unmeasured = 2.0 * square(tuning.turnSigma()) * FilterTuning.TURN_MEMORY_S;
        Quaternions.matrix(s.x, FilterState.Q, r);
        return !s.isInertial
            && m.has(quantity, 2)
            && (!s.hasTilt || r[8] > LEVEL)
            && density <= unmeasured
            && (!s.hasTurnInput() || s.turnSource == source);
      default:
        return false;
    }
  }

  private static double square(double value) {
    return value * value;
  }

  /** Adds the variance of the unmeasured change since the last sample, for the gate. */
  void expect(FilterState s, int source, SensedQuantity quantity, int rows, double[] expected) {
    boolean isSpeed = quantity == SensedQuantity.BODY_VELOCITY;
    for (int i = 0; i < rows; i++) {
      expected[i] += isSpeed ? speedChange2(s, source) : turnChange2(s, source);
    }
  }

  /** Makes a vector drive the prediction. */
  void take(
      FilterState s,
      Measurement m,
      int source,
      SensedQuantity quantity,
      Linearization model,
      double factor) {
    double heldS = Math.max(SHORTEST_S, INTERVALS * intervalS(s, source));
    long until = s.micros + (long) (heldS * 1e6);
    if (quantity == SensedQuantity.BODY_VELOCITY) {
      boolean isRenewed = s.hasSpeedInput();
      s.speedSource = source;
      s.speedUntilMicros = until;
      speed(s, m, model, factor, isRenewed);
    } else {
      boolean isRenewed = s.hasTurnInput();
      s.turnSource = source;
      s.turnUntilMicros = until;
      turn(s, m, quantity, factor, isRenewed);
    }
  }

  private void turn(
      FilterState s, Measurement m, SensedQuantity quantity, double factor, boolean isRenewed) {
    boolean isGyro = quantity == SensedQuantity.BODY_RATES;
    if (isGyro && s.variance(FilterState.GYRO_BIAS + 2) == 0.0) {
      s.isolate(FilterState.GYRO_BIAS + 2, square(tuning.gyroBiasSigma()));
    }
    double rate = m.value(quantity, 2);
    Quaternions.matrix(s.x, FilterState.Q, r);
    s.x[FilterState.W + 2] = isGyro ? rate - s.x[FilterState.BG + 2] : rate * r[8];
    double change = isRenewed ? rate - s.heldRadPerS : 0.0;
    s.heldRadPerS = rate;
    s.turnedMicros = Math.abs(rate) > TURNS_RAD_PER_S ? s.micros : s.turnedMicros;
    double sigma2 =
        factor * square(m.sigma(quantity, 2)) + change * change / 4.0; // held values lag by half
    int error = FilterState.RATE + 2;
    if (isGyro) {
      f.reset();
      f.set(error, error, 0.0);
      f.set(error, FilterState.GYRO_BIAS + 2, -1.0);
      f.carry(s.p.data);
      s.p.data[error * (FilterState.N + 1)] += sigma2;
    } else {
      s.isolate(error, sigma2);
    }
  }

  /**
   * Sets the velocity to v = R u, with δv = -[v]× δθ + R δu, where δu includes the wheel scale
   * error (Solà 2017, section 7).
   */
  private void speed(
      FilterState s, Measurement m, Linearization model, double factor, boolean isRenewed) {
    double[] x = s.x;
    Quaternions.matrix(x, FilterState.Q, r);
    double scale = 1.0 + x[FilterState.WHEEL_SCALE];
    double forward = forward(s) + model.innovation[0] / scale;
    double measured = m.value(SensedQuantity.BODY_VELOCITY, 0) / scale;
    double change = isRenewed ? measured - s.heldMps : 0.0;
    s.heldMps = measured;
    s.heldMicros = s.micros;
    double sideways = tuning.sideSlipSigma() * Math.min(1.0, SLOW_MPS + Math.abs(forward));
    for (int axis = 0; axis < 3; axis++) {
      boolean isMeasured = m.has(SensedQuantity.BODY_VELOCITY, axis);
      double claim = factor * square(m.sigma(SensedQuantity.BODY_VELOCITY, axis));
      variance[axis] = isMeasured && axis == 0 ? claim : Math.max(claim, square(sideways));
    }
    double interval = intervalS(s, s.speedSource);
    variance[0] += change * change / UNIFORM + slip.turnAlongVariance(s, m, interval);
    variance[1] += slip.turnAcrossVariance(s, m, interval);
    f.reset();
    for (int i = 0; i < 3; i++) {
      x[FilterState.V + i] = r[3 * i] * forward;
      f.set(FilterState.VELOCITY + i, FilterState.VELOCITY + i, 0.0);
      if (s.variance(FilterState.SCALE) > 0.0) {
        f.set(FilterState.VELOCITY + i, FilterState.SCALE, -r[3 * i] * forward / scale);
      }
    }
    turned(s);
    f.carry(s.p.data);
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) {
        double sum = 0.0;
        for (int axis = 0; axis < 3; axis++) {
          sum += r[3 * i + axis] * variance[axis] * r[3 * k + axis];
        }
        s.p.data[(FilterState.VELOCITY + i) * FilterState.N + FilterState.VELOCITY + k] += sum;
      }
    }
  }

  /** Sets the block of δv for δθ: -[v]×. */
  private void turned(FilterState s) {
    double vn = s.x[FilterState.V];
    double ve = s.x[FilterState.V + 1];
    double vd = s.x[FilterState.V + 2];
    int v = FilterState.VELOCITY;
    int a = FilterState.ATTITUDE;
    f.set(v, a + 2, -ve);
    f.set(v + 1, a + 2, vn);
    if (s.hasTilt) {
      f.set(v, a + 1, vd);
      f.set(v + 1, a, -vd);
      f.set(v + 2, a, ve);
      f.set(v + 2, a + 1, -vn);
    }
  }
}
