package org.u2sa.planning.hybrid;

import java.util.Arrays;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.u2sa.planning.search.CostGrid;
import org.u2sa.planning.search.GridFrame;

/**
 * Lower bound of the cost to the goal from each point of a grid, ignoring turn limits: Dijkstra's
 * search from the goal over squares of two by two cells, in buckets (Dial: Algorithm 360,
 * Communications of the ACM 12, 1969).
 *
 * <p>Not thread-safe; memory is reused for successive goals.
 */
final class CostToGo {
  private static final double DIAGONAL = Math.sqrt(2.0);
  private static final int PER_STEP = 8; // buckets for a straight step at cost 1
  private static final int STEP_BUCKETS = 512; // more than the costliest step needs
  private static final float MOST = 40.0f; // higher costs are clamped to this

  private int rows;
  private int columns;
  private float[] cost = new float[0]; // per metre
  private float[] toGo = new float[0]; // [m]
  private int[][] buckets = new int[0][]; // used cyclically
  private int[] filled = new int[0];
  private int waiting;
  private double bucketM;
  private GridFrame frame;

  /**
   * Searches from a goal; if it lies outside the grid, from the whole edge. If the goal is closed,
   * the search also starts from the free cells within the tolerance, because it would not leave the
   * obstacle.
   */
  void search(CostGrid grid, double goalNorth, double goalEast, double toleranceM) {
    prepare(grid);
    int goal = index(goalNorth, goalEast);
    Arrays.fill(filled, 0);
    waiting = 0;
    if (goal >= 0) {
      if (cost[goal] == Float.POSITIVE_INFINITY) {
        reachAround(goal, goalNorth, goalEast, toleranceM);
      }
      cost[goal] = Math.min(cost[goal], MOST); // a goal near an obstacle is still a goal
      reach(goal, 0.0f);
    } else {
      reachFromEdge(grid, goalNorth, goalEast);
    }
    spread();
  }

  private void reachFromEdge(CostGrid grid, double goalNorth, double goalEast) {
    int[] edge =
        IntStream.range(0, cost.length)
            .filter(i -> isEdge(i) && cost[i] < Float.POSITIVE_INFINITY)
            .toArray();
    double[] beyondM =
        IntStream.of(edge)
            .mapToDouble(i -> grid.beyondM(northM(i), eastM(i), goalNorth, goalEast))
            .toArray();
    double least = DoubleStream.of(beyondM).min().orElse(0.0);
    double most = DoubleStream.of(beyondM).max().orElse(0.0);
    // Entries of different laps around the buckets must not share a bucket.
    provide(STEP_BUCKETS + (int) Math.ceil((most - least) / bucketM));
    for (int i = 0; i < edge.length; i++) {
      reach(edge[i], (float) beyondM[i]);
    }
  }

  private boolean isEdge(int cell) {
    int row = cell / columns;
    int column = cell % columns;
    return row == 0 || column == 0 || row == rows - 1 || column == columns - 1;
  }

  private void provide(int needed) {
    if (buckets.length < needed) {
      buckets = new int[needed][];
      filled = new int[needed];
    }
  }

  private double northM(int cell) {
    return frame.northM() + (cell / columns + 0.5) * 2.0 * frame.cellM();
  }

  private double eastM(int cell) {
    return frame.eastM() + (cell % columns + 0.5) * 2.0 * frame.cellM();
  }

  private void reachAround(int goal, double goalNorth, double goalEast, double toleranceM) {
    int most = (int) Math.ceil(toleranceM / (2.0 * frame.cellM()));
    int goalRow = goal / columns;
    int goalColumn = goal % columns;
    int lastRow = Math.min(rows - 1, goalRow + most);
    int lastColumn = Math.min(columns - 1, goalColumn + most);
    for (int row = Math.max(0, goalRow - most); row <= lastRow; row++) {
      for (int column = Math.max(0, goalColumn - most); column <= lastColumn; column++) {
        int i = row * columns + column;
        float metres = (float) Math.hypot(northM(i) - goalNorth, eastM(i) - goalEast);
        if (metres <= toleranceM && cost[i] < Float.POSITIVE_INFINITY) {
          reach(i, metres);
        }
      }
    }
  }

  private void prepare(CostGrid grid) {
    frame = grid.frame();
    rows = (frame.rows() + 1) / 2;
    columns = (frame.columns() + 1) / 2;
    if (cost.length != rows * columns) {
      cost = new float[rows * columns];
      toGo = new float[rows * columns];
    }
    provide(STEP_BUCKETS + (int) Math.ceil(PER_STEP * Math.hypot(rows, columns)));
    bucketM = 2.0 * frame.cellM() / PER_STEP;
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        float least = Float.POSITIVE_INFINITY;
        for (int r = 2 * row; r < Math.min(frame.rows(), 2 * row + 2); r++) {
          for (int c = 2 * column; c < Math.min(frame.columns(), 2 * column + 2); c++) {
            least = Math.min(least, grid.cost(frame.index(r, c)));
          }
        }
        cost[row * columns + column] =
            least == Float.POSITIVE_INFINITY ? least : Math.min(least, MOST);
      }
    }
    Arrays.fill(toGo, Float.POSITIVE_INFINITY);
  }

  private void reach(int cell, float metres) {
    if (metres >= toGo[cell]) {
      return;
    }
    toGo[cell] = metres;
    int bucket = (int) (metres / bucketM) % buckets.length;
    if (buckets[bucket] == null) {
      buckets[bucket] = new int[64];
    } else if (filled[bucket] == buckets[bucket].length) {
      buckets[bucket] = Arrays.copyOf(buckets[bucket], 2 * filled[bucket]);
    }
    buckets[bucket][filled[bucket]++] = cell;
    waiting++;
  }

  private void spread() {
    long bucket = firstBucket();
    double step = 2.0 * frame.cellM();
    while (waiting > 0) {
      int at = (int) (bucket % buckets.length);
      while (filled[at] > 0) {
        int cell = buckets[at][--filled[at]];
        waiting--;
        if ((long) (toGo[cell] / bucketM) != bucket) {
          continue; // has since been reached at lower cost
        }
        int row = cell / columns;
        int column = cell % columns;
        for (int r = Math.max(0, row - 1); r <= Math.min(rows - 1, row + 1); r++) {
          for (int c = Math.max(0, column - 1); c <= Math.min(columns - 1, column + 1); c++) {
            int next = r * columns + c;
            if (cost[next] < Float.POSITIVE_INFINITY && next != cell) {
              double length = r != row && c != column ? DIAGONAL * step : step;
              reach(next, (float) (toGo[cell] + 0.5 * (cost[cell] + cost[next]) * length));
            }
          }
        }
      }
      bucket++;
    }
  }

  /** For a goal outside the grid, far edges do not start with bucket 0. */
  private long firstBucket() {
    float least = Float.POSITIVE_INFINITY;
    for (float metres : toGo) {
      least = Math.min(least, metres);
    }
    return least == Float.POSITIVE_INFINITY ? 0L : (long) (least / bucketM);
  }

  private int index(double north, double east) {
    if (!frame.contains(north, east)) {
      return -1;
    }
    return frame.row(north) / 2 * columns + frame.column(east) / 2;
  }

  /** Lower bound of the cost from a point on the grid [m]; infinite if there is no path. */
  double metres(double north, double east) {
    int i = index(north, east);
    return i < 0 ? Double.POSITIVE_INFINITY : toGo[i];
  }
}
