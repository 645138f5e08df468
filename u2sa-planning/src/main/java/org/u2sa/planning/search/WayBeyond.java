package org.u2sa.planning.search;

import java.util.Arrays;
import java.util.BitSet;

/**
 * Lengths of ways to a goal outside a {@link CostGrid}, around closed cells of a coarser grid that
 * contains both. A way is straight from where it sees the goal, and otherwise the shortest between
 * cells (Dijkstra: A Note on Two Problems in Connexion with Graphs, Numerische Mathematik 1, 1959).
 * Immutable.
 */
public final class WayBeyond {
  private static final double DIAGONAL = Math.sqrt(2.0);
  private static final double NEVER = Double.POSITIVE_INFINITY;
  private static final int OPEN = 2; // cells around the goal that count as open
  private static final double UNREACHED = 4.0; // extra length without a way [sides of the grid]

  private final GridFrame frame;
  private final BitSet closed;
  private final double goalNorthM;
  private final double goalEastM;
  private final int goalRow;
  private final int goalColumn;
  private final BitSet seesGoal = new BitSet();
  private final double[] lengthM;

  /**
   * @param frame contains the goal
   * @param closed cells to lead around; not changed later
   */
  public WayBeyond(GridFrame frame, BitSet closed, double goalNorthM, double goalEastM) {
    this.frame = frame;
    this.closed = closed;
    this.goalNorthM = goalNorthM;
    this.goalEastM = goalEastM;
    goalRow = frame.row(goalNorthM);
    goalColumn = frame.column(goalEastM);
    lengthM = new double[frame.cells()];
    look();
    spread();
  }

  /** Whether it leads around the same cells. */
  public boolean isAround(BitSet cells) {
    return closed.equals(cells);
  }

  /** Whether there is a way from a point. */
  boolean reaches(double northM, double eastM) {
    return lengthM(northM, eastM) < straightM(northM, eastM) + unreachedM();
  }

  /**
   * Length of the way from a point [m]. Without a way, it is longer than all ways, and grows with
   * the distance.
   */
  public double lengthM(double northM, double eastM) {
    double straightM = straightM(northM, eastM);
    int row = frame.row(northM);
    int column = frame.column(eastM);
    if (!frame.contains(row, column) || seesGoal.get(frame.index(row, column))) {
      return straightM;
    }
    double least = NEVER;
    for (int r = Math.max(0, row - 1); r <= Math.min(frame.rows() - 1, row + 1); r++) {
      for (int c = Math.max(0, column - 1); c <= Math.min(frame.columns() - 1, column + 1); c++) {
        int near = frame.index(r, c);
        double north = frame.centreNorthM(near) - northM;
        double east = frame.centreEastM(near) - eastM;
        least = Math.min(least, lengthM[near] + Math.sqrt(north * north + east * east));
      }
    }
    return least < NEVER ? Math.max(straightM, least) : straightM + unreachedM();
  }

  private double unreachedM() {
    return UNREACHED * frame.cellM() * Math.max(frame.rows(), frame.columns());
  }

  private double straightM(double northM, double eastM) {
    double north = northM - goalNorthM;
    double east = eastM - goalEastM;
    return Math.sqrt(north * north + east * east);
  }

  private boolean isOpen(int row, int column) {
    boolean isNear = Math.max(Math.abs(row - goalRow), Math.abs(column - goalColumn)) <= OPEN;
    return isNear || !closed.get(frame.index(row, column));
  }

  /** Determines from which cells the goal is seen, outwards: the next cell towards it sees it. */
  private void look() {
    seesGoal.set(frame.index(goalRow, goalColumn));
    int most = Math.max(frame.rows(), frame.columns());
    for (int away = 1; away < most; away++) {
      for (int along = -away; along <= away; along++) {
        look(-away, along, away);
        look(away, along, away);
        look(along, -away, away);
        look(along, away, away);
      }
    }
  }

  private void look(int rows, int columns, int away) {
    int row = goalRow + rows;
    int column = goalColumn + columns;
    if (frame.contains(row, column) && isOpen(row, column)) {
      double share = (away - 1.0) / away;
      int nextRow = goalRow + (int) Math.rint(share * rows);
      int nextColumn = goalColumn + (int) Math.rint(share * columns);
      seesGoal.set(frame.index(row, column), seesGoal.get(frame.index(nextRow, nextColumn)));
    }
  }

  private void spread() {
    Arrays.fill(lengthM, NEVER);
    PairHeap open = new PairHeap(frame.cells());
    for (int cell = seesGoal.nextSetBit(0); cell >= 0; cell = seesGoal.nextSetBit(cell + 1)) {
      lengthM[cell] = straightM(frame.centreNorthM(cell), frame.centreEastM(cell));
      open.put(cell, lengthM[cell], 0.0);
    }
    while (!open.isEmpty()) {
      int cell = open.first();
      open.remove(cell);
      int row = cell / frame.columns();
      int column = cell % frame.columns();
      for (int r = Math.max(0, row - 1); r <= Math.min(frame.rows() - 1, row + 1); r++) {
        for (int c = Math.max(0, column - 1); c <= Math.min(frame.columns() - 1, column + 1); c++) {
          int next = frame.index(r, c);
          double through = lengthM[cell] + step(row, column, r, c);
          if (through < lengthM[next] && isOpen(r, c)) {
            lengthM[next] = through;
            open.put(next, through, 0.0);
          }
        }
      }
    }
  }

  /** Infinite also between two closed cells. */
  private double step(int row, int column, int toRow, int toColumn) {
    if (row == toRow || column == toColumn) {
      return frame.cellM();
    }
    boolean leadsOn = isOpen(row, toColumn) || isOpen(toRow, column);
    return leadsOn ? DIAGONAL * frame.cellM() : NEVER;
  }
}
