package org.u2sa.sim.camera;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.shape.Line;

/** Generates a {@link Lawn} procedurally: grass, then paint, then shadows. */
final class LawnPainter {
  private static final double CELL_M = 0.02;
  private static final double MARGIN_M = 5.0;
  private static final double LARGEST_M = 120.0;
  private static final int BLADES = 512;
  private static final double BLADE_M = 0.008;
  private static final double EDGE_M = 0.012; // width of the paint's soft edge
  private static final int CLOUD_CELLS = 4;
  private static final double PENUMBRA_M = 0.03; // width of the shadow's soft edge

  private final double westM;
  private final double southM;
  private final int width;
  private final int height;
  private final int[] cells;
  private final ValueNoise noise;

  /**
   * @param bounds west, south, east, north [m]
   */
  LawnPainter(double[] bounds, long seed) {
    westM = bounds[0];
    southM = bounds[1];
    width = (int) Math.ceil((bounds[2] - bounds[0]) / CELL_M);
    height = (int) Math.ceil((bounds[3] - bounds[1]) / CELL_M);
    cells = new int[width * height];
    noise = new ValueNoise(seed);
    grass();
  }

  /** Bounding box of the objects and the origin, with a margin. */
  static double[] bounds(List<? extends ObjectDescription> objects) {
    double[] bounds = {0.0, 0.0, 0.0, 0.0};
    for (ObjectDescription object : objects) {
      List<Point> points = object instanceof Line line ? line.points() : List.of(object.center());
      for (Point point : points) {
        bounds[0] = Math.min(bounds[0], point.x());
        bounds[1] = Math.min(bounds[1], point.y());
        bounds[2] = Math.max(bounds[2], point.x());
        bounds[3] = Math.max(bounds[3], point.y());
      }
    }
    if (bounds[2] - bounds[0] > LARGEST_M || bounds[3] - bounds[1] > LARGEST_M) {
      throw new IllegalArgumentException(
          String.format(
              "world of %.0f m by %.0f m: the camera's lawn is limited to %.0f m",
              bounds[2] - bounds[0], bounds[3] - bounds[1], LARGEST_M));
    }
    return new double[] {
      bounds[0] - MARGIN_M, bounds[1] - MARGIN_M, bounds[2] + MARGIN_M, bounds[3] + MARGIN_M
    };
  }

  /**
   * Patches of different grass and dry spots; the coarse pattern is computed on every fourth cell.
   */
  private void grass() {
    int step = 4;
    for (int row = 0; row < height; row += step) {
      for (int column = 0; column < width; column += step) {
        double x = column * CELL_M;
        double y = row * CELL_M;
        double dry = 1.4 * noise.fractal(0.45 * x, 0.45 * y, 4) - 0.15;
        double tone = 1.0 + 0.35 * noise.fractal(3.0 * x + 40.0, 3.0 * y, 3);
        int colour =
            scaled(Reflectance.mix(Reflectance.GRASS, Reflectance.DRY_GRASS, dry), tone)
                | 0xFF000000;
        for (int r = row; r < Math.min(height, row + step); r++) {
          Arrays.fill(
              cells, r * width + column, r * width + Math.min(width, column + step), colour);
        }
      }
    }
  }

  private static int scaled(int colour, double by) {
    int red = (int) Math.min(255.0, (colour >> 16 & 0xFF) * by);
    int green = (int) Math.min(255.0, (colour >> 8 & 0xFF) * by);
    int blue = (int) Math.min(255.0, (colour & 0xFF) * by);
    return red << 16 | green << 8 | blue;
  }

  /** Paints weathered boards within a convex outline. */
  void boards(double[] outline) {
    double[] hull = hull(outline);
    double[] bounds = bounds(hull);
    for (int row = Math.max(0, row(bounds[1]));
        row <= Math.min(height - 1, row(bounds[3]));
        row++) {
      int last = Math.min(width - 1, column(bounds[2]));
      for (int column = Math.max(0, column(bounds[0])); column <= last; column++) {
        double x = westM + column * CELL_M;
        double y = southM + row * CELL_M;
        if (insideM(hull, x, y) > 0.0) {
          double tone = 1.0 + 0.1 * noise.fractal(2.0 * x, 2.0 * y, 3);
          cells[row * width + column] = scaled(Reflectance.BOARDS, tone) | 0xFF000000;
        }
      }
    }
  }

