package org.u2sa.sim.vehicle;

import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.Rotation;
import org.u2sa.sim.motion.BodyAttitude;

/**
 * State vector of a rigid body over a flat earth, and its kinematics: north, east, down [m];
 * quaternion of the attitude (w, x, y, z); velocity u, v, w in body axes [m/s]; p, q, r [rad/s].
 * Models append their own states.
 */
public final class BodyState {
  /** Index of the position: north, east, down [m]. */
  public static final int NED = 0;

  /** Index of the attitude's quaternion: w, x, y, z. */
  public static final int QUATERNION = 3;

  /** Index of the velocity in body axes: forward, right, down [m/s]. */
  public static final int VELOCITY = 7;

  /** Index of the angular rates about the body axes [rad/s]. */
  public static final int RATES = 10;

  /** Number of these states; index of the first one of a model. */
  public static final int SIZE = 13;

  private BodyState() {}

  /**
   * Places a body at rest.
   *
   * @param start east, north, up [m]
   * @param headingRad clockwise from north [rad]
   */
  public static void place(double[] s, Point start, double headingRad) {
    s[NED] = start.y();
    s[NED + 1] = start.x();
    s[NED + 2] = -start.z();
    BodyAttitude.write(s, QUATERNION, 0.0, 0.0, headingRad);
  }

  /**
   * Computes the rates of position and attitude.
   *
   * @param driftNorth velocity of the medium in which the body's velocity is measured, north [m/s];
   *     0 for a velocity over ground
   * @param driftEast velocity of the medium, east [m/s]
   */
  public static void kinematics(double[] s, double[] rate, double driftNorth, double driftEast) {
    double w = s[QUATERNION];
    double x = s[QUATERNION + 1];
    double y = s[QUATERNION + 2];
    double z = s[QUATERNION + 3];
    double a = s[VELOCITY];
    double b = s[VELOCITY + 1];
    double c = s[VELOCITY + 2];
    double p = s[RATES];
    double q = s[RATES + 1];
    double r = s[RATES + 2];
    rate[NED] =
        driftNorth
            + (1 - 2 * (y * y + z * z)) * a
            + 2 * (x * y - w * z) * b
            + 2 * (x * z + w * y) * c;
    rate[NED + 1] =
        driftEast
            + 2 * (x * y + w * z) * a
            + (1 - 2 * (x * x + z * z)) * b
            + 2 * (y * z - w * x) * c;
    rate[NED + 2] =
        2 * (x * z - w * y) * a + 2 * (y * z + w * x) * b + (1 - 2 * (x * x + y * y)) * c;
    rate[QUATERNION] = -0.5 * (x * p + y * q + z * r);
    rate[QUATERNION + 1] = 0.5 * (w * p + y * r - z * q);
    rate[QUATERNION + 2] = 0.5 * (w * q + z * p - x * r);
    rate[QUATERNION + 3] = 0.5 * (w * r + x * q - y * p);
  }

  /** Restores the quaternion's length after a step of integration. */
  public static void normalize(double[] s) {
    double square = 0.0;
    for (int i = QUATERNION; i < QUATERNION + 4; i++) {
      square += s[i] * s[i];
    }
    double scale = 1.0 / StrictMath.sqrt(square);
    for (int i = QUATERNION; i < QUATERNION + 4; i++) {
      s[i] *= scale;
    }
  }

  /** The three values starting at an index. */
  public static Point at(double[] values, int index) {
    return Point.of(values[index], values[index + 1], values[index + 2]);
  }

  /**
   * Ground truth of a body.
   *
   * @param s state
   * @param rate its derivative
   */
  public static VehicleTruth truth(double timeS, double[] s, double[] rate) {
    Attitude attitude = attitude(s);
    Rotation nedFromFrd = attitude.nedFromFrd();
    Point turn = at(s, RATES);
    Point through = at(s, VELOCITY);
    Point turning = turn.cross(through); // transport term of the rotating axes
    Point acceleration = nedFromFrd.times(at(rate, VELOCITY).plus(turning));
    return new VehicleTruth(
        timeS,
        at(s, NED).axesExchanged(),
        attitude,
        at(rate, NED).axesExchanged(),
        turn,
        acceleration.axesExchanged());
  }

  public static Attitude attitude(double[] s) {
    double w = s[QUATERNION];
    double x = s[QUATERNION + 1];
    double y = s[QUATERNION + 2];
    double z = s[QUATERNION + 3];
    double sinTheta = StrictMath.max(-1.0, StrictMath.min(1.0, 2 * (w * y - x * z)));
    double psi = StrictMath.atan2(2 * (x * y + w * z), 1 - 2 * (y * y + z * z));
    return new Attitude(
        StrictMath.atan2(2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
        StrictMath.asin(sinTheta),
        psi < 0.0 ? psi + 2.0 * StrictMath.PI : psi);
  }
}
