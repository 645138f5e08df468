package org.u2sa.planning.search;

import java.nio.FloatBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;

/**
 * Cheapest path through a {@link CostGrid} that changes while the vehicle moves: D* Lite (Koenig,
 * Likhachev: D* Lite, AAAI 2002, figure 4). It searches from the goal, keeps its results, and
 * repairs only what a change affects. Legs connect neighbouring cells; the path is then
 * straightened where that costs no more.
 *
 * <p>If the goal lies outside the grid, every edge cell is a goal, at the cost of the straight-line
 * remainder or, if the grid has them, of the {@link WayBeyond}. Not thread-safe.
 */
public final class DStarLite {
  private static final double DIAGONAL = Math.sqrt(2.0);
  private static final double NEVER = Double.POSITIVE_INFINITY;
  private static final double ROUNDING = 1.0e-6; // for float sums in a different order
  private static final int BLOCK = 64; // costs compared at once
  private static final double SAME_GOAL = 0.01; // fraction of a cell, because goals jitter

  private final CostGrid grid;
  private final GridFrame frame;
  final double goalNorthM;
  final double goalEastM;
  private final int goal; // −1: outside
  private final Optional<WayBeyond> beyond; // as of the last search
  private final float[] cost; // as of the last search
  private final double[] g;
  private final double[] rhs;
  private final PairHeap open;
  private final BitSet changed = new BitSet(); // cells whose cost has changed since
  private final BitSet taken = new BitSet(); // changed cells and neighbours already updated
  private int revision; // revision of the grid's costs, as of the last search
  private double km;
  private int start = -1;
  private int startRow;
  private int startColumn;
  private int last = -1;
  private int expanded;

  /** Creates a search to a goal, which is in a free cell or outside the grid. */
  public DStarLite(CostGrid grid, double goalNorthM, double goalEastM) {
    this.grid = grid;
    frame = grid.frame();
    this.goalNorthM = goalNorthM;
    this.goalEastM = goalEastM;
    goal = frame.indexAt(goalNorthM, goalEastM);
    beyond = grid.beyond();
    cost = new float[frame.cells()];
    g = new double[frame.cells()];
    rhs = new double[frame.cells()];
    open = new PairHeap(frame.cells());
  }

  /** Whether it searches this grid for a path to this goal, or to another point in its cell. */
  public boolean isFor(CostGrid costs, double north, double east) {
    boolean isThere =
        goal >= 0
            ? frame.indexAt(north, east) == goal
            : beyond.equals(costs.beyond())
                && Math.abs(north - goalNorthM) <= SAME_GOAL * frame.cellM()
                && Math.abs(east - goalEastM) <= SAME_GOAL * frame.cellM();
    return grid == costs && isThere;
  }

  /** Number of cells expanded by the last search. */
  public int expanded() {
    return expanded;
  }

  /** Finds the cheapest path in the current grid from a free cell. */
  public Optional<GridPath> plan(int from) {
    expanded = 0;
    boolean first = last < 0;
    start = from;
    startRow = from / frame.columns();
    startColumn = from % frame.columns();
    if (first) {
      begin();
    } else {
      km += h(last / frame.columns(), last % frame.columns());
      takeChanges();
    }
    last = start;
    computeShortestPath();
    return rhs[start] == NEVER && g[start] == NEVER ? Optional.empty() : path();
  }

  private void begin() {
    Arrays.fill(g, NEVER);
    Arrays.fill(rhs, NEVER);
    for (int i = 0; i < cost.length; i++) {
      cost[i] = grid.cost(i);
    }
    revision = grid.revision();
    if (goal >= 0) {
      seed(goal / frame.columns(), goal % frame.columns());
      return;
    }
    for (int row = 0; row < frame.rows(); row++) {
      boolean edge = row == 0 || row == frame.rows() - 1;
      for (int c = 0; c < frame.columns(); c += edge ? 1 : Math.max(1, frame.columns() - 1)) {
        seed(row, c);
      }
    }
  }

  private void seed(int row, int column) {
    int cell = frame.index(row, column);
    if (cost[cell] < NEVER) {
      rhs[cell] = terminal(cell, row, column);
      open.put(cell, rhs[cell] + h(row, column), rhs[cell]);
    }
  }

