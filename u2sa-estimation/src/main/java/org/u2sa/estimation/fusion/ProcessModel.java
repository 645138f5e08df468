package org.u2sa.estimation.fusion;

import org.u2sa.estimation.delay.InertialPath;
import org.u2sa.estimation.rotation.MotionHeading;
import org.u2sa.estimation.rotation.Quaternions;

/**
 * Predicts state and covariance (Solà 2017, section 7.2). With inertial input this is a strapdown
 * integration; without, the vehicle keeps its speed and turns at its last rate, which decays
 * (coordinated turn: the velocity turns with the vehicle), and process noise covers unmeasured
 * motion. Earth rate and transport rate (73 and, at 250 m/s, 40 µrad/s) are absorbed by the
 * gyroscope biases.
 */
final class ProcessModel {
  private static final int N = FilterState.N;
  private static final double LONGEST_STEP_S = 0.05;
  private static final double SCALE_NOISE = 1e-4; // wheel-speed scale, per √s
  private static final double FLOW_MEMORY_S = 600.0;
  private static final double RIGHTING_S = 1.5; // in which an unmeasured tilt returns to level
  private static final double TILT_FRESH_S = 1.0;

  private final FilterTuning tuning;
  private final PersistentErrors persistent;
  private final Transition f = new Transition();
  private final double[] r = new double[9];
  private final double[] a = new double[3];
  private final double[] w = new double[3];

  ProcessModel(FilterTuning tuning) {
    this.tuning = tuning;
    persistent = new PersistentErrors(tuning);
  }

  /** Predicts the state to the given time; no-op if already reached. */
  void predict(FilterState s, long micros) {
    while (s.micros < micros) {
      double leftS = (micros - s.micros) * 1e-6;
      int steps = (int) Math.ceil(leftS / LONGEST_STEP_S - 1e-9);
      long step = steps <= 1 ? micros - s.micros : (micros - s.micros) / steps;
      InertialInput.expire(s, tuning.domain());
      MotionInput.expire(s);
      advance(s, step * 1e-6);
      s.micros += step;
    }
  }

  private void advance(FilterState s, double dt) {
    double[] x = s.x;
    Quaternions.matrix(x, FilterState.Q, r);
    f.reset();
    for (int i = 0; i < 3; i++) {
      f.set(FilterState.POSITION + i, FilterState.VELOCITY + i, dt);
      double rate =
          s.isInertial ? x[FilterState.GYRO + i] - x[FilterState.BG + i] : x[FilterState.W + i];
      w[i] = s.hasTilt || i == 2 ? rate : 0.0; // without tilt, assume a level vehicle
    }
    if (s.isStrapdown) {
      accelerate(s, dt);
      MotionHeading.accelerate(s.motion, a[0], a[1], dt);
      InertialPath.advance(
          s.path,
          s.micros * 1e-6 + dt,
          dt,
          a[0] + bias(s, 0),
          a[1] + bias(s, 1),
          a[2] + bias(s, 2));
    } else {
      MotionHeading.restart(s.motion);
      InertialPath.restart(s.path);
      turnVelocity(s, dt);
      rise(s, dt);
    }
    double vn = x[FilterState.V];
    double ve = x[FilterState.V + 1];
    double vd = x[FilterState.V + 2];
    s.move(dt * (vn - 0.5 * dt * a[0]), dt * (ve - 0.5 * dt * a[1]), dt * (vd - 0.5 * dt * a[2]));
    turn(s, dt);
    right(s, dt);
    f.carry(s.p.data);
    addNoise(s, dt);
  }

  /** Accelerometer bias along north, east or down [m/s²]. */
  private double bias(FilterState s, int axis) {
    double sum = 0.0;
    for (int k = 0; k < 3; k++) {
      sum += r[3 * axis + k] * s.x[FilterState.BF + k];
    }
    return sum;
  }

  /** Integrates v̇ = R (f - b) + g; δv̇ = -[R (f - b)]× δθ - R δb (Solà 2017, eqs. 272, 283). */
  private void accelerate(FilterState s, double dt) {
    double[] x = s.x;
    double fx = x[FilterState.FORCE] - x[FilterState.BF];
    double fy = x[FilterState.FORCE + 1] - x[FilterState.BF + 1];
    double fz = x[FilterState.FORCE + 2] - x[FilterState.BF + 2];
    double half = 0.5 * dt; // forces act along the axes at mid-step
    double mx = fx + half * (w[1] * fz - w[2] * fy);
    double my = fy + half * (w[2] * fx - w[0] * fz);
    double mz = fz + half * (w[0] * fy - w[1] * fx);
    for (int i = 0; i < 3; i++) {
      a[i] = r[3 * i] * mx + r[3 * i + 1] * my + r[3 * i + 2] * mz;
      for (int k = 0; k < 3; k++) {
        f.set(FilterState.VELOCITY + i, FilterState.FORCE_BIAS + k, -dt * r[3 * i + k]);
      }
    }
    minusCross(a, dt, FilterState.VELOCITY, FilterState.ATTITUDE);
    a[2] += s.gravity();
    for (int i = 0; i < 3; i++) {
      x[FilterState.V + i] += dt * a[i];
    }
  }

