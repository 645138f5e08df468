package org.u2sa.estimation.fusion;

import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.SensedQuantity;
import org.u2sa.estimation.rotation.Quaternions;

/**
 * Measurement model of each quantity: innovation, Jacobian with respect to the error state, and
 * claimed variance of each present component (Solà 2017, section 6.1, with global angular errors).
 */
final class MeasurementModel {
  private static final double FULL_TURN = 2.0 * Math.PI;
  private static final double NEAREST_M = 0.1; // minimum range of a landmark
  private static final double STEEP = 0.02; // cos θ near gimbal lock

  /** The vector that was evaluated last. */
  final Linearization linear = new Linearization();

  private final LeverArm lever = new LeverArm();
  private final double[] r = new double[9];
  private final double[] v = new double[3];

  /**
   * Evaluates the model for one quantity of a measurement.
   *
   * @return false if the state cannot predict this quantity
   */
  boolean look(FilterState s, Measurement m, SensedQuantity quantity) {
    linear.clear();
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
        vehicleVelocity(s, m, quantity, false);
        return s.hasHeading && linear.rows > 0;
      case FLUID_VELOCITY:
        vehicleVelocity(s, m, quantity, true);
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

  /** Evaluates the no-slip constraint: no sideways and, on the ground, no vertical motion. */
  void noSlip(FilterState s, double sigma, boolean throughFluid, boolean hasVertical) {
    linear.clear();
    Quaternions.matrix(s.x, FilterState.Q, r);
    along(s, throughFluid);
    for (int axis = 1; axis <= (hasVertical ? 2 : 1); axis++) {
      vehicleRow(s, axis, throughFluid);
      linear.row(0.0, predictedAlong(axis), sigma);
    }
  }

  private boolean place(FilterState s, Measurement m) {
    double northRadius = s.northRadiusM();
    double axisDistance = s.axisDistanceM();
    for (int i = 0; i < 2; i++) {
      if (m.has(SensedQuantity.PLACE, i)) {
        linear.set(FilterState.POSITION + i, 1.0);
        double apart = m.value(SensedQuantity.PLACE, i) - s.x[FilterState.LATITUDE + i];
        double metres =
            i == 0 ? apart * northRadius : Math.IEEEremainder(apart, FULL_TURN) * axisDistance;
        linear.row(metres, 0.0, m.sigma(SensedQuantity.PLACE, i));
        linear.predicted[linear.rows - 1] = s.x[FilterState.NORTH + i]; // for displacement checks
        lever.position(linear, i, 1.0);
      }
    }
    return true;
  }

  private boolean altitude(FilterState s, Measurement m) {
    linear.set(FilterState.POSITION + 2, -1.0);
    linear.row(
        m.value(SensedQuantity.ALTITUDE, 0),
        s.x[FilterState.ALTITUDE],
        m.sigma(SensedQuantity.ALTITUDE, 0));
    lever.position(linear, 2, -1.0);
    return true;
  }

  private void local(FilterState s, Measurement m, SensedQuantity quantity, int first, int size) {
    for (int i = 0; i < size; i++) {
      if (m.has(quantity, i)) {
        linear.set(FilterState.POSITION + first + i, 1.0);
        linear.row(m.value(quantity, i), s.x[FilterState.NORTH + first + i], m.sigma(quantity, i));
        lever.position(linear, first + i, 1.0);
      }
    }
  }

  private void velocity(FilterState s, Measurement m) {
    for (int i = 0; i < 3; i++) {
      if (m.has(SensedQuantity.VELOCITY, i)) {
        linear.set(FilterState.VELOCITY + i, 1.0);
        linear.row(
            m.value(SensedQuantity.VELOCITY, i),
            s.x[FilterState.V + i],
            m.sigma(SensedQuantity.VELOCITY, i));
        lever.velocity(s, linear, i);
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
    linear.set(FilterState.VELOCITY, b0);
    linear.set(FilterState.VELOCITY + 1, b1);
    linear.set(FilterState.VELOCITY + 2, b2);
    linear.set(FilterState.ATTITUDE, b1 * v[2] - b2 * v[1]);
    linear.set(FilterState.ATTITUDE + 1, b2 * v[0] - b0 * v[2]);
    linear.set(FilterState.ATTITUDE + 2, b0 * v[1] - b1 * v[0]);
    if (throughFluid) {
      linear.set(FilterState.FLOW, -b0);
      linear.set(FilterState.FLOW + 1, -b1);
    }
  }

  /** Turns the vehicle's axes in r to those of a log mounted at an angle, clockwise [rad]. */
  private void turnLog(double rad) {
    double cos = StrictMath.cos(rad);
    double sin = StrictMath.sin(rad);
    for (int i = 0; i < 9; i += 3) {
      double forward = r[i];
      r[i] = cos * forward + sin * r[i + 1];
      r[i + 1] = cos * r[i + 1] - sin * forward;
    }
  }

  private void vehicleVelocity(
      FilterState s, Measurement m, SensedQuantity quantity, boolean throughFluid) {
    along(s, throughFluid);
    boolean isLog = !throughFluid && s.variance(FilterState.LOG_YAW) > 0.0;
    if (isLog) {
      turnLog(s.x[FilterState.LOG_TURN]);
    }
    for (int axis = 0; axis < 3; axis++) {
      if (m.has(quantity, axis)) {
        vehicleRow(s, axis, throughFluid);
        linear.row(m.value(quantity, axis), predictedAlong(axis), m.sigma(quantity, axis));
        lever.bodyVelocity(s, linear, axis);
        if (isLog && axis < 2) {
          linear.setLast(FilterState.LOG_YAW, axis == 0 ? predictedAlong(1) : -predictedAlong(0));
        }
        boolean isScaled = !throughFluid && (axis == 0 || isLog && axis == 1);
        if (isScaled && s.variance(FilterState.SCALE) > 0.0) {
          linear.scale(1.0 + s.x[FilterState.WHEEL_SCALE], FilterState.SCALE);
        }
        // horizontally, an error through the fluid is indistinguishable from its flow
        boolean canErr = !throughFluid || axis == 2;
        if (canErr && s.variance(FilterState.SPEED_BIAS + axis) > 0.0) {
          linear.setLast(FilterState.SPEED_BIAS + axis, 1.0);
          linear.shift(s.x[FilterState.SPEED_ERROR + axis], 0.0);
        }
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
      linear.row(phi + apart, phi, m.sigma(SensedQuantity.TILT, 0));
    }
    if (m.has(SensedQuantity.TILT, 1)) {
      pitchRow(cos2);
      linear.row(
          m.value(SensedQuantity.TILT, 1), Quaternions.theta(r), m.sigma(SensedQuantity.TILT, 1));
    }
    return linear.rows > 0;
  }

  /** Jacobian row of φ = atan2(R32, R33), whose columns change by δθ × column. */
  private void rollRow(double cos2) {
    linear.set(FilterState.ATTITUDE, (r[8] * r[4] - r[7] * r[5]) / cos2);
    linear.set(FilterState.ATTITUDE + 1, (-r[8] * r[1] + r[7] * r[2]) / cos2);
  }

  /** Jacobian row of θ = -asin(R31). */
  private void pitchRow(double cos2) {
    double cos = Math.sqrt(cos2);
    linear.set(FilterState.ATTITUDE, -r[3] / cos);
    linear.set(FilterState.ATTITUDE + 1, r[0] / cos);
  }

  /** Jacobian row of ψ = atan2(R21, R11). */
  private boolean headingRow(boolean hasTilt) {
    double cos2 = r[0] * r[0] + r[3] * r[3];
    if (cos2 < STEEP * STEEP) {
      return false;
    }
    if (hasTilt) {
      linear.set(FilterState.ATTITUDE, -r[0] * r[6] / cos2);
      linear.set(FilterState.ATTITUDE + 1, -r[3] * r[6] / cos2);
    }
    linear.set(FilterState.ATTITUDE + 2, 1.0);
    return true;
  }

  private boolean heading(Measurement m) {
    if (!headingRow(true)) {
      return false;
    }
    double psi = Quaternions.psi(r);
    double apart = Math.IEEEremainder(m.value(SensedQuantity.HEADING, 0) - psi, FULL_TURN);
    linear.row(psi + apart, psi, m.sigma(SensedQuantity.HEADING, 0));
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
          linear.set(to, sign * ex);
          linear.set(to + 1, sign * ey);
        }
        linear.set(to + 2, sign * ez);
        double[] x = s.x;
        double rate = ex * x[FilterState.W] + ey * x[FilterState.W + 1] + ez * x[FilterState.W + 2];
        linear.row(
            m.value(SensedQuantity.EULER_RATES, i), rate, m.sigma(SensedQuantity.EULER_RATES, i));
        if (s.isInertial) {
          linear.variance[linear.rows - 1] +=
              x[FilterState.GYRO_DENSITY] / Math.max(1e-3, x[FilterState.INPUT_INTERVAL]);
        }
      }
    }
    return linear.rows > 0;
  }

  /** Model of body rates that do not drive the prediction: incomplete, or from a second sensor. */
  private void bodyRates(FilterState s, Measurement m) {
    for (int i = 0; i < 3; i++) {
      if (m.has(SensedQuantity.BODY_RATES, i) && (s.hasTilt || i == 2) && !s.isInertial) {
        linear.set(FilterState.RATE + i, 1.0);
        linear.set(FilterState.GYRO_BIAS + i, 1.0);
        linear.row(
            m.value(SensedQuantity.BODY_RATES, i),
            s.x[FilterState.W + i] + s.x[FilterState.BG + i],
            m.sigma(SensedQuantity.BODY_RATES, i));
      }
    }
  }

  /** Model of specific force, f = Rᵀ (0, 0, -g) + b, for a vehicle that hardly accelerates. */
  private void gravity(FilterState s, Measurement m) {
    double g = s.gravity();
    for (int axis = 0; axis < 3; axis++) {
      if (m.has(SensedQuantity.SPECIFIC_FORCE, axis)) {
        linear.set(FilterState.ATTITUDE, -g * r[3 + axis]);
        linear.set(FilterState.ATTITUDE + 1, g * r[axis]);
        linear.set(FilterState.FORCE_BIAS + axis, 1.0);
        linear.row(
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
    linear.set(FilterState.POSITION, -north / range);
    linear.set(FilterState.POSITION + 1, -east / range);
    linear.row(m.value(SensedQuantity.LANDMARK, 0), range, m.sigma(SensedQuantity.LANDMARK, 0));
    linear.variance[0] += spread * spread / (2.0 * range2);
    if (!headingRow(s.hasTilt)) {
      return true; // nose points up: only the range is usable
    }
    for (int i = 0; i < 3; i++) {
      linear.h.data[FilterState.N + FilterState.ATTITUDE + i] *= -1.0;
    }
    linear.set(FilterState.POSITION, east / range2);
    linear.set(FilterState.POSITION + 1, -north / range2);
    double bearing = StrictMath.atan2(east, north) - Quaternions.psi(r);
    double measured = m.value(SensedQuantity.LANDMARK, 1);
    double apart = Math.IEEEremainder(measured - bearing, FULL_TURN);
    linear.row(bearing + apart, bearing, m.sigma(SensedQuantity.LANDMARK, 1));
    linear.variance[1] += spread * spread / (2.0 * range2 * range2);
    return true;
  }

  /** Computes the standard deviations of roll, pitch and heading of a state [rad]. */
  void attitudeSigmas(FilterState s, double[] to) {
    linear.clear();
    Quaternions.matrix(s.x, FilterState.Q, r);
    double cos2 = Math.max(STEEP * STEEP, r[7] * r[7] + r[8] * r[8]);
    rollRow(cos2);
    linear.rows = 1;
    pitchRow(cos2);
    linear.rows = 2;
    headingRow(s.hasTilt);
    for (int i = 0; i < 3; i++) {
      to[i] = linear.sigma(s, i);
    }
  }

  /** Computes the speeds through the fluid along BODY_FRD and their standard deviations [m/s]. */
  void fluid(FilterState s, double[] speeds, double[] sigmas) {
    linear.clear();
    Quaternions.matrix(s.x, FilterState.Q, r);
    along(s, true);
    for (int axis = 0; axis < 3; axis++) {
      linear.rows = axis;
      vehicleRow(s, axis, true);
      speeds[axis] = predictedAlong(axis);
      sigmas[axis] = linear.sigma(s, axis);
    }
  }
}
