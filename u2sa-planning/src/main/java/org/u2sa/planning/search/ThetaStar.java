package org.u2sa.planning.search;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * Cheapest any-angle path through a {@link CostGrid}: Lazy Theta* (Nash, Koenig, Tovey: Lazy
 * Theta*: Any-Angle Path Planning and Path Length Analysis in 3D, AAAI 2010; Daniel, Nash, Koenig,
 * Felner: Theta*: Any-Angle Path Planning on Grids, JAIR 39, 2010), with costs. If a goal lies
 * outside the grid, the path ends at the edge cell from which the straight-line remainder is
 * cheapest.
 *
 * <p>Not thread-safe; memory is reused for successive searches.
 */
public final class ThetaStar {
  private static final double DIAGONAL = Math.sqrt(2.0);
  private static final int OUTSIDE = -1; // the goal, beyond the edge
  private static final int[] DROW = {1, 0, -1, 0, 1, 1, -1, -1};
  private static final int[] DCOLUMN = {0, 1, 0, -1, 1, -1, 1, -1};

  private final boolean anyAngle;
  private double[] g = new double[0];
  private int[] parent = new int[0];
  private int[] closed = new int[0]; // number of the search that closed the cell
  private int[] known = new int[0]; // number of the search that assigned it a g
  private PairHeap open = new PairHeap(0);
  private int search;

  public ThetaStar() {
    this(true);
  }

  /**
   * @param anyAngle false: legs between neighbouring cells, plain A* (Hart, Nilsson, Raphael 1968)
   */
  ThetaStar(boolean anyAngle) {
    this.anyAngle = anyAngle;
  }

  /**
   * Finds the cheapest path.
   *
   * @param start index of a free cell
   * @param goalNorthM the goal, in a free cell or outside the grid
   * @return corners of the path from the start cell's centre to the goal cell's, or to the edge
   *     where the path leaves the grid, and its cost; empty if none
   */
  public Optional<GridPath> plan(CostGrid grid, int start, double goalNorthM, double goalEastM) {
    begin(grid.frame().cells());
    GridFrame frame = grid.frame();
    int goal = frame.indexAt(goalNorthM, goalEastM);
    reach(
        start,
        start,
        0.0,
        length(frame.centreNorthM(start) - goalNorthM, frame.centreEastM(start) - goalEastM));
    double best = Double.POSITIVE_INFINITY; // cost to a goal outside
    int exit = OUTSIDE;
    while (!open.isEmpty() && open.firstKey() < best) {
      int cell = open.first();
      open.remove(cell);
      if (settle(grid, cell, goalNorthM, goalEastM)) {
        continue; // costs more than assumed; it was requeued
      }
      closed[cell] = search;
      if (cell == goal) {
        return Optional.of(path(frame, cell, g[cell]));
      }
      int row = cell / frame.columns();
      int column = cell % frame.columns();
      if (goal < 0 && isEdge(frame, row, column)) {
        double rest =
            grid.beyondM(frame.centreNorthM(cell), frame.centreEastM(cell), goalNorthM, goalEastM);
        if (g[cell] + rest < best) {
          best = g[cell] + rest;
          exit = cell;
        }
      }
      for (int k = 0; k < 8; k++) {
        if (frame.contains(row + DROW[k], column + DCOLUMN[k])) {
          visit(grid, cell, frame.index(row + DROW[k], column + DCOLUMN[k]), goalNorthM, goalEastM);
        }
      }
    }
    return exit == OUTSIDE ? Optional.empty() : Optional.of(path(frame, exit, best));
  }

  private void begin(int cells) {
    if (g.length != cells) {
      g = new double[cells];
      parent = new int[cells];
      closed = new int[cells];
      known = new int[cells];
      open = new PairHeap(cells);
      search = 0;
    }
    open.clear();
    search++;
  }

  private void reach(int cell, int from, double cost, double rest) {
    known[cell] = search;
    g[cell] = cost;
    parent[cell] = from;
    open.put(cell, cost + rest, 0.0);
  }

