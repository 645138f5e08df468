package org.u2sa.scenarios.suas.score;

/** Counts how often a boundary was left; within 10 s after the last time it counts as one. */
public final class BoundaryCount {
  private static final double DEBOUNCE_S = 10.0;

  private double lastOutS = Double.NEGATIVE_INFINITY;
  private int count;

  /** Adds a position of a later time; true if it counts again. */
  public boolean see(double timeS, boolean isInside) {
    if (isInside) {
      return false;
    }
    boolean isNew = timeS - lastOutS > DEBOUNCE_S;
    count += isNew ? 1 : 0;
    lastOutS = timeS;
    return isNew;
  }

  public int count() {
    return count;
  }
}
