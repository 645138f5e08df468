package org.u2sa.estimation.fusion;

import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.rotation.Quaternions;

/**
 * Lever-arm corrections for a sensor that is not at the vehicle's reference point. With its offset
 * l along BODY_FRD it is at p + R l, moves with v + R (ω × l) and has an acceleration that exceeds
 * the reference point's by ω̇ × l + ω × (ω × l) (Groves, Principles of GNSS, Inertial, and
 * Multisensor Integrated Navigation Systems, 2nd ed., section 14.3; Titterton and Weston, 2nd ed.,
 * section 12.3).
 */
final class LeverArm {
  private final double[] l = new double[3];
  private final double[] arm = new double[3]; // R l
  private final double[] swing = new double[3]; // ω × l, along BODY_FRD
  private final double[] turned = new double[3]; // R (ω × l)
  private final double[] r = new double[9];
  private boolean isThere;
  private boolean hasHeading;
  private double unknown2; // square of a horizontal arm of unknown direction
  private double swingNoise2; // variance of ω × l due to gyroscope noise

  /** Sets the lever arm from a measurement, and attitude and rates from the state. */
  void look(FilterState s, Measurement m) {
    isThere = false;
    for (int i = 0; i < 3; i++) {
      l[i] = m.mounted(i);
      isThere |= l[i] != 0.0;
    }
    if (!isThere) {
      return;
    }
    Quaternions.matrix(s.x, FilterState.Q, r);
    cross(s.x, FilterState.W, l, swing);
    turn(l, arm);
    turn(swing, turned);
    hasHeading = s.hasHeading;
    unknown2 = hasHeading ? 0.0 : arm[0] * arm[0] + arm[1] * arm[1];
    double length2 = l[0] * l[0] + l[1] * l[1] + l[2] * l[2];
    double density = s.isInertial ? s.x[FilterState.GYRO_DENSITY] : 0.0;
    swingNoise2 = length2 * density / Math.max(1e-3, s.x[FilterState.INPUT_INTERVAL]);
  }

  private static void cross(double[] a, int from, double[] b, double[] to) {
    to[0] = a[from + 1] * b[2] - a[from + 2] * b[1];
    to[1] = a[from + 2] * b[0] - a[from] * b[2];
    to[2] = a[from] * b[1] - a[from + 1] * b[0];
  }

  private void turn(double[] body, double[] to) {
    for (int i = 0; i < 3; i++) {
      to[i] = r[3 * i] * body[0] + r[3 * i + 1] * body[1] + r[3 * i + 2] * body[2];
    }
  }

  /** Offset of the sensor from the reference point, north, east or down [m]; 0 if unknown. */
  double apartM(int axis) {
    return isThere && (hasHeading || axis == 2) ? arm[axis] : 0.0;
  }

  /** Variance of {@link #apartM} due to an unknown heading [m²]. */
  double apartVariance(int axis) {
    return isThere && axis < 2 ? unknown2 : 0.0;
  }

  /** Adds the lever arm to a position row: north, east or down. */
  void position(Linearization to, int axis, double sign) {
    if (isThere) {
      to.shift(sign * apartM(axis), apartVariance(axis));
      if (hasHeading) {
        attitude(to, arm, axis, sign);
      }
    }
  }

  /** Adds the lever arm to a velocity row: north, east or down. */
  void velocity(FilterState s, Linearization to, int axis) {
    if (!isThere) {
      return;
    }
    if (!hasHeading) {
      to.shift(0.0, turned[0] * turned[0] + turned[1] * turned[1]);
      return;
    }
    to.shift(turned[axis], swingNoise2);
    attitude(to, turned, axis, 1.0);
    double r0 = r[3 * axis];
    double r1 = r[3 * axis + 1];
    double r2 = r[3 * axis + 2];
    rates(s, to, r2 * l[1] - r1 * l[2], r0 * l[2] - r2 * l[0], r1 * l[0] - r0 * l[1]);
  }

  /** Adds the lever arm to a velocity row along BODY_FRD. */
  void bodyVelocity(FilterState s, Linearization to, int axis) {
    if (isThere) {
      to.shift(swing[axis], swingNoise2);
      rates(
          s,
          to,
          axis == 0 ? 0.0 : axis == 1 ? -l[2] : l[1],
          axis == 0 ? l[2] : axis == 1 ? 0.0 : -l[0],
          axis == 0 ? -l[1] : axis == 1 ? l[0] : 0.0);
    }
  }

  /** Sets the attitude columns: a vector a in earth axes changes by δθ × a. */
  private static void attitude(Linearization to, double[] of, int axis, double sign) {
    int next = (axis + 1) % 3;
    int last = (axis + 2) % 3;
    to.setLast(FilterState.ATTITUDE + next, sign * of[last]);
    to.setLast(FilterState.ATTITUDE + last, -sign * of[next]);
  }

  /** Sets the angular-rate columns; with gyroscopes, only the biases are uncertain. */
  private static void rates(FilterState s, Linearization to, double byX, double byY, double byZ) {
    int at = s.isInertial ? FilterState.GYRO_BIAS : FilterState.RATE;
    double sign = s.isInertial ? -1.0 : 1.0;
    if (s.hasTilt) {
      to.setLast(at, sign * byX);
      to.setLast(at + 1, sign * byY);
    }
    to.setLast(at + 2, sign * byZ);
  }

  /**
   * Removes the lever-arm acceleration from a specific force.
   *
   * @param rate angular rates [rad/s]
   * @param change angular accelerations [rad/s²]
   * @param force specific force, modified in place: three numbers starting at that index [m/s²]
   */
  static void release(Measurement m, double[] rate, double[] change, double[] force, int from) {
    double x = m.mounted(0);
    double y = m.mounted(1);
    double z = m.mounted(2);
    double dot = rate[0] * x + rate[1] * y + rate[2] * z;
    double rate2 = rate[0] * rate[0] + rate[1] * rate[1] + rate[2] * rate[2];
    force[from] -= rate[0] * dot - rate2 * x + change[1] * z - change[2] * y;
    force[from + 1] -= rate[1] * dot - rate2 * y + change[2] * x - change[0] * z;
    force[from + 2] -= rate[2] * dot - rate2 * z + change[0] * y - change[1] * x;
  }
}
