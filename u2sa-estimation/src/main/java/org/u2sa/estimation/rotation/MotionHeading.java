package org.u2sa.estimation.rotation;

import java.util.Arrays;

/**
 * Shows from a receiver's velocities whether an inertial estimate's heading is right, without any
 * sensor of headings: the velocity changes by the acceleration that the forces show, rotated by the
 * error of the heading (as PX4's yaw estimator does, with one linear filter instead of several
 * nonlinear ones). The axes are those of the gyroscopes alone: corrections of the heading rotate
 * the estimate against them, but not what has been learnt.
 *
 * <p>The acceleration's own error (tilt, bias) and a drift of the gyroscopes limit how long a
 * manoeuvre counts: after ten seconds of steady flight the heading is unknown again.
 */
public final class MotionHeading {
  /** Numbers in the array. */
  public static final int SIZE = 11 + TurnedVectors.SIZE;

  private static final int GAINED = 0; // by the forces since the newest velocity, north, east [m/s]
  private static final int COS = 2; // of the corrections' sum
  private static final int SIN = 3;
  private static final int SECONDS = 4; // since the newest velocity
  private static final int SOURCE = 5;
  private static final int IS_BEGUN = 6;
  private static final int IS_CORRECTED = 7; // contrary to the sources of headings
  private static final int SINCE = 8; // gained since the newest velocity was measured, two
  private static final int IS_DOUBTED = 10; // the time of the velocities
  private static final int FIT = 11;

  private static final double ACCELERATION_NOISE =
      0.15; // m/s per √s, e.g. a few seconds of 0.5° of tilt
  private static final double TURN_NOISE =
      0.04; // rad per √s, e.g. a step of the gyroscopes' bias of 0.04 rad/s
  private static final double MIN_SIGMA_MPS = 0.1;
  private static final double SILENT_S = 3.0; // after this another source may be used
  private static final double MAX_SIGMA_RAD = 0.15;
  private static final double SCALE = 0.1; // error of the forces' scale
  private static final double MISLED_RAD = 0.12;
  private static final double UNLIKELY = 3.0; // standard deviations

  private MotionHeading() {}

  /** Discards what was learnt. */
  public static void restart(double[] x) {
    x[IS_BEGUN] = 0.0;
  }

  /**
   * Integrates an acceleration.
   *
   * @param north acceleration by the estimate's heading [m/s²]
   */
  public static void accelerate(double[] x, double north, double east, double seconds) {
    x[GAINED] += seconds * (x[COS] * north + x[SIN] * east);
    x[GAINED + 1] += seconds * (x[COS] * east - x[SIN] * north);
    x[SECONDS] += seconds;
  }

  /** Corrects the estimate's heading, clockwise [rad]. */
  public static void corrected(double[] x, double byRad) {
    TurnedVectors.addAngle(x, COS, byRad);
  }

  /**
   * Compares with a measured velocity.
   *
   * @param north velocity over ground [m/s]
   * @param variance per axis [m²/s²]
   */
  public static void velocity(double[] x, int source, double north, double east, double variance) {
    velocity(x, source, north, east, variance, 0.0, 0.0);
  }

  /**
   * Compares with a velocity that was measured a while ago.
   *
   * @param north velocity over ground [m/s]
   * @param variance per axis [m²/s²]
   * @param sinceNorth by which the forces have changed the velocity since it was measured, by the
   *     estimate's heading [m/s]
   */
  public static void velocity(
      double[] x,
      int source,
      double north,
      double east,
      double variance,
      double sinceNorth,
      double sinceEast) {
    double white = Math.max(MIN_SIGMA_MPS * MIN_SIGMA_MPS, variance);
    boolean isOther = source != (int) x[SOURCE];
    if (x[IS_BEGUN] == 0.0 || isOther && x[SECONDS] > SILENT_S) {
      Arrays.fill(x, 0, IS_CORRECTED, 0.0);
      x[COS] = 1.0;
      x[SOURCE] = source;
      x[IS_BEGUN] = 1.0;
      x[SINCE] = sinceNorth;
      x[SINCE + 1] = sinceEast;
      TurnedVectors.begin(x, FIT, north, east, white);
    } else if (!isOther) {
      double drift = ACCELERATION_NOISE * ACCELERATION_NOISE * x[SECONDS];
      TurnedVectors.wander(x, FIT, drift, TURN_NOISE * TURN_NOISE * x[SECONDS]);
      double newNorth = x[COS] * sinceNorth + x[SIN] * sinceEast;
      double newEast = x[COS] * sinceEast - x[SIN] * sinceNorth;
      double gainedNorth = x[GAINED] + x[SINCE] - newNorth;
      double gainedEast = x[GAINED + 1] + x[SINCE + 1] - newEast;
      x[SINCE] = newNorth;
      x[SINCE + 1] = newEast;
      TurnedVectors.update(x, FIT, gainedNorth, gainedEast, north, east, white);
      TurnedVectors.advance(x, FIT, gainedNorth, gainedEast);
      Arrays.fill(x, GAINED, GAINED + 2, 0.0);
      x[SECONDS] = 0.0;
    }
  }

  /**
   * Whether the source's velocities may be late: what changes later than shown looks as if it were
   * rotated.
   */
  public static void doubt(double[] x, boolean isDoubted) {
    x[IS_DOUBTED] = isDoubted ? 1.0 : 0.0;
  }

  /** The estimate's heading has been turned to that of the motion, contrary to its sources. */
  public static void followed(double[] x) {
    x[IS_CORRECTED] = 1.0;
  }

  /** A source of headings agrees with the estimate again. */
  public static void restored(double[] x) {
    x[IS_CORRECTED] = 0.0;
  }

  /** Whether the sources of headings have been wrong since the estimate's was turned. */
  public static boolean isFollowed(double[] x) {
    return x[IS_CORRECTED] != 0.0;
  }

  private static boolean isKnown(double[] x) {
    if (x[IS_BEGUN] == 0.0 || x[SECONDS] > SILENT_S || x[IS_DOUBTED] != 0.0) {
      return false;
    }
    double variance = TurnedVectors.variance(x, FIT);
    double apart = TurnedVectors.length(x, FIT) - 1.0;
    return variance <= MAX_SIGMA_RAD * MAX_SIGMA_RAD
        && apart * apart <= UNLIKELY * UNLIKELY * (variance + SCALE * SCALE);
  }

  /**
   * Whether the motion shows that a heading is wrong.
   *
   * @param apartRad by which it differs from the estimate's, clockwise
   */
  public static boolean refutes(double[] x, double apartRad) {
    double error = Math.IEEEremainder(errorRad(x) - apartRad, 2.0 * Math.PI);
    return isKnown(x) && Math.abs(error) > Math.max(MISLED_RAD, UNLIKELY * sigmaRad(x));
  }

  /** Correction that the estimate's heading needs, clockwise [rad], −π to π. */
  public static double errorRad(double[] x) {
    double corrections = StrictMath.atan2(x[SIN], x[COS]);
    return Math.IEEEremainder(TurnedVectors.angle(x, FIT) - corrections, 2.0 * Math.PI);
  }

  /** Its standard deviation [rad]. */
  public static double sigmaRad(double[] x) {
    return Math.sqrt(TurnedVectors.variance(x, FIT));
  }
}
