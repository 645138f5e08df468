package org.u2sa.world.scanmap;

import java.util.Arrays;
import java.util.List;

/**
 * Local raster of surfaces from several key scans: each cell holds the mean echo position and
 * surface normal, and the likelihood of an echo for the correlative search.
 */
final class LocalMap {
  static final double CELL = 0.1; // [m]
  static final int HALF_BLOCK = 4; // cells
  static final int BLOCK = 2 * HALF_BLOCK;
  static final double BLOCK_M = BLOCK * CELL;

  private static final int STAMP = 3; // radius of the likelihood around a surface [cells]
  private static final double STAMP_SIGMA = 1.3; // [cells]
  private static final int FULL = 100;
  private static final int SIZES = 5; // values summed per cell: x, y, nx, ny, count

  private final int side;
  private final int[] index;
  private final byte[] likelihood;
  private final byte[] stamp = new byte[(2 * STAMP + 1) * (2 * STAMP + 1)];
  private byte[] halves; // the largest likelihood in 4 by 4 cells from each one on
  private byte[] blocks; // in 8 by 8
  private boolean isBound;
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
    isBound = false;
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

  /** Prepares the bounds of searches in large windows. */
  void bound() {
    if (isBound) {
      return;
    }
    isBound = true;
    if (blocks == null) {
      halves = new byte[side * side];
      blocks = new byte[side * side];
    }
    spread(likelihood, blocks, 1);
    spread(blocks, halves, 2);
    spread(halves, blocks, 4);
  }

  /** Writes the largest of four cells, the given number of columns and rows apart, to each cell. */
  private void spread(byte[] from, byte[] to, int apart) {
    for (int row = 0; row < side; row++) {
      int above = row + apart < side ? apart * side : 0;
      for (int column = 0; column < side; column++) {
        int at = row * side + column;
        int right = column + apart < side ? at + apart : at;
        int most = Math.max(from[at], from[right]);
        to[at] = (byte) Math.max(most, Math.max(from[at + above], from[right + above]));
      }
    }
  }

  /**
   * Sum of the likelihoods of shifted points, or a sum up to {@code least} if it cannot be more.
   *
   * @param cells 1, HALF_BLOCK or BLOCK: the largest likelihood counts that a point has if it is
   *     shifted by up to one cell less along both axes; call {@link #bound} before
   */
  long sum(int cells, double[] x, double[] y, double dx, double dy, long least) {
    byte[] values = cells == BLOCK ? blocks : cells == HALF_BLOCK ? halves : likelihood;
    long sum = 0;
    for (int p = 0; p < x.length && sum + (x.length - p) * (long) FULL > least; p++) {
      int at = cell(x[p] + dx, y[p] + dy);
      sum += at < 0 ? 0 : values[at];
    }
    return sum;
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
