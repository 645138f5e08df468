package org.u2sa.world.scanmap;

import java.util.Arrays;
import java.util.List;

/**
 * Local raster of surfaces from several key scans: each cell holds the mean echo position and
 * surface normal, and the likelihood of an echo for the correlative search.
 */
final class LocalMap {
  static final double CELL = 0.1; // [m]
  private static final int BLOCK = 8; // cells
  static final double BLOCK_M = BLOCK * CELL;

  private static final int STAMP = 3; // radius of the likelihood around a surface [cells]
  private static final double STAMP_SIGMA = 1.3; // [cells]
  private static final int FULL = 100;
  private static final int SIZES = 5; // values summed per cell: x, y, nx, ny, count

  private final int side;
  private final int[] index;
  private final byte[] likelihood;
  private final int blocks;
  private final byte[] bounds; // per block of cells, see {@code bound}
  private final byte[] stamp = new byte[(2 * STAMP + 1) * (2 * STAMP + 1)];
  private double left;
  private double bottom;
  private float[] sums = new float[1024 * SIZES];
  private int used;

  /**
   * @param reach distance from the centre to the raster's edge [m]
   */
  LocalMap(double reach) {
    side = (int) Math.ceil(2.0 * reach / CELL);
    index = new int[side * side];
    likelihood = new byte[side * side];
    blocks = side / BLOCK + 1;
    bounds = new byte[blocks * blocks];
    for (int i = -STAMP; i <= STAMP; i++) {
      for (int k = -STAMP; k <= STAMP; k++) {
        double value = FULL * StrictMath.exp(-(i * i + k * k) / (2.0 * STAMP_SIGMA * STAMP_SIGMA));
        stamp[(i + STAMP) * (2 * STAMP + 1) + k + STAMP] = (byte) Math.round(value);
      }
    }
  }

  /** Replaces the contents with the echoes of several scans around a centre. */
  void build(List<KeyScan> scans, Pose2 centre) {
    Arrays.fill(index, -1);
    Arrays.fill(likelihood, (byte) 0);
    used = 0;
    left = Math.floor(centre.x() / CELL) * CELL - side / 2 * CELL;
    bottom = Math.floor(centre.y() / CELL) * CELL - side / 2 * CELL;
    for (KeyScan scan : scans) {
      Pose2 pose = scan.pose();
      double c = StrictMath.cos(pose.theta());
      double s = StrictMath.sin(pose.theta());
      ScanPoints p = scan.points();
      for (int i = 0; i < p.count; i++) {
        enter(
            pose.x() + c * p.x[i] - s * p.y[i],
            pose.y() + s * p.x[i] + c * p.y[i],
            c * p.nx[i] - s * p.ny[i],
            s * p.nx[i] + c * p.ny[i]);
      }
    }
    for (int k = 0; k < used; k++) {
      stamp(meanX(k), meanY(k));
    }
    bound();
  }

  private void enter(double x, double y, double nx, double ny) {
    int at = cell(x, y);
    if (at < 0) {
      return;
    }
    int k = index[at];
    if (k < 0) {
      k = used++;
      index[at] = k;
      sums = used * SIZES > sums.length ? Arrays.copyOf(sums, 2 * sums.length) : sums;
      Arrays.fill(sums, k * SIZES, k * SIZES + SIZES, 0.0f);
    }
    sums[k * SIZES] += (float) (x - left);
    sums[k * SIZES + 1] += (float) (y - bottom);
    sums[k * SIZES + 4] += 1.0f;
    if (!Double.isNaN(nx)) {
      sums[k * SIZES + 2] += (float) nx;
      sums[k * SIZES + 3] += (float) ny;
    }
  }

  private void stamp(double x, double y) {
    int column = (int) ((x - left) / CELL);
    int row = (int) ((y - bottom) / CELL);
    int width = 2 * STAMP + 1;
    for (int i = Math.max(-STAMP, -row); i <= STAMP && row + i < side; i++) {
      for (int k = Math.max(-STAMP, -column); k <= STAMP && column + k < side; k++) {
        int at = (row + i) * side + column + k;
        likelihood[at] = (byte) Math.max(likelihood[at], stamp[(i + STAMP) * width + k + STAMP]);
      }
    }
  }