  /** Remaining cost from a cell in which paths may end; infinite for all others. */
  private double terminal(int cell, int row, int column) {
    if (goal >= 0) {
      return cell == goal ? 0.0 : NEVER;
    }
    boolean edge =
        row == 0 || column == 0 || row == frame.rows() - 1 || column == frame.columns() - 1;
    return edge
        ? grid.beyondM(frame.centreNorthM(cell), frame.centreEastM(cell), goalNorthM, goalEastM)
        : NEVER;
  }

  /** Updates cells whose costs have changed since the last search, and their neighbours. */
  private void takeChanges() {
    findChanges();
    for (int cell = changed.nextSetBit(0); cell >= 0; cell = changed.nextSetBit(cell + 1)) {
      int row = cell / frame.columns();
      int column = cell % frame.columns();
      for (int r = Math.max(0, row - 1); r <= Math.min(frame.rows() - 1, row + 1); r++) {
        for (int c = Math.max(0, column - 1); c <= Math.min(frame.columns() - 1, column + 1); c++) {
          int near = frame.index(r, c);
          if (!taken.get(near)) {
            taken.set(near);
            rhs[near] = cost[near] == NEVER ? NEVER : best(near, r, c);
            updateVertex(near, r, c);
          }
        }
      }
    }
    changed.clear();
    taken.clear();
  }

  /** Finds changed costs in rows that may contain any. */
  private void findChanges() {
    for (int row = 0; row < frame.rows(); row++) {
      if (grid.hasChanged(row, revision)) {
        findChanges(row);
      }
    }
    revision = grid.revision();
  }

  /** Compares costs blockwise, then cell by cell in blocks that differ. */
  private void findChanges(int row) {
    int end = frame.index(row, frame.columns());
    for (int from = frame.index(row, 0); from < end; from += BLOCK) {
      int length = Math.min(BLOCK, end - from);
      if (!FloatBuffer.wrap(cost, from, length).equals(grid.costs(from, length))) {
        for (int i = from; i < from + length; i++) {
          if (cost[i] != grid.cost(i)) {
            cost[i] = grid.cost(i);
            changed.set(i);
          }
        }
      }
    }
  }

  private void updateVertex(int cell, int row, int column) {
    if (g[cell] != rhs[cell]) {
      double now = Math.min(g[cell], rhs[cell]);
      open.put(cell, now + h(row, column) + km, now);
    } else {
      open.remove(cell);
    }
  }

  private void computeShortestPath() {
    while (!open.isEmpty()) {
      double least = Math.min(g[start], rhs[start]);
      boolean settled = rhs[start] == g[start] && rhs[start] < NEVER;
      if (settled && !open.isBefore(least + km + ROUNDING, NEVER)) {
        return; // ties are also expanded, because the extracted path uses such cells
      }
      int cell = open.first();
      int row = cell / frame.columns();
      int column = cell % frame.columns();
      double now = Math.min(g[cell], rhs[cell]);
      double key = now + h(row, column) + km;
      if (open.firstKey() < key - ROUNDING) {
        open.put(cell, key, now);
        continue;
      }
      expanded++;
      open.remove(cell);
      if (g[cell] > rhs[cell]) {
        g[cell] = rhs[cell];
        lower(cell, row, column);
      } else {
        double before = g[cell];
        g[cell] = NEVER;
        raise(cell, row, column, before);
      }
    }
  }

  /** Propagates a lower cost of a cell to its neighbours. */
  private void lower(int cell, int row, int column) {
    for (int r = Math.max(0, row - 1); r <= Math.min(frame.rows() - 1, row + 1); r++) {
      for (int c = Math.max(0, column - 1); c <= Math.min(frame.columns() - 1, column + 1); c++) {
        int near = frame.index(r, c);
        if (near != cell && cost[near] < NEVER) {
          double through = g[cell] + step(cell, near, r != row && c != column);
          if (through < rhs[near]) {
            rhs[near] = through;
            updateVertex(near, r, c);
          }
        }
      }
    }
  }

  /** Propagates a cost increase of a cell to the cells whose paths lead through it. */
  private void raise(int cell, int row, int column, double before) {
    for (int r = Math.max(0, row - 1); r <= Math.min(frame.rows() - 1, row + 1); r++) {
      for (int c = Math.max(0, column - 1); c <= Math.min(frame.columns() - 1, column + 1); c++) {
        int near = frame.index(r, c);
        double through = near == cell ? NEVER : before + step(cell, near, r != row && c != column);
        if (near == cell || Math.abs(rhs[near] - through) <= ROUNDING) {
          rhs[near] = cost[near] == NEVER ? NEVER : best(near, r, c);
        }
        updateVertex(near, r, c);
      }
    }
  }

