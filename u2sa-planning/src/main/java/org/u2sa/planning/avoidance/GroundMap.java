package org.u2sa.planning.avoidance;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.planning.seen.PlanningPlane;

/**
 * Ground of a height map on the planning plane. Simulated motions ask for it many thousand times
 * per step: heights are stored for nodes, and interpolated. Confined to the planner's thread.
 */
final class GroundMap {
  private static final double NODE_M = 2.0;
  private static final int NODES = 256; // stored in each direction; farther ones replace nearer
  private static final int NOTHING = Integer.MIN_VALUE;

  private final Optional<HeightGrid> terrain;
  private final int[] rows = new int[NODES * NODES]; // of the node stored
  private final int[] columns = new int[NODES * NODES];
  private final double[] downs = new double[NODES * NODES];
  private PlanningPlane plane;

  GroundMap(Optional<HeightGrid> terrain) {
    this.terrain = terrain;
  }

  /** Down coordinate of the ground [m]; NaN if unknown. */
  double downM(PlanningPlane on, double northM, double eastM) {
    if (terrain.isEmpty() || !on.onEarth()) {
      return Double.NaN;
    }
    if (on != plane) {
      plane = on;
      Arrays.fill(rows, NOTHING);
    }
    double north = northM / NODE_M;
    double east = eastM / NODE_M;
    int row = (int) Math.floor(north);
    int column = (int) Math.floor(east);
    double up = north - row;
    double right = east - column;
    double south = (1.0 - right) * node(row, column) + right * node(row, column + 1);
    double beyond = (1.0 - right) * node(row + 1, column) + right * node(row + 1, column + 1);
    double down = (1.0 - up) * south + up * beyond;
    return Double.isNaN(down) ? mappedM(northM, eastM) : down;
  }

  private double node(int row, int column) {
    int index = Math.floorMod(row, NODES) * NODES + Math.floorMod(column, NODES);
    if (rows[index] != row || columns[index] != column) {
      rows[index] = row;
      columns[index] = column;
      downs[index] = mappedM(NODE_M * row, NODE_M * column);
    }
    return downs[index];
  }

  private double mappedM(double northM, double eastM) {
    Point place = plane.point(northM, eastM, 0.0);
    OptionalDouble altitude =
        terrain.orElseThrow().altitudeM(new Geodetic(place.x(), place.y(), 0.0));
    return altitude.isPresent() ? place.z() - altitude.getAsDouble() : Double.NaN;
  }
}
