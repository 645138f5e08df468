package org.u2sa.planning.search;

import java.util.List;

/**
 * A path through a grid.
 *
 * @param corners from start to end
 * @param cost length in metres, weighted by the local cost
 */
public record GridPath(List<Corner> corners, double cost) {
  /** A point of the path [m]. */
  public record Corner(double northM, double eastM) {}

  public GridPath {
    corners = List.copyOf(corners);
  }
}
