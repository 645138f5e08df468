package org.u2sa.world.object;

import java.util.Arrays;

/**
 * Assigns rows to columns at minimum total cost: the Kuhn-Munkres problem, solved by shortest
 * augmenting paths with potentials (Jonker and Volgenant, "A shortest augmenting path algorithm",
 * Computing 38, 1987), O(rows² · columns).
 */
final class Assignment {
  private static final int NONE = -1;

  private Assignment() {}

  /**
   * Column assigned to each row, all different.
   *
   * @param cost finite; at least as many columns as rows
   */
  static int[] of(double[][] cost) {
    int rows = cost.length;
    int columns = rows == 0 ? 0 : cost[0].length;
    double[] rowPotential = new double[rows];
    double[] columnPotential = new double[columns];
    int[] rowOf = new int[columns];
    Arrays.fill(rowOf, NONE);
    for (int row = 0; row < rows; row++) {
      augment(cost, row, rowPotential, columnPotential, rowOf);
    }
    int[] columnOf = new int[rows];
    for (int column = 0; column < columns; column++) {
      if (rowOf[column] != NONE) {
        columnOf[rowOf[column]] = column;
      }
    }
    return columnOf;
  }

  /** Finds the cheapest augmenting path from a row to a free column. */
  private static void augment(
      double[][] cost, int start, double[] rowPotential, double[] columnPotential, int[] rowOf) {
    int columns = columnPotential.length;
    double[] distance = new double[columns];
    Arrays.fill(distance, Double.POSITIVE_INFINITY);
    int[] before = new int[columns]; // previous column on the path, NONE at the start
    boolean[] done = new boolean[columns];
    int row = start;
    int column = NONE;
    double length = 0.0;
    do {
      int nearest = NONE;
      for (int each = 0; each < columns; each++) {
        if (done[each]) {
          continue;
        }
        double through = length + cost[row][each] - rowPotential[row] - columnPotential[each];
        if (through < distance[each]) {
          distance[each] = through;
          before[each] = column;
        }
        if (nearest == NONE || distance[each] < distance[nearest]) {
          nearest = each;
        }
      }
      column = nearest;
      length = distance[column];
      done[column] = true;
      row = rowOf[column];
    } while (row != NONE);
    rowPotential[start] += length;
    for (int each = 0; each < columns; each++) {
      if (done[each] && each != column) {
        rowPotential[rowOf[each]] += length - distance[each];
        columnPotential[each] -= length - distance[each];
      }
    }
    while (column != NONE) {
      int previous = before[column];
      rowOf[column] = previous == NONE ? start : rowOf[previous];
      column = previous;
    }
  }
}
