package org.u2sa.estimation.delay;

import java.util.Arrays;
import org.u2sa.estimation.rotation.TurnedVectors;

/**
 * Velocity and way that specific forces and gyroscopes alone have given a vehicle during the last
 * second, without any correction, so that a measurement can be compared with the motion at an
 * earlier time. Horizontally its axes are those of the gyroscopes: corrections of the heading
 * rotate the estimate against them.
 */
public final class InertialPath {
  private static final int ENTRIES = 30;
  private static final double SPACING_S = 0.04;
  private static final int ENTRY = 7; // time, gained velocity, way

  private static final int COUNT = 0; // of entries
  private static final int NEWEST = 1; // index of the newest
  private static final int COS = 2; // of the heading's corrections
  private static final int SIN = 3;
  private static final int NOW = 4; // an entry
  private static final int FIRST = NOW + ENTRY;

  /** Numbers in the array. */
  public static final int SIZE = FIRST + ENTRIES * ENTRY;

  private InertialPath() {}

  /** Discards the path. */
  public static void restart(double[] x) {
    x[COUNT] = 0.0;
  }

  /**
   * Integrates an acceleration.
   *
   * @param untilS end of the interval [s]
   * @param seconds length of the interval
   * @param north acceleration by the estimate's heading [m/s²]
   */
  public static void advance(
      double[] x, double untilS, double seconds, double north, double east, double down) {
    if (x[COUNT] == 0.0) {
      Arrays.fill(x, 0, FIRST, 0.0);
      x[COS] = 1.0;
      x[NOW] = untilS - seconds;
      store(x);
    }
    gain(x, 0, seconds, x[COS] * north + x[SIN] * east);
    gain(x, 1, seconds, x[COS] * east - x[SIN] * north);
    gain(x, 2, seconds, down);
    x[NOW] = untilS;
    if (untilS - x[FIRST + ENTRY * (int) x[NEWEST]] >= SPACING_S - 1e-6) {
      store(x);
    }
  }

  private static void gain(double[] x, int axis, double seconds, double acceleration) {
    x[NOW + 4 + axis] += seconds * (x[NOW + 1 + axis] + 0.5 * seconds * acceleration);
    x[NOW + 1 + axis] += seconds * acceleration;
  }

  private static void store(double[] x) {
    int next = x[COUNT] == 0.0 ? 0 : ((int) x[NEWEST] + 1) % ENTRIES;
    System.arraycopy(x, NOW, x, FIRST + ENTRY * next, ENTRY);
    x[NEWEST] = next;
    x[COUNT] = Math.min(ENTRIES, x[COUNT] + 1.0);
  }

  /** Corrects the estimate's heading, clockwise [rad]. */
  public static void corrected(double[] x, double byRad) {
    TurnedVectors.addAngle(x, COS, byRad);
  }

  /**
   * Velocity and way at an earlier time, along the path's axes.
   *
   * @param agoS before the newest acceleration [s]
   * @param to becomes the velocity [m/s] and the way [m]: three of each
   * @return false if that is before the path begins
   */
  static boolean then(double[] x, double agoS, double[] to) {
    double then = x[NOW] - agoS;
    int later = NOW;
    for (int back = 0; back < (int) x[COUNT]; back++) {
      int entry = FIRST + ENTRY * (((int) x[NEWEST] - back + ENTRIES) % ENTRIES);
      if (x[entry] <= then) {
        double span = x[later] - x[entry];
        double share = span > 0.0 ? (then - x[entry]) / span : 0.0;
        for (int i = 0; i < 6; i++) {
          to[i] = x[entry + 1 + i] + share * (x[later + 1 + i] - x[entry + 1 + i]);
        }
        return true;
      }
      later = entry;
    }
    return false;
  }

  /**
   * Motion since an earlier time: north, east, down by the estimate's present heading.
   *
   * @param agoS before the newest acceleration [s]
   * @param to becomes the change of velocity since then [m/s], and the way beyond that of the
   *     present velocity [m]: three of each
   * @return false if that is before the path begins
   */
  public static boolean since(double[] x, double agoS, double[] to) {
    if (!then(x, agoS, to)) {
      return false;
    }
    for (int i = 0; i < 3; i++) {
      to[i] = x[NOW + 1 + i] - to[i];
      to[3 + i] = x[NOW + 4 + i] - to[3 + i] - agoS * x[NOW + 1 + i];
    }
    for (int i = 0; i < 6; i += 3) {
      double north = to[i];
      to[i] = x[COS] * north - x[SIN] * to[i + 1];
      to[i + 1] = x[COS] * to[i + 1] + x[SIN] * north;
    }
    return true;
  }
}