  /** Paints a line; worn paint has holes that show grass. */
  void line(List<Point> points, double widthM, boolean worn) {
    for (int i = 1; i < points.size(); i++) {
      Point a = points.get(i - 1);
      Point b = points.get(i);
      paint(
          Math.min(a.x(), b.x()),
          Math.min(a.y(), b.y()),
          Math.max(a.x(), b.x()),
          Math.max(a.y(), b.y()),
          0.5 * widthM,
          worn,
          (x, y) -> segmentM(x, y, a, b));
    }
  }

  void disc(double x, double y, double radiusM) {
    paint(x, y, x, y, radiusM, false, (px, py) -> Math.hypot(px - x, py - y));
  }

  private interface Away {
    double metres(double x, double y);
  }

  private void paint(
      double west,
      double south,
      double east,
      double north,
      double reachM,
      boolean worn,
      Away away) {
    double more = reachM + 2.0 * EDGE_M;
    int lastRow = Math.min(height - 1, row(north + more));
    int lastColumn = Math.min(width - 1, column(east + more));
    for (int row = Math.max(0, row(south - more)); row <= lastRow; row++) {
      for (int column = Math.max(0, column(west - more)); column <= lastColumn; column++) {
        double x = westM + column * CELL_M;
        double y = southM + row * CELL_M;
        double ragged = 0.008 * noise.at(40.0 * x, 40.0 * y);
        double cover = (reachM - away.metres(x, y) + ragged) / EDGE_M + 0.5;
        if (cover > 0.0) {
          double coat = worn ? worn(x, y) : fresh(x, y);
          double share = Math.min(1.0, cover) * coat;
          int at = row * width + column;
          int painted = Reflectance.mix(cells[at], Reflectance.PAINT, share);
          cells[at] = brightest(cells[at], painted);
        }
      }
    }
  }

  /** Overlapping strokes: the thicker coat wins. */
  private static int brightest(int before, int painted) {
    return (painted >> 8 & 0xFF) > (before >> 8 & 0xFF) ? painted | 0xFF000000 : before;
  }

  private double fresh(double x, double y) {
    return Math.max(0.55, Math.min(1.0, 0.9 + 0.35 * noise.fractal(8.0 * x, 8.0 * y, 2)));
  }

  private double worn(double x, double y) {
    double holes = 0.55 + 1.1 * noise.fractal(3.0 * x, 3.0 * y, 4);
    return Math.max(0.08, Math.min(0.75, holes));
  }

  /** Casts the shadow of a solid, the convex hull of its points. */
  void shadow(double[] points) {
    double[] hull = hull(points);
    double[] bounds = bounds(hull);
    int lastRow = Math.min(height - 1, row(bounds[3]));
    int lastColumn = Math.min(width - 1, column(bounds[2]));
    for (int row = Math.max(0, row(bounds[1])); row <= lastRow; row++) {
      for (int c = Math.max(0, column(bounds[0])); c <= lastColumn; c++) {
        double inside = insideM(hull, westM + c * CELL_M, southM + row * CELL_M);
        if (inside > 0.0) {
          darken(row * width + c, Math.max(0.0, 255.0 * (1.0 - inside / PENUMBRA_M)));
        }
      }
    }
  }

  /** Bounding box of an outline: west, south, east, north [m]. */
  private static double[] bounds(double[] outline) {
    double[] bounds = {outline[0], outline[1], outline[0], outline[1]};
    for (int i = 0; i < outline.length; i += 2) {
      bounds[0] = Math.min(bounds[0], outline[i]);
      bounds[1] = Math.min(bounds[1], outline[i + 1]);
      bounds[2] = Math.max(bounds[2], outline[i]);
      bounds[3] = Math.max(bounds[3], outline[i + 1]);
    }
    return bounds;
  }

  /**
   * Soft shadows of clouds and trees over a fraction of the ground, computed at every fourth cell
   * and row and interpolated linearly.
   */
  void clouds(double share) {
    double threshold = 0.55 - share;
    int columns = width / CLOUD_CELLS + 2;
    double[] above = new double[columns];
    double[] below = new double[columns];
    shade(0, below);
    for (int row = 0; row < height; row++) {
      if (row % CLOUD_CELLS == 0) {
        double[] free = above;
        above = below;
        below = free;
        shade(row / CLOUD_CELLS + 1, below);
      }
      double down = (double) (row % CLOUD_CELLS) / CLOUD_CELLS;
      for (int column = 0; column < width; column++) {
        int k = column / CLOUD_CELLS;
        double right = (double) (column % CLOUD_CELLS) / CLOUD_CELLS;
        double top = above[k] + right * (above[k + 1] - above[k]);
        double dark = top + down * (below[k] + right * (below[k + 1] - below[k]) - top);
        if (dark > threshold) {
          darken(row * width + column, 255.0 * Math.max(0.1, 1.0 - (dark - threshold) / 0.12));
        }
      }
    }
  }

