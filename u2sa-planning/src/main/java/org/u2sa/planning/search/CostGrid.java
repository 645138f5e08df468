package org.u2sa.planning.search;

import java.nio.FloatBuffer;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.IntPredicate;

/**
 * Traversal cost of each cell: 1 per metre in the open, more near obstacles, infinite where the
 * vehicle would collide. Outside the grid, space is assumed free, except for {@link #leadOn}.
 *
 * <p>Not thread-safe.
 */
public final class CostGrid {
  /** Extra cost of unknown cells compared with cells seen to be free. */
  private static final float UNKNOWN_COST = 0.3f;

  private static final double TOWARDS = 0.5; // weight of the distance from a place

  /**
   * Points closer than this to a cell corner do not belong to any one cell unambiguously [cells].
   */
  private static final double CORNER = 1.0e-6;

  /** Flag of a cell's state: occupied; 0: seen to be free. */
  public static final byte OCCUPIED = DistanceField.OCCUPIED;

  /** Flag of a cell's state: never seen. May be combined with {@link #OCCUPIED}. */
  public static final byte UNKNOWN = 2;

  /** Rectangle of cells, bounds inclusive. */
  public record Area(int firstRow, int firstColumn, int lastRow, int lastColumn) {}

  private final GridFrame frame;
  private final Inflation inflation;
  private final byte[] states;
  private final float[] cost;
  private final DistanceField distances;
  private final float[] costAt; // cost of a seen cell, by squared distance
  private final int[] changedAt; // by row: newest revision that may have changed a cost
  private final PassedGround passed;
  private int revision;
  private Optional<WayBeyond> beyond = Optional.empty(); // straight

  public CostGrid(GridFrame frame, Inflation inflation) {
    this.frame = frame;
    this.inflation = inflation;
    states = new byte[frame.cells()];
    cost = new float[frame.cells()];
    changedAt = new int[frame.rows()];
    passed = new PassedGround(frame);
    Arrays.fill(cost, 1.0f);
    int reach = (int) Math.ceil(inflation.reachM() / frame.cellM()) + 1;
    distances = new DistanceField(frame.rows(), frame.columns(), reach);
    costAt = new float[reach * reach + 1];
    for (int square = 0; square < costAt.length; square++) {
      costAt[square] = (float) inflation.cost(metres(DistanceField.root(square)));
    }
  }

  public GridFrame frame() {
    return frame;
  }

  public Inflation inflation() {
    return inflation;
  }

  /**
   * Sets the ways to a goal outside the grid, from its edge; empty if they are straight.
   *
   * @return whether they were others before
   */
  public boolean leadOn(Optional<WayBeyond> ways) {
    boolean isOther = !ways.equals(beyond);
    beyond = ways;
    return isOther;
  }

  /** Whether ways to the goal may lead around something outside the grid. */
  public boolean leadsAround() {
    return beyond.isPresent();
  }

  Optional<WayBeyond> beyond() {
    return beyond;
  }

  /** Whether there is a way from a point to a goal outside the grid. */
  public boolean leadsOn(double northM, double eastM) {
    return beyond.map(way -> way.reaches(northM, eastM)).orElse(true);
  }

  /** Length of the way from a point to a goal outside the grid [m]. */
  public double beyondM(double northM, double eastM, double goalNorthM, double goalEastM) {
    if (beyond.isPresent()) {
      return beyond.get().lengthM(northM, eastM);
    }
    double north = goalNorthM - northM; // Math.hypot is many times slower
    double east = goalEastM - eastM;
    return Math.sqrt(north * north + east * east);
  }

  /**
   * Updates which cells are occupied and which were never seen, and recomputes affected costs.
   *
   * @return the cells whose cost may have changed; null if none
   */
  public Area update(IntPredicate isOccupied, IntPredicate isUnknown) {
    byte[] newStates = new byte[states.length];
    for (int i = 0; i < newStates.length; i++) {
      newStates[i] =
          (byte) ((isOccupied.test(i) ? OCCUPIED : 0) | (isUnknown.test(i) ? UNKNOWN : 0));
    }
    return update(newStates);
  }

  /**
   * Like {@link #update(IntPredicate, IntPredicate)}, with the state of every cell: {@link
   * #OCCUPIED}, {@link #UNKNOWN}, both or neither.
   */
  public Area update(byte[] newStates) {
    Changes changes = new Changes();
    RowChange change = new RowChange();
    for (int row = 0; row < frame.rows(); row++) {
      int begin = frame.index(row, 0);
      if (change.find(states, newStates, begin, frame.columns())) {
        boolean stands = false;
        for (int i = begin + change.first(); i <= begin + change.last(); i++) {
          stands |= ((states[i] ^ newStates[i]) & OCCUPIED) != 0;
        }
        changes.add(row, change.first(), change.last(), stands);
        int length = change.last() - change.first() + 1;
        System.arraycopy(newStates, begin + change.first(), states, begin + change.first(), length);
      }
    }
    return changes.compute();
  }