  /** Integrates v̇ = ω × v about the vertical: the velocity turns with the vehicle. */
  private void turnVelocity(FilterState s, double dt) {
    double[] x = s.x;
    a[0] = 0.0;
    a[1] = 0.0;
    a[2] = 0.0;
    if (!s.hasHeading) {
      return;
    }
    double down = r[6] * w[0] + r[7] * w[1] + r[8] * w[2];
    double vn = x[FilterState.V];
    double ve = x[FilterState.V + 1];
    double sin = StrictMath.sin(down * dt);
    double cos = StrictMath.cos(down * dt);
    x[FilterState.V] = cos * vn - sin * ve;
    x[FilterState.V + 1] = sin * vn + cos * ve;
    a[0] = (x[FilterState.V] - vn) / dt;
    a[1] = (x[FilterState.V + 1] - ve) / dt;
    int north = FilterState.VELOCITY;
    int east = north + 1;
    f.set(north, north, cos);
    f.set(north, east, -sin);
    f.set(east, north, sin);
    f.set(east, east, cos);
    int source = s.isInertial ? FilterState.GYRO_BIAS : FilterState.RATE;
    double sign = s.isInertial ? -dt : dt;
    for (int k = 0; k < 3; k++) {
      if (s.hasTilt || k == 2) {
        f.set(north, source + k, sign * -ve * r[6 + k]);
        f.set(east, source + k, sign * vn * r[6 + k]);
      }
    }
  }

  /** Whether depth and specific force give the vertical motion while the velocity is not aided. */
  private boolean isRiseMeasured(FilterState s) {
    return tuning.domain() == MotionDomain.UNDERWATER
        && s.isInertial
        && !s.isStrapdown
        && s.hasTilt
        && s.hasAltitude
        && s.forceMicros == s.gyroMicros;
  }

  /** Integrates the vertical component of specific force and gravity. */
  private void rise(FilterState s, double dt) {
    if (!isRiseMeasured(s)) {
      return;
    }
    a[2] = s.gravity();
    for (int k = 0; k < 3; k++) {
      a[2] += r[6 + k] * (s.x[FilterState.FORCE + k] - s.x[FilterState.BF + k]);
      f.set(FilterState.VELOCITY + 2, FilterState.FORCE_BIAS + k, -dt * r[6 + k]);
    }
    s.x[FilterState.V + 2] += dt * a[2];
  }

  /**
   * Lets an unmeasured tilt return to level, as the vehicle's weight does, and become as uncertain
   * as the domain says (first-order Gauss–Markov process).
   */
  private void right(FilterState s, double dt) {
    double sigma = tuning.domain().tiltSigmaRad;
    boolean isMeasured = s.tiltMicros > 0 && (s.micros - s.tiltMicros) * 1e-6 < TILT_FRESH_S;
    if (sigma == 0.0 || s.isInertial || isMeasured) {
      return;
    }
    double share = dt / RIGHTING_S;
    Quaternions.turnEarth(s.x, FilterState.Q, share * r[5], -share * r[2], 0.0);
    for (int i = FilterState.ATTITUDE; i < FilterState.ATTITUDE + 2; i++) {
      f.set(i, i, 1.0 - share);
      s.p.data[i * (N + 1)] += 2.0 * share * sigma * sigma;
    }
  }

