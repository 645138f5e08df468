package org.u2sa.estimation.measurement;

/**
 * Finds the step of a source that rounds its coordinates: between repetitions of a value, its
 * changes are multiples of one step. At a constant speed alone, changes are equal, too. The numbers
 * of a source are kept in an array, so that a replay reproduces them.
 */
public final class PositionGrid {
  /** Numbers per coordinate. */
  public static final int SIZE = 4;

  private static final int NEWEST = 0;
  private static final int STEP = 1;
  private static final int CONFIRMED = 2;
  private static final int REPEATED = 3; // since the last change
  private static final double SURE = 3.0; // changes in a row
  private static final double MAX_STEPS = 3.0; // per change; every change is a multiple of some
  private static final double TOLERANCE = 0.02; // of a step

  private PositionGrid() {}

  /**
   * Records a coordinate.
   *
   * @param at index of the coordinate's numbers, initially 0
   * @return step in the coordinate's unit; 0 if none is found
   */
  public static double step(double[] t, int at, double value) {
    double change = t[at + NEWEST] == 0.0 ? 0.0 : Math.abs(value - t[at + NEWEST]);
    t[at + NEWEST] = value;
    boolean isRepeated = t[at + REPEATED] > 0.0;
    t[at + REPEATED] = change == 0.0 ? 1.0 : 0.0;
    if (change > 0.0 && isRepeated && isMultiple(change, t[at + STEP])) {
      t[at + CONFIRMED]++;
    } else if (change > 0.0 && !isMultiple(change, t[at + STEP])) {
      t[at + CONFIRMED] = isRepeated && isMultiple(t[at + STEP], change) ? 1.0 : 0.0;
      t[at + STEP] = change;
    }
    return t[at + CONFIRMED] >= SURE ? t[at + STEP] : 0.0;
  }

  private static boolean isMultiple(double change, double step) {
    double steps = step > 0.0 ? change / step : 0.0;
    double whole = Math.rint(steps);
    return whole >= 1.0 && whole <= MAX_STEPS && Math.abs(steps - whole) < TOLERANCE;
  }
}