  /**
   * The cells whose state has changed. Distances are recomputed only around cells that became
   * occupied or free: most changes are cells seen for the first time.
   */
  private final class Changes {
    private final int[] first = new int[frame.rows()]; // first column of changed costs, by row
    private final int[] last = new int[frame.rows()];
    private final Span occupied = new Span();

    Changes() {
      Arrays.fill(first, frame.columns());
      Arrays.fill(last, -1);
    }

    void add(int row, int from, int to, boolean stands) {
      concern(row, from, to);
      if (stands) {
        occupied.add(row, from, to);
      }
    }

    private void concern(int row, int from, int to) {
      first[row] = Math.min(first[row], from);
      last[row] = Math.max(last[row], to);
    }

    /**
     * Computes the costs around changed cells. Returns the cells whose cost may have changed; null
     * if none.
     */
    Area compute() {
      if (!occupied.isEmpty()) {
        int[] near =
            distances.update(states, occupied.top, occupied.left, occupied.bottom, occupied.right);
        for (int row = near[0]; row <= near[2]; row++) {
          concern(row, near[1], near[3]);
        }
      }
      revision++;
      Span all = new Span();
      for (int row = 0; row < frame.rows(); row++) {
        if (first[row] <= last[row]) {
          all.add(row, first[row], last[row]);
          compute(row);
        }
      }
      return all.isEmpty() ? null : new Area(all.top, all.left, all.bottom, all.right);
    }

    private void compute(int row) {
      changedAt[row] = revision;
      for (int i = frame.index(row, first[row]); i <= frame.index(row, last[row]); i++) {
        cost[i] = costAt[distances.square(i)] + (isUnknown(i) ? UNKNOWN_COST : 0.0f);
      }
    }
  }

  private static final class Span {
    private int top = Integer.MAX_VALUE;
    private int left = Integer.MAX_VALUE;
    private int bottom = -1;
    private int right = -1;

    void add(int row, int first, int last) {
      top = Math.min(top, row);
      bottom = Math.max(bottom, row);
      left = Math.min(left, first);
      right = Math.max(right, last);
    }

    boolean isEmpty() {
      return bottom < 0;
    }
  }

  public boolean isOccupied(int index) {
    return (states[index] & OCCUPIED) != 0;
  }

  /** Whether a cell was never seen. */
  public boolean isUnknown(int index) {
    return (states[index] & UNKNOWN) != 0;
  }

  /** Ground on which the vehicle has been. */
  public PassedGround passed() {
    return passed;
  }

  /** Whether the cell of a point was neither seen nor passed; false outside. */
  public boolean isUnseen(double northM, double eastM) {
    int cell = frame.indexAt(northM, eastM);
    return cell >= 0 && isUnknown(cell) && !passed.contains(cell);
  }

  /** Whether the vehicle's centre may be in a cell. */
  public boolean isFree(int index) {
    return cost[index] < Float.POSITIVE_INFINITY;
  }

  /** Whether a step leads diagonally between two cells where the vehicle would collide. */
  boolean isClosed(int from, int to) {
    int columns = frame.columns();
    int aside = to % columns - from % columns;
    return aside != 0
        && from / columns != to / columns
        && !isFree(from + aside)
        && !isFree(to - aside);
  }

  /** Cost per metre in a cell, at least 1; infinite if impassable. */
  public float cost(int index) {
    return cost[index];
  }

  int revision() {
    return revision;
  }

  /** Whether a cost of a row of cells may have changed since a revision. */
  boolean hasChanged(int row, int since) {
    return changedAt[row] > since;
  }

  /** Costs of consecutive cells, starting at an index; read-only. */
  FloatBuffer costs(int from, int length) {
    return FloatBuffer.wrap(cost, from, length);
  }

  /** Distance of a cell's centre from the nearest occupied cell's edge [m], up to the reach. */
  public double distanceM(int index) {
    return metres(distances.cells(index));
  }

  private double metres(float cells) {
    return Math.max(0.0, cells - 0.5) * frame.cellM();
  }

  /** Distance of a point to the nearest occupied cell [m]; the reach outside the grid. */
  public double distanceM(double northM, double eastM) {
    int index = frame.indexAt(northM, eastM);
    return index < 0 ? inflation.reachM() : distanceM(index);
  }

  /** Cost per metre at a point; 1 outside. */
  public double cost(double northM, double eastM) {
    return costIn(frame.indexAt(northM, eastM));
  }