  /**
   * Computes the actual cost of a cell via its parent or a neighbour (algorithm 2, SetVertex).
   *
   * @return whether it costs more than the next queued cell and so was requeued
   */
  private boolean settle(CostGrid grid, int cell, double goalNorth, double goalEast) {
    int from = parent[cell];
    if (!anyAngle || from == cell) {
      return false;
    }
    GridFrame frame = grid.frame();
    double cost =
        isNeighbour(frame, cell, from)
            ? g[from] + step(grid, from, cell)
            : g[from]
                + grid.straightCost(
                    frame.centreNorthM(from),
                    frame.centreEastM(from),
                    frame.centreNorthM(cell),
                    frame.centreEastM(cell));
    int row = cell / frame.columns();
    int column = cell % frame.columns();
    for (int k = 0; k < 8; k++) {
      if (frame.contains(row + DROW[k], column + DCOLUMN[k])) {
        int near = frame.index(row + DROW[k], column + DCOLUMN[k]);
        if (closed[near] == search) {
          double along = g[near] + step(grid, near, cell);
          if (along < cost) {
            cost = along;
            from = near;
          }
        }
      }
    }
    double grown = cost - g[cell];
    g[cell] = cost;
    parent[cell] = from;
    double rest = length(frame.centreNorthM(cell) - goalNorth, frame.centreEastM(cell) - goalEast);
    if (grown > 1.0e-9 && !open.isEmpty() && cost + rest > open.firstKey()) {
      open.put(cell, cost + rest, 0.0);
      return true;
    }
    return false;
  }

  private void visit(CostGrid grid, int cell, int next, double goalNorth, double goalEast) {
    if (closed[next] == search || !grid.isFree(next) || grid.isClosed(cell, next)) {
      return;
    }
    GridFrame frame = grid.frame();
    int from = anyAngle ? parent[cell] : cell;
    double cost =
        anyAngle
            // optimistic: assumes line of sight and free space
            ? g[from] + distanceM(frame, from, next)
            : g[cell] + step(grid, cell, next);
    if (known[next] != search || cost < g[next] - 1.0e-12) {
      double rest =
          length(frame.centreNorthM(next) - goalNorth, frame.centreEastM(next) - goalEast);
      reach(next, from, cost, rest);
    }
  }

  private static double distanceM(GridFrame frame, int a, int b) {
    return frame.cellM()
        * length(
            a / frame.columns() - b / frame.columns(), a % frame.columns() - b % frame.columns());
  }

  /** Length of a vector; Math.hypot also guards against overflow, but is many times slower. */
  private static double length(double north, double east) {
    return Math.sqrt(north * north + east * east);
  }

  private static boolean isNeighbour(GridFrame frame, int a, int b) {
    return Math.abs(a / frame.columns() - b / frame.columns()) <= 1
        && Math.abs(a % frame.columns() - b % frame.columns()) <= 1;
  }

  private static boolean isEdge(GridFrame frame, int row, int column) {
    return row == 0 || column == 0 || row == frame.rows() - 1 || column == frame.columns() - 1;
  }

  /**
   * Cost from a cell to its neighbour: the mean of both costs times the distance of their centres;
   * infinite between two cells where the vehicle would collide.
   */
  private static double step(CostGrid grid, int from, int to) {
    if (grid.isClosed(from, to)) {
      return Double.POSITIVE_INFINITY;
    }
    int columns = grid.frame().columns();
    boolean diagonal = from / columns != to / columns && from % columns != to % columns;
    return 0.5
        * (grid.cost(from) + grid.cost(to))
        * grid.frame().cellM()
        * (diagonal ? DIAGONAL : 1.0);
  }

  private GridPath path(GridFrame frame, int end, double cost) {
    List<GridPath.Corner> corners = new ArrayList<>();
    int cell = end;
    while (true) {
      corners.add(new GridPath.Corner(frame.centreNorthM(cell), frame.centreEastM(cell)));
      if (parent[cell] == cell) {
        break;
      }
      cell = parent[cell];
    }
    Collections.reverse(corners);
    return new GridPath(corners, cost);
  }
}