  private void shade(int row, double[] into) {
    double y = CLOUD_CELLS * row * CELL_M;
    for (int k = 0; k < into.length; k++) {
      double x = CLOUD_CELLS * k * CELL_M;
      into[k] = noise.at(0.17 * x + 100.0, 0.17 * y) + 0.35 * noise.at(1.9 * x, 1.9 * y);
    }
  }

  private void darken(int at, double sunlit) {
    int lit = Math.min(cells[at] >>> 24, (int) Math.min(255.0, sunlit));
    cells[at] = cells[at] & 0xFFFFFF | lit << 24;
  }

  /** Signed distance inside a convex anticlockwise outline [m]; negative outside. */
  private static double insideM(double[] hull, double x, double y) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < hull.length; i += 2) {
      int j = (i + 2) % hull.length;
      double ax = hull[j] - hull[i];
      double ay = hull[j + 1] - hull[i + 1];
      double length = Math.sqrt(ax * ax + ay * ay);
      double left = (ax * (y - hull[i + 1]) - ay * (x - hull[i])) / Math.max(1e-9, length);
      least = Math.min(least, left);
    }
    return least;
  }

  /** Andrew's monotone chain (Information Processing Letters 9, 1979). */
  private static double[] hull(double[] points) {
    Integer[] order = new Integer[points.length / 2];
    Arrays.setAll(order, i -> i);
    Arrays.sort(
        order,
        Comparator.<Integer>comparingDouble(i -> points[2 * i])
            .thenComparingDouble(i -> points[2 * i + 1]));
    double[] hull = new double[2 * points.length + 4];
    int size = 0;
    for (int pass = 0; pass < 2; pass++) {
      int floor = size;
      for (int k = 0; k < order.length; k++) {
        int i = order[pass == 0 ? k : order.length - 1 - k];
        while (size - floor >= 2 && turn(hull, size, points[2 * i], points[2 * i + 1]) <= 0.0) {
          size--;
        }
        hull[2 * size] = points[2 * i];
        hull[2 * size + 1] = points[2 * i + 1];
        size++;
      }
      size--; // the last point of one chain starts the other
    }
    return Arrays.copyOf(hull, 2 * size);
  }

  private static double turn(double[] hull, int size, double x, double y) {
    int b = 2 * (size - 1);
    int a = b - 2;
    return (hull[b] - hull[a]) * (y - hull[a + 1]) - (hull[b + 1] - hull[a + 1]) * (x - hull[a]);
  }

  private static double segmentM(double x, double y, Point a, Point b) {
    double dx = b.x() - a.x();
    double dy = b.y() - a.y();
    double square = dx * dx + dy * dy;
    double along =
        square == 0.0
            ? 0.0
            : Math.max(0.0, Math.min(1.0, ((x - a.x()) * dx + (y - a.y()) * dy) / square));
    return Math.hypot(x - a.x() - along * dx, y - a.y() - along * dy);
  }

  private int row(double y) {
    return (int) Math.floor((y - southM) / CELL_M);
  }

  private int column(double x) {
    return (int) Math.floor((x - westM) / CELL_M);
  }

  Lawn lawn() {
    return new Lawn(new MipMap(cells, width, height), westM, southM, CELL_M, blades(), BLADE_M);
  }

  /** Bright blades and dark gaps, finer than the map; repeats every 4 m. */
  private TiledMap blades() {
    byte[] pattern = new byte[BLADES * BLADES];
    for (int i = 0; i < pattern.length; i++) {
      int row = i / BLADES;
      int column = i % BLADES;
      double tuft = wrapped(column / 8.0, row / 8.0, BLADES / 8);
      double blade = wrapped(column / 2.0 + 1000.0, row / 2.0, BLADES / 2);
      double value = 128.0 * (1.0 + 0.3 * tuft + 0.35 * blade);
      pattern[i] = (byte) Math.max(0.0, Math.min(255.0, value));
    }
    return new TiledMap(pattern, BLADES);
  }

  /** Tileable noise, cross-faded at the seam. */
  private double wrapped(double x, double y, int period) {
    double u = Math.max(0.0, (x % period) / period * 8.0 - 7.0);
    double v = Math.max(0.0, (y % period) / period * 8.0 - 7.0);
    double top = noise.at(x, y) * (1.0 - u) + noise.at(x - period, y) * u;
    double low = noise.at(x, y - period) * (1.0 - u) + noise.at(x - period, y - period) * u;
    return top * (1.0 - v) + low * v;
  }
}
