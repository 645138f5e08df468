package org.u2sa.estimation.fusion;

import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;

/**
 * Uses the newest angular rates and specific force of one inertial sensor to drive the prediction
 * while they are fresh, and initialises the tilt that the specific force requires.
 */
final class InertialInput {
  private static final double SHORTEST_SAMPLE_S = 1e-3;
  private static final double SHORTEST_S = 0.15; // minimum hold time of an input
  private static final double LONGEST_S = 0.6;
  private static final double INTERVALS = 3.0;
  private static final double MEAN_SHARE = 0.05;
  private static final double TYPICAL_INTERVAL_S = 0.02;
  private static final int SAMPLES_TO_LEVEL = 20;
  private static final double LEVEL_SIGMA_RAD = 0.06; // error if 0.6 m/s² is taken for gravity
  private static final double STEADY = 0.15; // relative deviation of |f| from gravity
  static final double UNAIDED_S = 5.0; // unaided dead reckoning is useless after this

  private final FilterTuning tuning;
  private final double[] held = new double[6];
  private final double[] rate = new double[3];
  private final double[] change = new double[3];

  InertialInput(FilterTuning tuning) {
    this.tuning = tuning;
  }

  /** Drops an input that was not renewed and falls back to the next prediction mode. */
  static void expire(FilterState s, MotionDomain domain) {
    double limitS =
        Math.min(LONGEST_S, Math.max(SHORTEST_S, INTERVALS * s.x[FilterState.INPUT_INTERVAL]));
    if (s.isInertial && (s.micros - s.gyroMicros) * 1e-6 > limitS) {
      s.isInertial = false;
      s.isStrapdown = false;
    }
    if (s.isStrapdown && (s.micros - s.forceMicros) * 1e-6 > limitS) {
      s.isStrapdown = false;
    }
    if (s.isStrapdown && !isIntegrable(s, domain)) {
      s.isStrapdown = false;
    }
  }

  /**
   * Whether the velocity may follow the specific force. In the air without a position receiver, it
   * may only while the tilt is measured: a multirotor that controls a frozen velocity would tilt
   * ever further, and its specific force does not reveal the tilt.
   */
  private static boolean isIntegrable(FilterState s, MotionDomain domain) {
    boolean isTiltMeasured = s.tiltMicros > 0 && (s.micros - s.tiltMicros) * 1e-6 <= UNAIDED_S;
    return isAided(s, UNAIDED_S)
        || domain == MotionDomain.AIR
            && isTiltMeasured
            && Math.max(s.positionMicros, s.velocityMicros) > 0;
  }

  /** Whether any source measured position or velocity within the given time [s]. */
  static boolean isAided(FilterState s, double lastS) {
    long aided = Math.max(s.positionMicros, s.velocityMicros);
    return aided > 0 && (s.micros - aided) * 1e-6 <= lastS;
  }

  /** Whether this source drives the prediction or may start to. */
  boolean isMain(FilterState s, int source, long micros) {
    return s.gyroSource < 0
        || s.gyroSource == source
        || !s.isInertial
        || (micros - s.gyroMicros) * 1e-6 > LONGEST_S;
  }

  /** Uses the mean of the previous input and this one for the prediction to m. */
  void meet(FilterState s, Measurement m, int source) {
    boolean hasForce = m.isWhole(SensedQuantity.SPECIFIC_FORCE);
    boolean continues = s.isInertial && s.gyroSource == source;
    double[] x = s.x;
    double seconds = Math.max(SHORTEST_SAMPLE_S, (m.micros() - s.gyroMicros) * 1e-6);
    double gyroJump = 0.0;
    double forceJump = 0.0;
    for (int i = 0; i < 3; i++) {
      held[i] = m.value(SensedQuantity.BODY_RATES, i);
      held[3 + i] = m.value(SensedQuantity.SPECIFIC_FORCE, i);
      rate[i] = held[i] - x[FilterState.BG + i];
      change[i] = continues ? (held[i] - x[FilterState.GYRO + i]) / seconds : 0.0;
    }
    LeverArm.release(m, rate, change, held, 3);
    for (int i = 0; i < 3; i++) {
      if (continues) {
        gyroJump += square(held[i] - x[FilterState.GYRO + i]) / 3.0;
        x[FilterState.GYRO + i] = 0.5 * (x[FilterState.GYRO + i] + held[i]);
        if (hasForce) {
          forceJump += square(held[3 + i] - x[FilterState.FORCE + i]) / 3.0;
          x[FilterState.FORCE + i] = 0.5 * (x[FilterState.FORCE + i] + held[3 + i]);
        }
      }
    }
    interval(s, m.micros(), continues);
    density(s, m, continues ? gyroJump : 0.0, continues && hasForce ? forceJump : 0.0);
  }