  private void turn(FilterState s, double dt) {
    double[] x = s.x;
    int source = s.isInertial ? FilterState.GYRO_BIAS : FilterState.RATE;
    double sign = s.isInertial ? -dt : dt;
    Quaternions.turnBody(x, FilterState.Q, dt * w[0], dt * w[1], dt * w[2]);
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) {
        if (s.hasTilt || i == 2 && k == 2) {
          f.set(FilterState.ATTITUDE + i, source + k, sign * r[3 * i + k]);
        }
      }
    }
    double left = 1.0 - dt / FilterTuning.TURN_MEMORY_S;
    for (int i = 0; i < 3; i++) {
      if (s.isInertial) {
        x[FilterState.W + i] = w[i];
      } else if (i < 2 || !s.hasTurnInput()) {
        x[FilterState.W + i] *= left;
        f.set(FilterState.RATE + i, FilterState.RATE + i, left);
      }
    }
    double flowLeft = 1.0 - dt / FLOW_MEMORY_S;
    x[FilterState.FLOW_NORTH] *= flowLeft;
    x[FilterState.FLOW_NORTH + 1] *= flowLeft;
    f.set(FilterState.FLOW, FilterState.FLOW, flowLeft);
    f.set(FilterState.FLOW + 1, FilterState.FLOW + 1, flowLeft);
    persistent.fade(s, f, dt);
  }

  /** Sets a block of F to -[a]× dt. */
  private void minusCross(double[] v, double dt, int row, int column) {
    f.set(row, column + 1, dt * v[2]);
    f.set(row, column + 2, -dt * v[1]);
    f.set(row + 1, column, -dt * v[2]);
    f.set(row + 1, column + 2, dt * v[0]);
    f.set(row + 2, column, dt * v[1]);
    f.set(row + 2, column + 1, -dt * v[0]);
  }

  private void addNoise(FilterState s, double dt) {
    double[] x = s.x;
    MotionDomain domain = tuning.domain();
    double felt = feltNoise(s);
    for (int i = 0; i < 3; i++) {
      double wander = i == 2 ? tuning.verticalNoise() : tuning.accelerationNoise();
      double unused = wander * wander + (i == 2 ? 0.0 : felt);
      boolean isSensed = s.isStrapdown || i == 2 && isRiseMeasured(s);
      double q = isSensed ? x[FilterState.FORCE_DENSITY] : unused;
      if (!s.hasSpeedInput()) {
        addVelocityNoise(s, i, q, dt);
      }
      if (s.hasTilt || i == 2) {
        addTurnNoise(s, i, dt);
      }
      if (s.isInertial || i == 2 && s.variance(FilterState.GYRO_BIAS + i) > 0.0) {
        add(s, FilterState.GYRO_BIAS + i, tuning.gyroBiasNoise(), dt);
      }
      if (s.isStrapdown) {
        add(s, FilterState.FORCE_BIAS + i, tuning.forceBiasNoise(), dt);
      }
    }
    if (s.hasFlow) {
      add(s, FilterState.FLOW, domain.flowNoise, dt);
      add(s, FilterState.FLOW + 1, domain.flowNoise, dt);
    }
    if (s.variance(FilterState.SCALE) > 0.0) {
      add(s, FilterState.SCALE, SCALE_NOISE, dt);
    }
    persistent.wander(s, dt);
    DelayErrors.wander(s, dt);
  }

  /**
   * Noise of the horizontal velocity per axis [m²/s³], due to an acceleration that an inertial
   * sensor measures while its direction is unknown.
   */
  private double feltNoise(FilterState s) {
    double[] x = s.x;
    if (s.isStrapdown || !s.isInertial || !s.hasTilt || s.forceMicros != s.gyroMicros) {
      return 0.0;
    }
    double sum = 0.0;
    for (int i = 0; i < 2; i++) {
      double force = 0.0;
      for (int k = 0; k < 3; k++) {
        force += r[3 * i + k] * (x[FilterState.FORCE + k] - x[FilterState.BF + k]);
      }
      sum += force * force;
    }
    return sum * FilterTuning.ACCELERATION_MEMORY_S;
  }

  private static void addVelocityNoise(FilterState s, int i, double q, double dt) {
    int v = FilterState.VELOCITY + i;
    int p = FilterState.POSITION + i;
    s.p.data[p * N + p] += q * dt * dt * dt / 3.0;
    s.p.data[p * N + v] += q * dt * dt / 2.0;
    s.p.data[v * N + p] += q * dt * dt / 2.0;
    s.p.data[v * N + v] += q * dt;
  }

  private void addTurnNoise(FilterState s, int i, double dt) {
    int angle = FilterState.ATTITUDE + i;
    int rate = FilterState.RATE + i;
    if (s.isInertial) {
      double density = s.x[FilterState.GYRO_DENSITY];
      s.p.data[angle * N + angle] += density * dt;
      s.isolate(rate, density / Math.max(dt, s.x[FilterState.INPUT_INTERVAL]));
      return;
    }
    if (i == 2 && s.hasTurnInput()) {
      return;
    }
    // A rate that decays with time constant τ and keeps σ is driven by 2 σ² / τ.
    double q = 2.0 * tuning.turnSigma() * tuning.turnSigma() / FilterTuning.TURN_MEMORY_S;
    s.p.data[angle * N + angle] += q * dt * dt * dt / 3.0;
    s.p.data[angle * N + rate] += q * dt * dt / 2.0;
    s.p.data[rate * N + angle] += q * dt * dt / 2.0;
    s.p.data[rate * N + rate] += q * dt;
  }

  private static void add(FilterState s, int i, double noise, double dt) {
    s.p.data[i * (N + 1)] += noise * noise * dt;
  }
}
