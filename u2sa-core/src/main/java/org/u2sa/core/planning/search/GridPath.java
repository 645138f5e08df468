package org.u2sa.core.planning.search;

import java.util.List;

/**
 * A way through a grid.
 *
 * @param corners from start to end
 * @param cost metres, each times the cost of where it lies
 */
public record GridPath(List<Corner> corners, double cost) {
  /** A point of the way [m]. */
  public record Corner(double northM, double eastM) {}

  /** Copies the corners. */
  public GridPath {
    corners = List.copyOf(corners);
  }
}
