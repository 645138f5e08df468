package org.u2sa.estimation.measurement;

/**
 * Finds the step of a source that rounds its coordinates: a coordinate repeats while the other one
 * changes, and its changes are multiples of one step. A fix that is published again repeats both,
 * and is no evidence. The numbers of a source are kept in an array, so that a replay reproduces
 * them.
 */
public final class PositionGrid {
  /** Numbers of the two coordinates of a source. */
  public static final int SIZE = 8;

  private static final int PER_COORDINATE = 4;
  private static final int NEWEST = 0;
  private static final int STEP = 1;
  private static final int CONFIRMED = 2;
  private static final int REPEATED = 3; // while the other one changed, since its last change
  private static final double SURE = 2.0; // changes in a row
  private static final double MAX_STEPS = 3.0; // per change; every change is a multiple of some
  private static final double TOLERANCE = 1e-6; // of a step; noise differs by more

  private PositionGrid() {}

  /**
   * Records a position.
   *
   * @param at index of the source's numbers, initially 0
   */
  public static void record(double[] t, int at, double first, double second) {
    double firstChange = change(t, at, first);
    double secondChange = change(t, at + PER_COORDINATE, second);
    record(t, at, firstChange, secondChange > 0.0);
    record(t, at + PER_COORDINATE, secondChange, firstChange > 0.0);
  }

  private static double change(double[] t, int at, double value) {
    double change = t[at + NEWEST] == 0.0 ? 0.0 : Math.abs(value - t[at + NEWEST]);
    t[at + NEWEST] = value;
    return change;
  }

  private static void record(double[] t, int at, double change, boolean hasOtherChanged) {
    if (change == 0.0) {
      t[at + REPEATED] = hasOtherChanged ? 1.0 : t[at + REPEATED];
      return;
    }
    double evidence = t[at + REPEATED];
    t[at + REPEATED] = 0.0;
    if (isMultiple(change, t[at + STEP])) {
      t[at + CONFIRMED] = evidence * (t[at + CONFIRMED] + 1.0);
    } else {
      t[at + CONFIRMED] = isMultiple(t[at + STEP], change) ? evidence : 0.0;
      t[at + STEP] = change;
    }
  }

  /**
   * Step of a coordinate.
   *
   * @param coordinate 0 or 1
   * @return in the coordinate's unit; 0 if none is found
   */
  public static double step(double[] t, int at, int coordinate) {
    int of = at + coordinate * PER_COORDINATE;
    return t[of + CONFIRMED] >= SURE ? t[of + STEP] : 0.0;
  }

  private static boolean isMultiple(double change, double step) {
    double steps = step > 0.0 ? change / step : 0.0;
    double whole = Math.rint(steps);
    return whole >= 1.0 && whole <= MAX_STEPS && Math.abs(steps - whole) < TOLERANCE;
  }
}
