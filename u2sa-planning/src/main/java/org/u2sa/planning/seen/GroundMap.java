package org.u2sa.planning.seen;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.interfaces.terrain.HeightGrid;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;

/**
 * Ground of a height map on the planning plane. Simulated motions ask for it many thousand times
 * per step: heights are stored for nodes, and interpolated. Confined to the planner's thread.
 */
public final class GroundMap {
  private static final double NODE_M = 2.0;
  private static final int NODES = 256; // stored in each direction; farther ones replace nearer
  private static final double SQUARE_M = 64.0; // within which longitude and latitude are linear
  private static final int SQUARES = 64; // likewise
  private static final double POLAR_DEG = 89.0;
  private static final double HALF_TURN_DEG = 180.0;
  private static final int NOTHING = Integer.MIN_VALUE;
  private static final int RINGS = 3; // of samples around a place
  private static final int DIRECTIONS = 12; // likewise

  private final Optional<HeightGrid> terrain;
  private final int[] rows = new int[NODES * NODES]; // of the node stored
  private final int[] columns = new int[NODES * NODES];
  private final double[] downs = new double[NODES * NODES];
  private final Geodetic[] corners = new Geodetic[SQUARES * SQUARES]; // of squares
  private final int[] cornerRows = new int[SQUARES * SQUARES];
  private final int[] cornerColumns = new int[SQUARES * SQUARES];
  private PlanningPlane plane;

  public GroundMap(Optional<HeightGrid> terrain) {
    this.terrain = terrain;
  }

  /** Down coordinate of the ground [m]; NaN if unknown. */
  public double downM(PlanningPlane on, double northM, double eastM) {
    if (!isOn(on)) {
      return Double.NaN;
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

  /** Whether the ground is known on a plane; later calls are about that plane. */
  public boolean isOn(PlanningPlane on) {
    if (terrain.isEmpty() || !on.onEarth()) {
      return false;
    }
    if (on != plane) {
      plane = on;
      Arrays.fill(rows, NOTHING);
      Arrays.fill(corners, null);
    }
    return true;
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

  /** Like {@link #downM} on the plane of the last call, without storing heights. */
  public double mappedM(double northM, double eastM) {
    Geodetic place = place(northM, eastM);
    OptionalDouble altitude = terrain.orElseThrow().altitudeM(place);
    return altitude.isPresent() ? place.altitudeM() - altitude.getAsDouble() : Double.NaN;
  }

  /**
   * Down coordinate of the highest ground within a distance, on the plane of the last call [m]; NaN
   * if unknown.
   */
  public double highestM(double northM, double eastM, double reachM) {
    double highestM = mappedM(northM, eastM);
    for (int i = 0; i < RINGS * DIRECTIONS; i++) {
      double radiusM = reachM * (1 + i / DIRECTIONS) / RINGS;
      double direction = 2.0 * Math.PI * (i % DIRECTIONS) / DIRECTIONS;
      double thereM =
          mappedM(northM + radiusM * Math.cos(direction), eastM + radiusM * Math.sin(direction));
      highestM = thereM < highestM || Double.isNaN(highestM) ? thereM : highestM;
    }
    return highestM;
  }

  private Geodetic place(double northM, double eastM) {
    int row = (int) Math.floor(northM / SQUARE_M);
    int column = (int) Math.floor(eastM / SQUARE_M);
    double up = northM / SQUARE_M - row;
    double right = eastM / SQUARE_M - column;
    Geodetic southWest = corner(row, column);
    Geodetic southEast = corner(row, column + 1);
    Geodetic northWest = corner(row + 1, column);
    Geodetic northEast = corner(row + 1, column + 1);
    double widthDeg = Math.abs(southEast.longitudeDeg() - southWest.longitudeDeg());
    double upperDeg = Math.abs(northEast.longitudeDeg() - southWest.longitudeDeg());
    double leftDeg = Math.abs(northWest.longitudeDeg() - southWest.longitudeDeg());
    boolean isAtDateLine = Math.max(widthDeg, Math.max(upperDeg, leftDeg)) > HALF_TURN_DEG;
    if (isAtDateLine || Math.abs(southWest.latitudeDeg()) > POLAR_DEG) {
      return exact(northM, eastM);
    }
    return new Geodetic(
        between(
            between(southWest.longitudeDeg(), southEast.longitudeDeg(), right),
            between(northWest.longitudeDeg(), northEast.longitudeDeg(), right),
            up),
        between(
            between(southWest.latitudeDeg(), southEast.latitudeDeg(), right),
            between(northWest.latitudeDeg(), northEast.latitudeDeg(), right),
            up),
        southWest.altitudeM());
  }

  private static double between(double one, double other, double share) {
    return one + share * (other - one);
  }

  private Geodetic corner(int row, int column) {
    int index = Math.floorMod(row, SQUARES) * SQUARES + Math.floorMod(column, SQUARES);
    if (corners[index] == null || cornerRows[index] != row || cornerColumns[index] != column) {
      cornerRows[index] = row;
      cornerColumns[index] = column;
      corners[index] = exact(SQUARE_M * row, SQUARE_M * column);
    }
    return corners[index];
  }

  private Geodetic exact(double northM, double eastM) {
    Point place = plane.point(northM, eastM, 0.0);
    return new Geodetic(place.x(), place.y(), place.z());
  }
}
