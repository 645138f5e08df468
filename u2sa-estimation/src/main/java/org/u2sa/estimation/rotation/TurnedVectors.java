package org.u2sa.estimation.rotation;

import java.util.Arrays;

/**
 * Kalman filter of the rotation between two series of horizontal vectors. As complex numbers
 * (north, i east), a vector of the one series is z = c + h w + e: h rotates and scales the vector w
 * of the other, c is an offset, e white noise. The model is linear, so the filter is exact however
 * uncertain the rotation. Its numbers are eight in an array, from a given index.
 */
public final class TurnedVectors {
  /** Numbers of a filter. */
  public static final int SIZE = 8;

  private static final int C = 0; // north, east
  private static final int H = 2;
  private static final int CC = 4; // variances per axis of c and h
  private static final int HH = 5;
  private static final int CH = 6; // covariance E(c h*)
  private static final double UNKNOWN = 100.0; // variance per axis of h
  private static final double USUAL = 4.0; // NIS above which a vector is down-weighted

  private TurnedVectors() {}

  /**
   * Begins with an unknown rotation.
   *
   * @param north offset
   * @param variance of the offset per axis
   */
  public static void begin(double[] x, int at, double north, double east, double variance) {
    Arrays.fill(x, at, at + SIZE, 0.0);
    x[at + C] = north;
    x[at + C + 1] = east;
    x[at + CC] = variance;
    x[at + HH] = UNKNOWN;
  }

  /** Sets the rotation to none, with that variance. */
  public static void known(double[] x, int at, double variance) {
    x[at + H] = 1.0;
    x[at + HH] = variance;
  }

  /** As {@link #wander(double[], int, double, double)}, with a limit of the rotation's variance. */
  public static void wander(double[] x, int at, double offset, double rotation, double most) {
    x[at + CC] += offset;
    x[at + HH] = Math.min(Math.max(most, x[at + HH]), x[at + HH] + rotation);
  }

  /**
   * Makes offset and rotation more uncertain.
   *
   * @param offset added variance per axis
   * @param rotation likewise; a rotation has length 1
   */
  public static void wander(double[] x, int at, double offset, double rotation) {
    x[at + CC] += offset;
    x[at + HH] += rotation;
  }

  /**
   * Updates with a pair of vectors.
   *
   * @param wn vector w, north
   * @param zn vector z, north
   * @param zVariance variance of e per axis
   * @return normalised innovation squared, χ² distributed with two degrees of freedom
   */
  public static double update(
      double[] x, int at, double wn, double we, double zn, double ze, double zVariance) {
    double dn = zn - x[at + C] - (x[at + H] * wn - x[at + H + 1] * we);
    double de = ze - x[at + C + 1] - (x[at + H] * we + x[at + H + 1] * wn);
    double cross = x[at + CH] * wn + x[at + CH + 1] * we;
    double variance = x[at + CC] + 2.0 * cross + (wn * wn + we * we) * x[at + HH] + zVariance;
    double nis = (dn * dn + de * de) / variance;
    variance = Math.max(variance, (dn * dn + de * de) / USUAL);
    double kcn = (x[at + CC] + cross) / variance;
    double kce = (x[at + CH + 1] * wn - x[at + CH] * we) / variance;
    double khn = (x[at + CH] + wn * x[at + HH]) / variance;
    double khe = -(x[at + CH + 1] + we * x[at + HH]) / variance;
    x[at + C] += kcn * dn - kce * de;
    x[at + C + 1] += kcn * de + kce * dn;
    x[at + H] += khn * dn - khe * de;
    x[at + H + 1] += khn * de + khe * dn;
    x[at + CC] -= (kcn * kcn + kce * kce) * variance;
    x[at + HH] -= (khn * khn + khe * khe) * variance;
    x[at + CH] -= (kcn * khn + kce * khe) * variance;
    x[at + CH + 1] -= (kce * khn - kcn * khe) * variance;
    return nis;
  }

  /** Moves the offset by the rotated vector: later vectors w begin where this one ends. */
  public static void advance(double[] x, int at, double wn, double we) {
    x[at + C] += x[at + H] * wn - x[at + H + 1] * we;
    x[at + C + 1] += x[at + H] * we + x[at + H + 1] * wn;
    x[at + CC] += 2.0 * (x[at + CH] * wn + x[at + CH + 1] * we) + (wn * wn + we * we) * x[at + HH];
    x[at + CH] += wn * x[at + HH];
    x[at + CH + 1] += we * x[at + HH];
  }

  /** Angle of the rotation, clockwise [rad]. */
  public static double angle(double[] x, int at) {
    return StrictMath.atan2(x[at + H + 1], x[at + H]);
  }

  /** Length of h; 1 for a mere rotation. */
  public static double length(double[] x, int at) {
    return Math.hypot(x[at + H], x[at + H + 1]);
  }

  /** Variance of h per axis, i.e. of the angle [rad²] of a mere rotation. */
  public static double variance(double[] x, int at) {
    return x[at + HH];
  }

  /** Adds to an angle whose cosine is at an index, and whose sine is behind it [rad]. */
  public static void addAngle(double[] x, int at, double byRad) {
    double cos = StrictMath.cos(byRad);
    double sin = StrictMath.sin(byRad);
    double before = x[at];
    x[at] = cos * before - sin * x[at + 1];
    x[at + 1] = cos * x[at + 1] + sin * before;
  }
}
