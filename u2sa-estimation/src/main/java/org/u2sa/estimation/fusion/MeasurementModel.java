package org.u2sa.estimation.fusion;

import org.ejml.data.DMatrixRMaj;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;

/**
 * Measurement model of each quantity: innovation, Jacobian with respect to the error state, and
 * claimed variance of each present component (Solà 2017, section 6.1, with global angular errors).
 */
final class MeasurementModel {
  private static final int N = FilterState.N;
  private static final double FULL_TURN = 2.0 * Math.PI;
  private static final double NEAREST_M = 0.1; // minimum range of a landmark
  private static final double STEEP = 0.02; // cos θ near gimbal lock

  /** Jacobian; only the first {@link #rows} rows are valid. */
  final DMatrixRMaj h = new DMatrixRMaj(3, N);

  final double[] innovation = new double[3];
  final double[] variance = new double[3];
  final double[] predicted = new double[3];
  int rows;

  private final LeverArm lever = new LeverArm();
  private final double[] r = new double[9];
  private final double[] v = new double[3];

  /**
   * Evaluates the model for one quantity of a measurement.
   *
   * @return false if the state cannot predict this quantity
   */
  boolean look(FilterState s, Measurement m, SensedQuantity quantity) {
    h.reshape(3, N);
    h.zero();
    rows = 0;
    Quaternions.matrix(s.x, FilterState.Q, r);
    lever.look(s, m);
    switch (quantity) {
      case PLACE:
        return s.hasPlace && place(s, m);
      case ALTITUDE:
        return s.hasAltitude && altitude(s, m);
      case LOCAL_PLACE:
        local(s, m, quantity, 0, 2);
        return s.hasLocal || s.hasPlace;
      case LOCAL_DOWN:
        local(s, m, quantity, 2, 1);
        return true;
      case VELOCITY:
        velocity(s, m);
        return true;
      case BODY_VELOCITY:
        bodyVelocity(s, m);
        return s.hasHeading && rows > 0;
      case FLUID_VELOCITY:
        fluidVelocity(s, m);
        return s.hasHeading && s.hasFlow;
      case TILT:
        return s.hasTilt && tilt(m);
      case HEADING:
        return s.hasHeading && heading(m);
      case EULER_RATES:
        return eulerRates(s, m);
      case BODY_RATES:
        bodyRates(s, m);
        return true;
      case SPECIFIC_FORCE:
        gravity(s, m);
        return s.hasTilt;
      case LANDMARK:
        return s.hasHeading && m.isWhole(quantity) && landmark(s, m);
      default:
        return false;
    }
  }

  /**
   * Evaluates the no-slip constraint: no sideways motion and, on the ground, no vertical motion.
   */
  void noSlip(FilterState s, double sigma, boolean throughFluid, boolean hasVertical) {
    h.reshape(3, N);
    h.zero();
    rows = 0;
    Quaternions.matrix(s.x, FilterState.Q, r);
    along(s, throughFluid);
    for (int axis = 1; axis <= (hasVertical ? 2 : 1); axis++) {
      vehicleRow(s, axis, throughFluid);
      row(0.0, predictedAlong(axis), sigma);
    }
  }

  private void row(double measured, double expected, double sigma) {
    predicted[rows] = expected;
    innovation[rows] = measured - expected;
    variance[rows] = sigma * sigma;
    rows++;
  }

  /** Shifts the prediction of the last row. */
  void shift(double more, double addedVariance) {
    innovation[rows - 1] -= more;
    predicted[rows - 1] += more;
    variance[rows - 1] += addedVariance;
  }

  /** Sets an element in the last row of the Jacobian. */
  void setLast(int column, double value) {
    h.data[(rows - 1) * N + column] = value;
  }

  private void set(int column, double value) {
    h.data[rows * N + column] = value;
  }

  /** Sets an element of the Jacobian. */
  void add(int row, int column, double value) {
    h.data[row * N + column] = value;
  }

  private boolean place(FilterState s, Measurement m) {
    double northRadius = s.northRadiusM();
    double axisDistance = s.axisDistanceM();
    for (int i = 0; i < 2; i++) {
      if (m.has(SensedQuantity.PLACE, i)) {
        set(FilterState.POSITION + i, 1.0);
        double apart = m.value(SensedQuantity.PLACE, i) - s.x[FilterState.LATITUDE + i];
        double metres =
            i == 0 ? apart * northRadius : Math.IEEEremainder(apart, FULL_TURN) * axisDistance;
        row(metres, 0.0, m.sigma(SensedQuantity.PLACE, i));
        predicted[rows - 1] = s.x[FilterState.NORTH + i]; // in metres, for displacement checks
        lever.position(s, this, i, 1.0);
      }
    }
    return true;
  }

