package org.u2sa.world.coverage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.u2sa.messages.Metric;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.SearchArea;
import org.u2sa.messages.shape.CoverageLedger;
import org.u2sa.messages.shape.ImageFootprint;

/** The cells of one search area and the best view of each. */
final class AreaCells {
  private static final int MAX_CELLS = 20_000;
  private static final double GROWTH = 1.05;
  private static final int MAX_OUTLINE = 32; // corners of an image
  private static final int COARSEST = 255;
  private static final int MAX_ANGLE_DEG = 254;

  private final SearchArea goal;
  private final Metric metric;
  private final double[] xs; // of the outline [m]
  private final double[] ys;
  private final double left;
  private final double bottom;
  private final double cellM;
  private final int columns;
  private final int rows;
  private final byte[] resolutions;
  private final byte[] angles;
  private final byte[] images;
  private CoverageLedger ledger; // null after a change

  AreaCells(SearchArea goal, double wantedCellM) {
    this.goal = goal;
    metric = Metric.around(goal.referenceFrame(), goal.corners().get(0));
    xs = new double[goal.corners().size()];
    ys = new double[xs.length];
    for (int i = 0; i < xs.length; i++) {
      Point corner = metric.metres(goal.corners().get(i));
      xs[i] = corner.x();
      ys[i] = corner.y();
    }
    left = Arrays.stream(xs).min().orElseThrow();
    bottom = Arrays.stream(ys).min().orElseThrow();
    double width = Arrays.stream(xs).max().orElseThrow() - left;
    double height = Arrays.stream(ys).max().orElseThrow() - bottom;
    double side = Math.max(wantedCellM, Math.sqrt(width * height / (0.9 * MAX_CELLS)));
    while (count(width, side) * count(height, side) > MAX_CELLS) {
      side *= GROWTH; // the area is long and narrow
    }
    cellM = side;
    columns = (int) count(width, cellM);
    rows = (int) count(height, cellM);
    resolutions = new byte[columns * rows];
    angles = new byte[columns * rows];
    images = new byte[2 * columns * rows];
    for (int i = 0; i < angles.length; i++) {
      angles[i] = touches(i) ? 0 : (byte) CoverageLedger.OUTSIDE;
    }
  }

  private static double count(double metres, double sideM) {
    return Math.max(1.0, Math.ceil(metres / sideM));
  }

  boolean isOf(SearchArea other) {
    return goal.corners().equals(other.corners())
        && goal.referenceFrame().equals(other.referenceFrame());
  }

  SearchArea goal() {
    return goal;
  }

  /** Whether the centre or a corner of a cell is inside the outline. */
  private boolean touches(int cell) {
    double x = left + cell % columns * cellM;
    double y = bottom + cell / columns * cellM;
    return isInside(x + 0.5 * cellM, y + 0.5 * cellM)
        || isInside(x, y)
        || isInside(x + cellM, y)
        || isInside(x, y + cellM)
        || isInside(x + cellM, y + cellM);
  }

  private boolean isInside(double x, double y) {
    boolean inside = false;
    for (int i = 0, j = xs.length - 1; i < xs.length; j = i++) {
      if (ys[i] > y != ys[j] > y && x < xs[i] + (xs[j] - xs[i]) * (y - ys[i]) / (ys[j] - ys[i])) {
        inside = !inside;
      }
    }
    return inside;
  }

  /** Records an image: a cell counts as seen if it lies entirely in the reduced footprint. */
  void see(ImageFootprint seen, double marginM) {
    int corners = seen.points().size();
    boolean isPlaced =
        seen.referenceFrame().isEarth() == goal.referenceFrame().isEarth()
            && seen.referenceFrame().isLocal() == goal.referenceFrame().isLocal();
    if (!isPlaced || corners < 3 || corners > MAX_OUTLINE) {
      return;
    }
    ImageFootprint placed = (ImageFootprint) seen.in(goal.referenceFrame(), null);
    List<Point> outline = new ArrayList<>();
    placed.points().forEach(point -> outline.add(metric.metres(point)));
    double west = outline.stream().mapToDouble(Point::x).min().orElseThrow();
    double east = outline.stream().mapToDouble(Point::x).max().orElseThrow();
    double south = outline.stream().mapToDouble(Point::y).min().orElseThrow();
    double north = outline.stream().mapToDouble(Point::y).max().orElseThrow();
    int steps = (int) Math.ceil(seen.resolution() / CoverageLedger.RESOLUTION_STEP_M - 1e-9);
    int fine = Math.max(1, Math.min(COARSEST, steps));
    for (int row = index(south, bottom, rows); row <= index(north, bottom, rows); row++) {
      for (int column = index(west, left, columns);
          column <= index(east, left, columns);
          column++) {
        int cell = row * columns + column;
        int before = resolutions[cell] & 0xff;
        boolean isBetter = before == 0 || fine < before;
        if (isBetter && (angles[cell] & 0xff) != CoverageLedger.OUTSIDE) {
          mark(cell, seen, outline, marginM, fine);
        }
      }
    }
  }

  private int index(double metres, double from, int count) {
    return (int) Math.max(0.0, Math.min(count - 1.0, Math.floor((metres - from) / cellM)));
  }

  private void mark(int cell, ImageFootprint seen, List<Point> outline, double marginM, int fine) {
    double x = left + cell % columns * cellM;
    double y = bottom + cell / columns * cellM;
    if (depthM(outline, x, y) < marginM
        || depthM(outline, x + cellM, y) < marginM
        || depthM(outline, x, y + cellM) < marginM
        || depthM(outline, x + cellM, y + cellM) < marginM) {
      return;
    }
    resolutions[cell] = (byte) fine;
    angles[cell] = (byte) Math.min(MAX_ANGLE_DEG, (int) Math.round(Math.toDegrees(seen.angle())));
    images[2 * cell] = (byte) (seen.image() >> 8);
    images[2 * cell + 1] = (byte) seen.image();
    ledger = null;
  }

  /** Distance inside a convex outline of either orientation; negative outside [m]. */
  private static double depthM(List<Point> outline, double x, double y) {
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < outline.size(); i++) {
      Point a = outline.get(i);
      Point b = outline.get((i + 1) % outline.size());
      double length = Math.hypot(b.x() - a.x(), b.y() - a.y());
      if (length > 0.0) {
        double side = ((b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x())) / length;
        least = Math.min(least, side);
        most = Math.max(most, side);
      }
    }
    return Math.max(least, -most);
  }

  /** The record as a message; the same object until it changes. */
  CoverageLedger ledger() {
    if (ledger == null) {
      CoverageLedger next = new CoverageLedger().points(goal.corners()).area(goal.uid());
      Point corner = metric.point(Point.of(left, bottom, 0.0));
      next.cells(corner, cellM, columns, resolutions, angles, images);
      next.uid("coverage of " + goal.uid());
      next.objectType("search area");
      next.referenceFrame(goal.referenceFrame());
      Point middle =
          metric.point(Point.of(left + columns * cellM / 2, bottom + rows * cellM / 2, 0));
      next.x(middle.x());
      next.y(middle.y());
      next.z(goal.ground());
      next.level(ObjectLevel.HINDRANCE);
      next.freeze();
      ledger = next;
    }
    return ledger;
  }

  /** Adopts the cells of an earlier record of the same area. */
  void restore(CoverageLedger before) {
    if (before.columns() == columns && before.rows() == rows) {
      before.copyTo(resolutions, angles, images);
      ledger = null;
    }
  }
}
