package org.u2sa.planning.seen;

import java.util.BitSet;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import org.u2sa.planning.search.GridFrame;
import org.u2sa.planning.search.WayBeyond;

/**
 * Ground between the window for which routes are planned and a goal outside it, and around both: it
 * determines which edge of the window leads to the goal. Ground beyond the map is taken to be as at
 * the map's edge. Confined to the planner's thread.
 */
final class FarGround {
  private static final int CELLS = 200; // in each direction
  private static final double BESIDE = 2.0; // reach beside vehicle and goal [spans of the window]

  private GridFrame frame; // null: nothing has been read yet
  private double goalNorthM;
  private double goalEastM;
  private float[] downs; // of the ground, by cell [m]; NaN: unknown
  private FlightProfile profile; // of the way
  private Optional<WayBeyond> way = Optional.empty();

  /**
   * The way around ground that is too high; empty if none is, so that all ways are straight.
   *
   * @param ground down coordinate of the ground at north and east [m]; NaN if unknown
   * @param window cells for which routes are planned
   */
  Optional<WayBeyond> way(
      FlightProfile flown,
      DoubleBinaryOperator ground,
      GridFrame window,
      double northM,
      double eastM) {
    boolean isRead = frame != null && isFor(northM, eastM) && contains(window);
    if (isRead && flown.equals(profile)) {
      return way;
    }
    if (!isRead) {
      read(ground, window, northM, eastM);
    }
    BitSet high = new BitSet();
    for (int i = 0; i < downs.length; i++) {
      high.set(
          i,
          flown.isTooHigh(
              frame.centreNorthM(i), frame.centreEastM(i), downs[i] + GroundLayer.ROUNDING_M));
    }
    if (high.isEmpty()) {
      way = Optional.empty();
    } else if (!isRead || way.isEmpty() || !way.get().isAround(high)) {
      way = Optional.of(new WayBeyond(frame, high, goalNorthM, goalEastM));
    }
    profile = flown;
    return way;
  }

  /** Whether it was read for this goal, or one so near that ways hardly differ. */
  private boolean isFor(double northM, double eastM) {
    return Math.hypot(northM - goalNorthM, eastM - goalEastM) < frame.cellM();
  }

  private boolean contains(GridFrame window) {
    double northM = window.northM() + window.rows() * window.cellM();
    double eastM = window.eastM() + window.columns() * window.cellM();
    return frame.contains(window.northM(), window.eastM()) && frame.contains(northM, eastM);
  }

  private void read(DoubleBinaryOperator ground, GridFrame window, double northM, double eastM) {
    double spanM = window.rows() * window.cellM();
    double toNorth = northM - window.northM() - 0.5 * spanM;
    double toEast = eastM - window.eastM() - 0.5 * spanM;
    double sideM = Math.max(Math.abs(toNorth), Math.abs(toEast)) + 2.0 * BESIDE * spanM;
    frame =
        GridFrame.around(
            northM - 0.5 * toNorth,
            eastM - 0.5 * toEast,
            sideM / CELLS,
            sideM - 0.5 * sideM / CELLS);
    goalNorthM = northM;
    goalEastM = eastM;
    downs = new float[frame.cells()];
    for (int i = 0; i < downs.length; i++) {
      downs[i] = (float) ground.applyAsDouble(frame.centreNorthM(i), frame.centreEastM(i));
    }
    int columns = frame.columns();
    for (int i = 0; i < frame.rows(); i++) {
      fill(i * columns, 1, columns);
    }
    for (int i = 0; i < columns; i++) {
      fill(i, columns, frame.rows());
    }
  }

  /** Fills unknown cells of a row or column from known ones: a ridge goes on beyond the map. */
  private void fill(int first, int step, int count) {
    for (int i = 1; i < count; i++) {
      fill(first + i * step, first + (i - 1) * step);
    }
    for (int i = count - 2; i >= 0; i--) {
      fill(first + i * step, first + (i + 1) * step);
    }
  }

  private void fill(int cell, int from) {
    downs[cell] = Float.isNaN(downs[cell]) ? downs[from] : downs[cell];
  }
}