  /** Each block's bound is the largest likelihood in it and in the three blocks above and right. */
  private void bound() {
    Arrays.fill(bounds, (byte) 0);
    for (int row = 0; row < side; row++) {
      for (int column = 0; column < side; column++) {
        byte value = likelihood[row * side + column];
        if (value > 0) {
          int at = row / BLOCK * blocks + column / BLOCK;
          bounds[at] = (byte) Math.max(bounds[at], value);
        }
      }
    }
    for (int row = 0; row < blocks; row++) {
      for (int column = 0; column < blocks; column++) {
        int at = row * blocks + column;
        int right = column + 1 < blocks ? at + 1 : at;
        int above = row + 1 < blocks ? blocks : 0;
        int most = Math.max(bounds[at], bounds[right]);
        bounds[at] = (byte) Math.max(most, Math.max(bounds[at + above], bounds[right + above]));
      }
    }
  }

  /** Largest likelihood of an echo there or up to {@link #BLOCK_M} farther along both axes. */
  int bound(double x, double y) {
    double column = (x - left) / BLOCK_M;
    double row = (y - bottom) / BLOCK_M;
    boolean inside = column >= 0.0 && row >= 0.0 && column < blocks && row < blocks;
    return inside ? bounds[(int) row * blocks + (int) column] : 0;
  }

  private int cell(double x, double y) {
    double column = (x - left) / CELL;
    double row = (y - bottom) / CELL;
    boolean inside = column >= 0.0 && row >= 0.0 && column < side && row < side;
    return inside ? (int) row * side + (int) column : -1;
  }

  /** Likelihood of an echo there, 0…100. */
  int likelihood(double x, double y) {
    int at = cell(x, y);
    return at < 0 ? 0 : likelihood[at];
  }

  /**
   * The nearest surface element whose normal agrees with that of a point.
   *
   * @param reach search radius [cells]
   * @return index of the element, or -1
   */
  int nearest(double x, double y, double nx, double ny, int reach) {
    int column = (int) Math.floor((x - left) / CELL);
    int row = (int) Math.floor((y - bottom) / CELL);
    int best = -1;
    double least = reach * CELL * reach * CELL;
    for (int i = Math.max(0, row - reach); i <= Math.min(side - 1, row + reach); i++) {
      for (int k = Math.max(0, column - reach); k <= Math.min(side - 1, column + reach); k++) {
        int at = index[i * side + k];
        if (at < 0) {
          continue;
        }
        double dx = meanX(at) - x;
        double dy = meanY(at) - y;
        double squared = dx * dx + dy * dy;
        if (squared < least && agrees(at, nx, ny)) {
          least = squared;
          best = at;
        }
      }
    }
    return best;
  }

  private boolean agrees(int at, double nx, double ny) {
    double length = normalLength(at);
    if (Double.isNaN(nx) || length < 0.3) {
      return true;
    }
    return sums[at * SIZES + 2] * nx + sums[at * SIZES + 3] * ny
        > 0.7 * length * sums[at * SIZES + 4];
  }

  double meanX(int at) {
    return left + sums[at * SIZES] / sums[at * SIZES + 4];
  }

  double meanY(int at) {
    return bottom + sums[at * SIZES + 1] / sums[at * SIZES + 4];
  }

  /** Mean of the unit normals; its length, 0…1, measures how well they agree. */
  double normalX(int at) {
    return sums[at * SIZES + 2] / sums[at * SIZES + 4];
  }

  double normalY(int at) {
    return sums[at * SIZES + 3] / sums[at * SIZES + 4];
  }

  double normalLength(int at) {
    return Math.hypot(normalX(at), normalY(at));
  }

  /** Number of surface elements. */
  int size() {
    return used;
  }
}