  /** Makes the input of the last {@link #meet} call drive the prediction from m on. */
  void take(FilterState s, Measurement m, int source) {
    double[] x = s.x;
    System.arraycopy(held, 0, x, FilterState.GYRO, 3);
    if (s.gyroSource != source && s.gyroSource != FilterState.RESUMED) {
      begin(s); // a different sensor has different biases
    }
    s.isInertial = true;
    s.gyroSource = source;
    s.gyroMicros = m.micros();
    for (int i = 0; i < 3; i++) {
      x[FilterState.W + i] = x[FilterState.GYRO + i] - x[FilterState.BG + i];
    }
    if (m.isWhole(SensedQuantity.SPECIFIC_FORCE)) {
      System.arraycopy(held, 3, x, FilterState.FORCE, 3);
      s.forceMicros = m.micros();
      level(s);
      s.isStrapdown = s.hasTilt && s.hasHeading && isIntegrable(s, tuning.domain());
    }
  }

  private static double square(double value) {
    return value * value;
  }

  private static void interval(FilterState s, long micros, boolean continues) {
    double seconds = (micros - s.gyroMicros) * 1e-6;
    double[] x = s.x;
    if (!continues || seconds <= 0.0) {
      x[FilterState.INPUT_INTERVAL] =
          x[FilterState.INPUT_INTERVAL] > 0.0 ? x[FilterState.INPUT_INTERVAL] : TYPICAL_INTERVAL_S;
    } else {
      x[FilterState.INPUT_INTERVAL] += MEAN_SHARE * (seconds - x[FilterState.INPUT_INTERVAL]);
    }
  }

  /**
   * Sets the noise densities: a sample's noise lasts for its interval, and the change between
   * samples bounds how far the motion between them differs from their mean (uniform distribution:
   * variance 1/12).
   */
  private static void density(FilterState s, Measurement m, double gyroJump, double forceJump) {
    double[] x = s.x;
    double interval = x[FilterState.INPUT_INTERVAL];
    double gyro = square(m.sigma(SensedQuantity.BODY_RATES, 0));
    double force = square(m.sigma(SensedQuantity.SPECIFIC_FORCE, 0));
    x[FilterState.GYRO_DENSITY] = (gyro + Math.max(0.0, gyroJump - 2.0 * gyro) / 12.0) * interval;
    x[FilterState.FORCE_DENSITY] =
        (force + Math.max(0.0, forceJump - 2.0 * force) / 12.0) * interval;
  }

  private void begin(FilterState s) {
    for (int i = 0; i < 3; i++) {
      s.x[FilterState.BG + i] = 0.0;
      s.x[FilterState.BF + i] = 0.0;
      s.isolate(FilterState.GYRO_BIAS + i, square(tuning.gyroBiasSigma()));
      s.isolate(FilterState.FORCE_BIAS + i, square(tuning.forceBiasSigma()));
    }
  }

  /**
   * Initialises roll and pitch from the direction of specific force, which is that of gravity while
   * its magnitude is close to g.
   */
  private static void level(FilterState s) {
    if (s.hasTilt) {
      return;
    }
    double[] x = s.x;
    double size =
        Math.sqrt(
            square(x[FilterState.FORCE])
                + square(x[FilterState.FORCE + 1])
                + square(x[FilterState.FORCE + 2]));
    double g = s.gravity();
    if (Math.abs(size - g) > STEADY * g) {
      return;
    }
    for (int i = 0; i < 3; i++) {
      x[FilterState.LEVELLING + i] += x[FilterState.FORCE + i];
    }
    x[FilterState.LEVELLED] += 1.0;
    if (x[FilterState.LEVELLED] >= SAMPLES_TO_LEVEL) {
      double fx = x[FilterState.LEVELLING];
      double fy = x[FilterState.LEVELLING + 1];
      double fz = x[FilterState.LEVELLING + 2];
      double phi = StrictMath.atan2(-fy, -fz);
      double theta = StrictMath.atan2(fx, Math.sqrt(fy * fy + fz * fz));
      Alignment.tilt(s, phi, theta, LEVEL_SIGMA_RAD, LEVEL_SIGMA_RAD);
    }
  }
}
