package org.u2sa.sim.world;

import org.u2sa.messages.frame.Point;
import org.u2sa.sim.motion.Arguments;

/**
 * Horizontal, time-independent velocity of water: on a grid around the origin, north up, with
 * bilinear interpolation; constant beyond the edge. The velocity varies with depth by the same
 * profile everywhere, with linear interpolation. Immutable.
 */
public final class CurrentField {
  private static final int MAX_SIZE = 1 << 20;
  private static final double FASTEST_MPS = 20.0;

  private final double[] east; // rows from the north, each from the west [m/s]
  private final double[] north;
  private final int columns;
  private final int rows;
  private final double widthM;
  private final double heightM;
  private final double[] depths; // rising [m]
  private final double[] shares; // fraction of the velocity at each depth

  private CurrentField(
      double[] east,
      double[] north,
      int columns,
      double widthM,
      double heightM,
      double[] depths,
      double[] shares) {
    this.east = east;
    this.north = north;
    this.columns = columns;
    rows = east.length / columns;
    this.widthM = widthM;
    this.heightM = heightM;
    this.depths = depths;
    this.shares = shares;
  }

  /** The same current everywhere. */
  public static CurrentField uniform(double eastMps, double northMps) {
    Arguments.requireInside("current east [m/s]", eastMps, -FASTEST_MPS, FASTEST_MPS);
    Arguments.requireInside("current north [m/s]", northMps, -FASTEST_MPS, FASTEST_MPS);
    return new CurrentField(
        new double[] {eastMps},
        new double[] {northMps},
        1,
        1.0,
        1.0,
        new double[] {0.0},
        new double[] {1.0});
  }

  /**
   * Creates a field on a grid.
   *
   * @param east velocities to the east by rows from the north, each from the west [m/s]
   * @param north velocities to the north [m/s]
   * @param columns values in a row, at least 2; as many rows, at least 2
   * @param widthM extent from west to east [m]
   * @param depthM extent from north to south [m]
   * @throws IllegalArgumentException if the grid or a value is outside its range
   */
  public static CurrentField grid(
      double[] east, double[] north, int columns, double widthM, double depthM) {
    if (columns < 2
        || east.length < 2 * columns
        || east.length > MAX_SIZE
        || east.length % columns != 0
        || north.length != east.length) {
      throw new IllegalArgumentException(
          String.format(
              "%d currents east and %d north in rows of %d; expected equal numbers, and at least 2 rows of 2",
              east.length, north.length, columns));
    }
    Arguments.requirePositive("width of the currents [m]", widthM);
    Arguments.requirePositive("depth of the currents [m]", depthM);
    for (int i = 0; i < east.length; i++) {
      Arguments.requireInside("current east [m/s]", east[i], -FASTEST_MPS, FASTEST_MPS);
      Arguments.requireInside("current north [m/s]", north[i], -FASTEST_MPS, FASTEST_MPS);
    }
    return new CurrentField(
        east.clone(),
        north.clone(),
        columns,
        widthM,
        depthM,
        new double[] {0.0},
        new double[] {1.0});
  }

  /**
   * Copy with a depth profile.
   *
   * @param newDepths rising depths below still water [m]
   * @param newShares fraction of the velocity at each depth, −2…2
   * @throws IllegalArgumentException if the depths do not rise
   */
  public CurrentField withProfile(double[] newDepths, double[] newShares) {
    for (int i = 0; i < newDepths.length; i++) {
      Arguments.requireInside("share of the current", newShares[i], -2.0, 2.0);
      if (i > 0 && !(newDepths[i] > newDepths[i - 1])) {
        throw new IllegalArgumentException(
            "profile: depth " + newDepths[i] + " m: expected more than " + newDepths[i - 1] + " m");
      }
    }
    return new CurrentField(
        east, north, columns, widthM, heightM, newDepths.clone(), newShares.clone());
  }

  /** Whether the velocity is the same everywhere. */
  public boolean isUniform() {
    return columns == 1 && depths.length == 1;
  }

  /** Velocity at a place and depth below still water: east, north [m/s]. */
  public Point at(double eastM, double northM, double depthM) {
    double share = share(depthM);
    if (columns == 1) {
      return Point.of(share * east[0], share * north[0], 0.0);
    }
    double x = limited((eastM / widthM + 0.5) * (columns - 1), columns);
    double y = limited((0.5 - northM / heightM) * (rows - 1), rows);
    return Point.of(share * bilinear(east, x, y), share * bilinear(north, x, y), 0.0);
  }

  private static double limited(double index, int size) {
    return Math.max(0.0, Math.min(size - 1.0, index));
  }

  private double bilinear(double[] values, double x, double y) {
    int column = Math.min(columns - 2, (int) x);
    int row = Math.min(rows - 2, (int) y);
    int at = row * columns + column;
    double right = x - column;
    double down = y - row;
    double upper = (1.0 - right) * values[at] + right * values[at + 1];
    double lower = (1.0 - right) * values[at + columns] + right * values[at + columns + 1];
    return (1.0 - down) * upper + down * lower;
  }

  private double share(double depthM) {
    int after = 0;
    while (after < depths.length && depths[after] < depthM) {
      after++;
    }
    if (after == 0 || after == depths.length) {
      return shares[Math.min(after, depths.length - 1)];
    }
    double between = (depthM - depths[after - 1]) / (depths[after] - depths[after - 1]);
    return shares[after - 1] + between * (shares[after] - shares[after - 1]);
  }
}