  private boolean altitude(FilterState s, Measurement m) {
    set(FilterState.POSITION + 2, -1.0);
    row(
        m.value(SensedQuantity.ALTITUDE, 0),
        s.x[FilterState.ALTITUDE],
        m.sigma(SensedQuantity.ALTITUDE, 0));
    lever.position(s, this, 2, -1.0);
    return true;
  }

  private void local(FilterState s, Measurement m, SensedQuantity quantity, int first, int size) {
    for (int i = 0; i < size; i++) {
      if (m.has(quantity, i)) {
        set(FilterState.POSITION + first + i, 1.0);
        row(m.value(quantity, i), s.x[FilterState.NORTH + first + i], m.sigma(quantity, i));
        lever.position(s, this, first + i, 1.0);
      }
    }
  }

  private void velocity(FilterState s, Measurement m) {
    for (int i = 0; i < 3; i++) {
      if (m.has(SensedQuantity.VELOCITY, i)) {
        set(FilterState.VELOCITY + i, 1.0);
        row(
            m.value(SensedQuantity.VELOCITY, i),
            s.x[FilterState.V + i],
            m.sigma(SensedQuantity.VELOCITY, i));
        lever.velocity(s, this, i);
      }
    }
  }

  /** Stores the velocity over ground or through the fluid in v. */
  private void along(FilterState s, boolean throughFluid) {
    v[0] = s.x[FilterState.V] - (throughFluid ? s.x[FilterState.FLOW_NORTH] : 0.0);
    v[1] = s.x[FilterState.V + 1] - (throughFluid ? s.x[FilterState.FLOW_NORTH + 1] : 0.0);
    v[2] = s.x[FilterState.V + 2];
  }

  private double predictedAlong(int axis) {
    return r[axis] * v[0] + r[3 + axis] * v[1] + r[6 + axis] * v[2];
  }

  /** Jacobian row of Rᵀ v: Rᵀ for δv, Rᵀ [v]× for δθ, -Rᵀ for δ(wind). */
  private void vehicleRow(FilterState s, int axis, boolean throughFluid) {
    double b0 = r[axis];
    double b1 = r[3 + axis];
    double b2 = r[6 + axis];
    set(FilterState.VELOCITY, b0);
    set(FilterState.VELOCITY + 1, b1);
    set(FilterState.VELOCITY + 2, b2);
    if (s.hasTilt) {
      set(FilterState.ATTITUDE, b1 * v[2] - b2 * v[1]);
      set(FilterState.ATTITUDE + 1, b2 * v[0] - b0 * v[2]);
    }
    set(FilterState.ATTITUDE + 2, b0 * v[1] - b1 * v[0]);
    if (throughFluid) {
      set(FilterState.FLOW, -b0);
      set(FilterState.FLOW + 1, -b1);
    }
  }

  private void bodyVelocity(FilterState s, Measurement m) {
    along(s, false);
    for (int axis = 0; axis < 3; axis++) {
      if (m.has(SensedQuantity.BODY_VELOCITY, axis)) {
        vehicleRow(s, axis, false);
        row(
            m.value(SensedQuantity.BODY_VELOCITY, axis),
            predictedAlong(axis),
            m.sigma(SensedQuantity.BODY_VELOCITY, axis));
        lever.bodyVelocity(s, this, axis);
        if (axis == 0 && s.variance(FilterState.SCALE) > 0.0) {
          scale(1.0 + s.x[FilterState.WHEEL_SCALE]);
        }
      }
    }
  }

  /** Applies a scale factor to the last row's speed. */
  private void scale(double by) {
    double speed = predicted[rows - 1];
    for (int k = 0; k < N; k++) {
      h.data[(rows - 1) * N + k] *= by;
    }
    setLast(FilterState.SCALE, speed);
    shift((by - 1.0) * speed, 0.0);
  }

  private void fluidVelocity(FilterState s, Measurement m) {
    along(s, true);
    for (int axis = 0; axis < 3; axis++) {
      if (m.has(SensedQuantity.FLUID_VELOCITY, axis)) {
        vehicleRow(s, axis, true);
        row(
            m.value(SensedQuantity.FLUID_VELOCITY, axis),
            predictedAlong(axis),
            m.sigma(SensedQuantity.FLUID_VELOCITY, axis));
        lever.bodyVelocity(s, this, axis);
      }
    }
  }

