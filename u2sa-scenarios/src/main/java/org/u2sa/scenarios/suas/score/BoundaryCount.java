package org.u2sa.scenarios.suas.score;

/** Counts boundary violations; several within 10 s of each other count as one. */
public final class BoundaryCount {
  private static final double DEBOUNCE_S = 10.0;

  private double lastOutS = Double.NEGATIVE_INFINITY;
  private int count;

  /** Adds a later position; returns true if it counts as a new violation. */
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