  private double best(int cell, int row, int column) {
    double least = terminal(cell, row, column);
    for (int r = Math.max(0, row - 1); r <= Math.min(frame.rows() - 1, row + 1); r++) {
      for (int c = Math.max(0, column - 1); c <= Math.min(frame.columns() - 1, column + 1); c++) {
        int near = frame.index(r, c);
        if (near != cell && g[near] < NEVER) {
          least = Math.min(least, g[near] + step(cell, near, r != row && c != column));
        }
      }
    }
    return least;
  }

  /** Infinite also between two cells where the vehicle would collide. */
  private double step(int a, int b, boolean diagonal) {
    double straight = 0.5 * ((double) cost[a] + cost[b]) * frame.cellM();
    if (!diagonal) {
      return straight;
    }
    int aside = b - a - (b > a ? frame.columns() : -frame.columns()); // in columns, from a to b
    boolean isClosed = cost[a + aside] == NEVER && cost[b - aside] == NEVER;
    return isClosed ? NEVER : DIAGONAL * straight;
  }

  /** Lower bound of the cost between a cell and the start: octile distance in the open [m]. */
  private double h(int row, int column) {
    int rows = Math.abs(startRow - row);
    int columns = Math.abs(startColumn - column);
    return frame.cellM() * (Math.max(rows, columns) + (DIAGONAL - 1.0) * Math.min(rows, columns));
  }

  private Optional<GridPath> path() {
    List<Integer> cells = new ArrayList<>();
    List<Double> togo = new ArrayList<>();
    int cell = start;
    double total = rhs[start];
    while (cell >= 0 && cells.size() <= frame.cells()) {
      cells.add(cell);
      togo.add(Math.min(g[cell], rhs[cell]));
      if (terminal(cell, cell / frame.columns(), cell % frame.columns())
          <= Math.min(g[cell], rhs[cell]) + ROUNDING) {
        return Optional.of(new GridPath(straightened(cells, togo), total));
      }
      cell = next(cell);
    }
    return Optional.empty();
  }

  private int next(int cell) {
    int row = cell / frame.columns();
    int column = cell % frame.columns();
    int best = -1;
    double least = NEVER;
    for (int r = Math.max(0, row - 1); r <= Math.min(frame.rows() - 1, row + 1); r++) {
      for (int c = Math.max(0, column - 1); c <= Math.min(frame.columns() - 1, column + 1); c++) {
        int near = frame.index(r, c);
        if (near != cell && g[near] < NEVER) {
          double through = g[near] + step(cell, near, r != row && c != column);
          if (through < least) {
            least = through;
            best = near;
          }
        }
      }
    }
    return best;
  }

  /** Removes corners where the straight path costs no more. */
  private List<GridPath.Corner> straightened(List<Integer> cells, List<Double> togo) {
    List<GridPath.Corner> corners = new ArrayList<>();
    int from = 0;
    corners.add(corner(cells.get(0)));
    while (from < cells.size() - 1) {
      int to = from + 1;
      for (int step = 1; ; ) { // exponential search for the farthest shortcut
        int farther = Math.min(cells.size() - 1, to + step);
        if (farther == to || !pays(cells, togo, from, farther)) {
          if (step == 1 || farther == to) {
            break;
          }
          step = Math.max(1, step / 2);
          continue;
        }
        to = farther;
        step *= 2;
      }
      corners.add(corner(cells.get(to)));
      from = to;
    }
    return corners;
  }

  private boolean pays(List<Integer> cells, List<Double> togo, int from, int to) {
    int a = cells.get(from);
    int b = cells.get(to);
    double straight =
        grid.straightCost(
            frame.centreNorthM(a),
            frame.centreEastM(a),
            frame.centreNorthM(b),
            frame.centreEastM(b));
    return straight <= togo.get(from) - togo.get(to) + 1.0e-3 * frame.cellM();
  }

  private GridPath.Corner corner(int cell) {
    return new GridPath.Corner(frame.centreNorthM(cell), frame.centreEastM(cell));
  }
}