  private boolean tilt(Measurement m) {
    double cos2 = r[7] * r[7] + r[8] * r[8];
    if (cos2 < STEEP * STEEP) {
      return false;
    }
    if (m.has(SensedQuantity.TILT, 0)) {
      rollRow(cos2);
      double phi = Quaternions.phi(r);
      double apart = Math.IEEEremainder(m.value(SensedQuantity.TILT, 0) - phi, FULL_TURN);
      row(phi + apart, phi, m.sigma(SensedQuantity.TILT, 0));
    }
    if (m.has(SensedQuantity.TILT, 1)) {
      pitchRow(cos2);
      row(m.value(SensedQuantity.TILT, 1), Quaternions.theta(r), m.sigma(SensedQuantity.TILT, 1));
    }
    return rows > 0;
  }

  /** Jacobian row of φ = atan2(R32, R33), whose columns change by δθ × column. */
  private void rollRow(double cos2) {
    set(FilterState.ATTITUDE, (r[8] * r[4] - r[7] * r[5]) / cos2);
    set(FilterState.ATTITUDE + 1, (-r[8] * r[1] + r[7] * r[2]) / cos2);
  }

  /** Jacobian row of θ = -asin(R31). */
  private void pitchRow(double cos2) {
    double cos = Math.sqrt(cos2);
    set(FilterState.ATTITUDE, -r[3] / cos);
    set(FilterState.ATTITUDE + 1, r[0] / cos);
  }

  /** Jacobian row of ψ = atan2(R21, R11). */
  private boolean headingRow(boolean hasTilt) {
    double cos2 = r[0] * r[0] + r[3] * r[3];
    if (cos2 < STEEP * STEEP) {
      return false;
    }
    if (hasTilt) {
      set(FilterState.ATTITUDE, -r[0] * r[6] / cos2);
      set(FilterState.ATTITUDE + 1, -r[3] * r[6] / cos2);
    }
    set(FilterState.ATTITUDE + 2, 1.0);
    return true;
  }

  private boolean heading(Measurement m) {
    if (!headingRow(true)) {
      return false;
    }
    double psi = Quaternions.psi(r);
    double apart = Math.IEEEremainder(m.value(SensedQuantity.HEADING, 0) - psi, FULL_TURN);
    row(psi + apart, psi, m.sigma(SensedQuantity.HEADING, 0));
    return true;
  }

  /** Model of Euler rates from body rates (Stevens and Lewis, 2nd ed., section 1.3). */
  private boolean eulerRates(FilterState s, Measurement m) {
    double cos = Math.sqrt(r[7] * r[7] + r[8] * r[8]);
    if (cos < STEEP) {
      return false;
    }
    double sinPhi = r[7] / cos;
    double cosPhi = r[8] / cos;
    double tan = -r[6] / cos;
    for (int i = 0; i < 3; i++) {
      if (m.has(SensedQuantity.EULER_RATES, i) && (s.hasTilt || i == 2)) {
        double ex = i == 0 ? 1.0 : 0.0;
        double ey = i == 0 ? sinPhi * tan : i == 1 ? cosPhi : sinPhi / cos;
        double ez = i == 0 ? cosPhi * tan : i == 1 ? -sinPhi : cosPhi / cos;
        int to = s.isInertial ? FilterState.GYRO_BIAS : FilterState.RATE;
        double sign = s.isInertial ? -1.0 : 1.0;
        if (s.hasTilt) {
          set(to, sign * ex);
          set(to + 1, sign * ey);
        }
        set(to + 2, sign * ez);
        double[] x = s.x;
        double rate = ex * x[FilterState.W] + ey * x[FilterState.W + 1] + ez * x[FilterState.W + 2];
        row(m.value(SensedQuantity.EULER_RATES, i), rate, m.sigma(SensedQuantity.EULER_RATES, i));
        if (s.isInertial) {
          variance[rows - 1] +=
              x[FilterState.GYRO_DENSITY] / Math.max(1e-3, x[FilterState.INPUT_INTERVAL]);
        }
      }
    }
    return rows > 0;
  }

  /**
   * Model of body rates that do not drive the prediction: fewer than three, or from a second
   * inertial sensor.
   */
  private void bodyRates(FilterState s, Measurement m) {
    for (int i = 0; i < 3; i++) {
      if (m.has(SensedQuantity.BODY_RATES, i) && (s.hasTilt || i == 2) && !s.isInertial) {
        set(FilterState.RATE + i, 1.0);
        set(FilterState.GYRO_BIAS + i, 1.0);
        row(
            m.value(SensedQuantity.BODY_RATES, i),
            s.x[FilterState.W + i] + s.x[FilterState.BG + i],
            m.sigma(SensedQuantity.BODY_RATES, i));
      }
    }
  }

