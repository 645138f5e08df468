package org.u2sa.planning.search;

/**
 * Cells on which the vehicle has stood or driven, and which are therefore free, whether or not a
 * sensor has seen them. Not thread-safe.
 */
public final class PassedGround {
  private final GridFrame frame;
  private final boolean[] passed;

  PassedGround(GridFrame frame) {
    this.frame = frame;
    passed = new boolean[frame.cells()];
  }

  /** Adds the cells that another grid has on record. */
  public void addAll(PassedGround other) {
    for (int i = 0; i < passed.length; i++) {
      int cell = other.frame.indexAt(frame.centreNorthM(i), frame.centreEastM(i));
      passed[i] |= cell >= 0 && other.passed[cell];
    }
  }

  /** Adds the cells below a vehicle; those outside the grid are ignored. */
  public void add(BodyDiscs body, double northM, double eastM, double headingRad) {
    double cos = Math.cos(headingRad);
    double sin = Math.sin(headingRad);
    double half = 0.5 * frame.cellM();
    double reach = body.circleM() + half;
    int lastRow = Math.min(frame.rows() - 1, frame.row(northM + reach));
    int lastColumn = Math.min(frame.columns() - 1, frame.column(eastM + reach));
    for (int row = Math.max(0, frame.row(northM - reach)); row <= lastRow; row++) {
      for (int column = Math.max(0, frame.column(eastM - reach)); column <= lastColumn; column++) {
        int i = frame.index(row, column);
        double north = frame.centreNorthM(i) - northM;
        double east = frame.centreEastM(i) - eastM;
        passed[i] |= body.covers(north * cos + east * sin, east * cos - north * sin, half);
      }
    }
  }

  boolean contains(int cell) {
    return passed[cell];
  }
}