  /** Length of a straight path weighted by the local cost [m]; infinite if impassable. */
  public double straightCost(double north, double east, double toNorth, double toEast) {
    double length =
        Math.sqrt((toNorth - north) * (toNorth - north) + (toEast - east) * (toEast - east));
    int steps = Math.max(1, (int) Math.ceil(length / (0.5 * frame.cellM())));
    double little = length > 0.0 ? CORNER * frame.cellM() / length : 0.0; // fraction of the path
    double[] inside = frame.sharesInside(north, east, toNorth, toEast);
    int first = (int) Math.max(0.0, Math.min(steps, inside[0] * steps - 2.0));
    int last = (int) Math.max(first, Math.min(steps, inside[1] * steps + 2.0));
    double sum = steps - (last - first); // outside
    int before = -1;
    for (int k = first; k < last; k++) {
      double share = (k + 0.5) / steps;
      int cell = frame.indexAt(north + share * (toNorth - north), east + share * (toEast - east));
      if (costIn(cell) == Double.POSITIVE_INFINITY) { // on a corner
        double to = share + little;
        double from = share - little;
        before = frame.indexAt(north + from * (toNorth - north), east + from * (toEast - east));
        cell = frame.indexAt(north + to * (toNorth - north), east + to * (toEast - east));
      }
      double here = Math.max(costIn(before), costIn(cell));
      boolean isNext = before >= 0 && cell >= 0 && before != cell;
      if (here == Double.POSITIVE_INFINITY || isNext && isClosed(before, cell)) {
        return Double.POSITIVE_INFINITY;
      }
      sum += costIn(cell);
      before = cell;
    }
    return sum * length / steps;
  }

  /** Cost per metre in a cell; 1 outside, i.e. for -1. */
  private double costIn(int cell) {
    return cell < 0 ? 1.0 : cost[cell];
  }

  /**
   * Whether a vehicle in closed cells can leave them on a straight way, instead of through what
   * stands: it fits everywhere, or comes no nearer to anything than it is.
   *
   * @param halfWidthM half of the vehicle's width [m]
   */
  public boolean leadsOut(
      double north, double east, double toNorth, double toEast, double halfWidthM) {
    int here = frame.indexAt(north, east);
    if (here < 0 || distanceM(here) == 0.0) {
      return true;
    }
    double leastM = Math.max(0.0, Math.min(halfWidthM, distanceM(here)) - frame.cellM());
    int steps = (int) Math.ceil(Math.hypot(toNorth - north, toEast - east) / (0.5 * frame.cellM()));
    for (int k = 1; k <= steps; k++) {
      double share = (double) k / steps;
      int cell = frame.indexAt(north + share * (toNorth - north), east + share * (toEast - east));
      if (cell >= 0 && distanceM(cell) <= leastM) {
        return false;
      }
    }
    return true;
  }

  /**
   * Free cell nearest to a vehicle within a distance, to which a straight way {@link #leadsOut}; −1
   * if none.
   */
  public int nearestWayOut(double northM, double eastM, double withinM, double halfWidthM) {
    int here = frame.indexAt(northM, eastM);
    if (here >= 0 && isFree(here)) {
      return here;
    }
    return nearestFree(
        northM,
        eastM,
        withinM,
        northM,
        eastM,
        0.0,
        cell ->
            leadsOut(northM, eastM, frame.centreNorthM(cell), frame.centreEastM(cell), halfWidthM));
  }

  /** Free cell nearest to a point within a distance; −1 if none. */
  public int nearestFree(double northM, double eastM, double withinM) {
    return nearestFree(northM, eastM, withinM, northM, eastM, 0.0, cell -> true);
  }

  /**
   * Free cell near a point, on the side of another place: of cells at equal distances from the
   * point, that nearest to the place.
   *
   * @param withinM maximum distance from the point [m]
   * @return −1 if none
   */
  public int nearestFreeTowards(
      double northM, double eastM, double withinM, double placeNorthM, double placeEastM) {
    return nearestFree(northM, eastM, withinM, placeNorthM, placeEastM, TOWARDS, cell -> true);
  }

  private int nearestFree(
      double northM,
      double eastM,
      double withinM,
      double placeNorthM,
      double placeEastM,
      double weight,
      IntPredicate isAllowed) {
    int row = frame.row(northM);
    int column = frame.column(eastM);
    int span = (int) Math.ceil(withinM / frame.cellM()) + 1;
    int best = -1;
    double least = Double.POSITIVE_INFINITY;
    for (int r = Math.max(0, row - span); r <= Math.min(frame.rows() - 1, row + span); r++) {
      for (int c = Math.max(0, column - span);
          c <= Math.min(frame.columns() - 1, column + span);
          c++) {
        int i = frame.index(r, c);
        double north = frame.centreNorthM(i);
        double east = frame.centreEastM(i);
        double away = Math.hypot(north - northM, east - eastM);
        double sum =
            weight == 0.0
                ? away
                : away + weight * Math.hypot(north - placeNorthM, east - placeEastM);
        if (isFree(i) && away <= withinM && sum < least && isAllowed.test(i)) {
          best = i;
          least = sum;
        }
      }
    }
    return best;
  }
}