  /** Model of specific force, f = Rᵀ (0, 0, -g) + b, for a vehicle that hardly accelerates. */
  private void gravity(FilterState s, Measurement m) {
    double g = ProcessModel.gravity(s);
    for (int axis = 0; axis < 3; axis++) {
      if (m.has(SensedQuantity.SPECIFIC_FORCE, axis)) {
        set(FilterState.ATTITUDE, -g * r[3 + axis]);
        set(FilterState.ATTITUDE + 1, g * r[axis]);
        set(FilterState.FORCE_BIAS + axis, 1.0);
        row(
            m.value(SensedQuantity.SPECIFIC_FORCE, axis),
            -g * r[6 + axis] + s.x[FilterState.BF + axis],
            m.sigma(SensedQuantity.SPECIFIC_FORCE, axis));
      }
    }
  }

  /**
   * Model of range and bearing to a landmark. Both are strongly nonlinear at short range, so
   * second-order terms are added to the variances (Jazwinski 1970, section 9.3).
   */
  private boolean landmark(FilterState s, Measurement m) {
    boolean isOnEarth = m.isLandmarkOnEarth();
    if (isOnEarth ? !s.hasPlace : !(s.hasLocal || s.hasPlace)) {
      return false;
    }
    double north = m.landmark(0) - s.x[isOnEarth ? FilterState.LATITUDE : FilterState.NORTH];
    double east = m.landmark(1) - s.x[isOnEarth ? FilterState.LONGITUDE : FilterState.NORTH + 1];
    if (isOnEarth) {
      north *= s.northRadiusM();
      east = Math.IEEEremainder(east, FULL_TURN) * s.axisDistanceM();
    }
    double range = Math.max(NEAREST_M, Math.sqrt(north * north + east * east));
    double range2 = range * range;
    double spread = s.variance(FilterState.POSITION) + s.variance(FilterState.POSITION + 1);
    set(FilterState.POSITION, -north / range);
    set(FilterState.POSITION + 1, -east / range);
    row(m.value(SensedQuantity.LANDMARK, 0), range, m.sigma(SensedQuantity.LANDMARK, 0));
    variance[0] += spread * spread / (2.0 * range2);
    if (!headingRow(s.hasTilt)) {
      return true; // nose points up: only the range is usable
    }
    for (int i = 0; i < 3; i++) {
      h.data[N + FilterState.ATTITUDE + i] *= -1.0;
    }
    set(FilterState.POSITION, east / range2);
    set(FilterState.POSITION + 1, -north / range2);
    double bearing = StrictMath.atan2(east, north) - Quaternions.psi(r);
    double measured = m.value(SensedQuantity.LANDMARK, 1);
    double apart = Math.IEEEremainder(measured - bearing, FULL_TURN);
    row(bearing + apart, bearing, m.sigma(SensedQuantity.LANDMARK, 1));
    variance[1] += spread * spread / (2.0 * range2 * range2);
    return true;
  }

  /** Computes the standard deviations of roll, pitch and heading of a state [rad]. */
  void attitudeSigmas(FilterState s, double[] to) {
    h.reshape(3, N);
    h.zero();
    rows = 0;
    Quaternions.matrix(s.x, FilterState.Q, r);
    double cos2 = Math.max(STEEP * STEEP, r[7] * r[7] + r[8] * r[8]);
    rollRow(cos2);
    rows = 1;
    pitchRow(cos2);
    rows = 2;
    headingRow(s.hasTilt);
    for (int i = 0; i < 3; i++) {
      to[i] = Math.sqrt(Math.max(0.0, quadratic(s, i)));
    }
  }

  /** Computes the speeds through the fluid along BODY_FRD and their standard deviations [m/s]. */
  void fluid(FilterState s, double[] speeds, double[] sigmas) {
    h.reshape(3, N);
    h.zero();
    Quaternions.matrix(s.x, FilterState.Q, r);
    along(s, true);
    for (rows = 0; rows < 3; rows++) {
      vehicleRow(s, rows, true);
      speeds[rows] = predictedAlong(rows);
    }
    for (int i = 0; i < 3; i++) {
      sigmas[i] = Math.sqrt(Math.max(0.0, quadratic(s, i)));
    }
  }

  private double quadratic(FilterState s, int row) {
    double sum = 0.0;
    for (int i = 0; i < N; i++) {
      double hi = h.data[row * N + i];
      if (hi != 0.0) {
        for (int k = 0; k < N; k++) {
          sum += hi * s.p.data[i * N + k] * h.data[row * N + k];
        }
      }
    }
    return sum;
  }
}
