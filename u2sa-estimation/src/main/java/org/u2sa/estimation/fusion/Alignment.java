package org.u2sa.estimation.fusion;

import org.u2sa.estimation.delay.InertialPath;
import org.u2sa.estimation.rotation.MotionHeading;
import org.u2sa.estimation.rotation.Quaternions;

/**
 * Initialises or resets parts of the state that were unknown or proved wrong, with their
 * uncertainty.
 */
final class Alignment {
  private static final double MISLED_RADPS = 0.1; // step of a gyroscope's bias, 1 σ

  private Alignment() {}

  /** Initialises a state about which nothing is known yet. */
  static void start(FilterState s, long micros, FilterTuning tuning) {
    double speed = tuning.domain().speedSigmaMps;
    s.micros = micros;
    s.startedMicros = micros;
    s.isStarted = true;
    for (int i = 0; i < 3; i++) {
      s.isolate(FilterState.VELOCITY + i, square(i == 2 ? Math.min(speed, 3.0) : speed));
    }
    s.isolate(FilterState.ATTITUDE, square(tuning.domain().tiltSigmaRad));
    s.isolate(FilterState.ATTITUDE + 1, square(tuning.domain().tiltSigmaRad));
    s.isolate(FilterState.ATTITUDE + 2, square(Math.PI / Math.sqrt(3.0)));
    s.isolate(FilterState.RATE + 2, square(tuning.turnSigma()));
    wheelScale(s, tuning);
    for (int i = 0; i < 3; i++) {
      s.isolate(FilterState.SPEED_BIAS + i, square(tuning.speedBiasSigma()));
    }
    s.isolate(FilterState.LOG_YAW, square(tuning.logYawSigmaRad()));
  }

  /** Resets the wheel-speed scale to its initial uncertainty. */
  static void wheelScale(FilterState s, FilterTuning tuning) {
    s.x[FilterState.WHEEL_SCALE] = 0.0;
    s.isolate(FilterState.SCALE, square(tuning.wheelScaleSigma()));
  }

  /**
   * Lets a gyroscope's bias be learnt again: a step of it turns the attitude away from every other
   * source, which would be rejected as long as the bias counted as known.
   */
  static void gyroBias(FilterState s, int axis) {
    int at = FilterState.GYRO_BIAS + axis;
    if (s.isInertial && s.variance(at) < square(MISLED_RADPS)) {
      s.isolate(at, square(MISLED_RADPS));
    }
  }

  private static double square(double value) {
    return value * value;
  }

  static void place(FilterState s, double latitude, double longitude, double north, double east) {
    s.x[FilterState.LATITUDE] = latitude;
    s.x[FilterState.LONGITUDE] = longitude;
    s.hasPlace = true;
    s.isolate(FilterState.POSITION, north);
    s.isolate(FilterState.POSITION + 1, east);
  }

  static void altitude(FilterState s, double metres, double variance) {
    s.x[FilterState.ALTITUDE] = metres;
    s.x[FilterState.ALTITUDE_ERROR] = 0.0;
    s.hasAltitude = true;
    s.isolate(FilterState.POSITION + 2, variance);
  }

  static void local(FilterState s, double north, double east, double northVar, double eastVar) {
    s.x[FilterState.NORTH] = north;
    s.x[FilterState.NORTH + 1] = east;
    s.hasLocal = true;
    s.isolate(FilterState.POSITION, northVar);
    s.isolate(FilterState.POSITION + 1, eastVar);
  }

  static void velocity(FilterState s, int axis, double mps, double variance) {
    s.x[FilterState.V + axis] = mps;
    s.isolate(FilterState.VELOCITY + axis, variance);
  }

  /** Sets a velocity that was lost to a measured one: a position would mislead it for seconds. */
  static void velocity(FilterState s, Linearization measured, double factor) {
    for (int i = 0; i < measured.rows; i++) {
      double mps = s.x[FilterState.V + i] + measured.innovation[i];
      velocity(s, i, mps, factor * measured.variance[i]);
    }
    s.reopenedMicros = Long.MIN_VALUE / 2;
  }

  /** Rotates the nominal attitude about the vertical to the given heading [rad]. */
  static void heading(FilterState s, double psi, double variance) {
    double[] r = new double[9];
    Quaternions.matrix(s.x, FilterState.Q, r);
    double by = Math.IEEEremainder(psi - Quaternions.psi(r), 2.0 * Math.PI);
    Quaternions.turnEarth(s.x, FilterState.Q, 0.0, 0.0, by);
    MotionHeading.corrected(s.motion, by);
    InertialPath.corrected(s.path, by);
    s.hasHeading = true;
    s.isolate(FilterState.ATTITUDE + 2, variance);
  }

  /** Sets roll and pitch [rad] and keeps the heading. */
  static void tilt(FilterState s, double phi, double theta, double phiSigma, double thetaSigma) {
    double[] r = new double[9];
    Quaternions.matrix(s.x, FilterState.Q, r);
    Quaternions.fromEuler(phi, theta, Quaternions.psi(r), s.x, FilterState.Q);
    s.hasTilt = true;
    double variance = square(Math.max(phiSigma, thetaSigma)); // the north and east axes mix both
    s.isolate(FilterState.ATTITUDE, variance);
    s.isolate(FilterState.ATTITUDE + 1, variance);
    for (int i = 0; i < 2; i++) {
      s.isolate(FilterState.RATE + i, square(0.3));
    }
  }

  static void flow(FilterState s, double sigma) {
    s.hasFlow = true;
    s.isolate(FilterState.FLOW, square(sigma));
    s.isolate(FilterState.FLOW + 1, square(sigma));
  }
}
