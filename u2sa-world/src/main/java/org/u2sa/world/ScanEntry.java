package org.u2sa.world;

import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.RangeScan;

/**
 * Enters scans into a window of cells. Where a scan's beams are less than a cell apart, all between
 * them was seen to be free: that is one polygon. Further away, only the cells that a beam crosses
 * are. A cell is taken once a scan, however many beams cross it or end in it; a cell in which a
 * beam ends is not free for the others. Belongs to one thread.
 */
final class ScanEntry {
  /**
   * What of a beam counts.
   *
   * @param lowest height over the vehicle's reference point below which nothing is an obstacle [m]
   * @param highest the same above which nothing is [m]
   * @param freeRange how far a beam without an echo says that nothing is there [m]
   */
  record Band(double lowest, double highest, double freeRange) {}

  /** One part of a scan, during which the scanner hardly moved. */
  static final int PARTS = 8;

  private static final int MAX_SCANNERS = 64; // a message may name any number

  /** From a cell's middle to its corner [cells]: the polygon takes cells by their middles. */
  private static final double MARGIN = Math.sqrt(0.5);

  /** A beam takes cells whose middle is up to half a cell beside it. */
  private static final double BEAM_MARGIN = MARGIN + 0.5;

  /** Places in a row or column as integers: doubles would take most of a long beam's time. */
  private static final int FRACTION_BITS = 32;

  private static final double FRACTIONS = 1L << FRACTION_BITS;

  private final GridWindow window;
  private final LogOdds odds;
  private final PolygonFill polygon;
  private final ByteBuffer eight; // the window's cells, compared eight at a time
  private final long eightFreest;
  private final Map<String, FreeRanges> scanners = // by sensor, the one heard last at the end
      new LinkedHashMap<>(16, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<String, FreeRanges> eldest) {
          return size() > MAX_SCANNERS;
        }
      };
  private final MarkedCells hits;
  private final MarkedCells passed;

  ScanEntry(GridWindow window, LogOdds odds) {
    this.window = window;
    this.odds = odds;
    polygon = new PolygonFill(window.side());
    eight = ByteBuffer.wrap(window.cells());
    eightFreest = (odds.freest() & 0xFFL) * 0x0101_0101_0101_0101L;
    hits = new MarkedCells(window, LogOdds.MARK);
    passed = new MarkedCells(window, odds.freest());
  }

  /**
   * Enters one scan.
   *
   * @param up +1 if the map's z axis points up, else -1
   * @return how many beams were used
   */
  int enter(RangeScan scan, ScanPoses poses, Band band, double up) {
    List<Double> ranges = scan.ranges();
    List<Boolean> returns = scan.returns();
    int beams = Math.min(ranges.size(), returns.size()); // a writer may err
    beams = scan.angles().isEmpty() ? beams : Math.min(beams, scan.angles().size());
    if (beams == 0) {
      return 0;
    }
    FreeRanges free = scanners.computeIfAbsent(scan.sensorName(), name -> new FreeRanges());
    free.begin(scan, beams);
    Part[] parts = new Part[poses.moved() ? Math.min(PARTS, beams) : 1];
    for (int part = 0; part < parts.length; part++) {
      int from = beams * part / parts.length;
      int to = beams * (part + 1) / parts.length;
      SensorPose pose = poses.at(scan, (from + to) / 2.0 / beams);
      parts[part] = new Part(scan, free, pose, band, up, from, to);
      parts[part].enterEnds(ranges, returns);
    }
    free.cut(MARGIN * window.resolution());
    for (Part part : parts) {
      part.enterFree();
    }
    polygon.fill(this::pass);
    passed.replace(odds.passed());
    hits.replace(odds.ended());
    return beams;
  }

  /** Scanners of which something is remembered. */
  int scanners() {
    return scanners.size();
  }

  /** Takes cells that beams passed. Most were often passed before: these stay as they are. */
  private void pass(int row, int from, int to) {
    byte[] cells = window.cells();
    byte[] passed = odds.passed();
    byte freest = odds.freest();
    int end = row * window.side() + to + 1;
    for (int k = row * window.side() + from; k < end; ) {
      int block = Math.min(end, k + Long.BYTES);
      if (block - k == Long.BYTES && eight.getLong(k) == eightFreest) {
        k = block;
        continue;
      }
      for (; k < block; k++) {
        byte cell = cells[k];
        if (cell != freest) {
          cells[k] = passed[cell - Byte.MIN_VALUE];
        }
      }
    }
  }

  /** The beams of one part, seen from one place. */
  private final class Part {
    private final FreeRanges free;
    private final BeamDirections directions;
    private final Band band;
    private final int from; // first beam
    private final int to; // beam after the last
    private final double scale = 1.0 / window.resolution();
    private final double x; // of the scanner, in cells
    private final double y;
    private final double height; // of the scanner over the vehicle's reference point [m]
    private final double aheadX;
    private final double aheadY;
    private final double aheadUp;
    private final double asideX;
    private final double asideY;
    private final double asideUp;
    private final double minRange;
    private final double maxRange;

    Part(RangeScan scan, FreeRanges free, SensorPose pose, Band band, double up, int from, int to) {
      this.free = free;
      this.band = band;
      this.from = from;
      this.to = to;
      directions = free.directions();
      x = window.column(pose.place().x());
      y = window.row(pose.place().y());
      height = up * (pose.place().z() - pose.vehicle().z());
      aheadX = scale * pose.ahead().x();
      aheadY = scale * pose.ahead().y();
      aheadUp = up * pose.ahead().z();
      asideX = scale * pose.aside().x();
      asideY = scale * pose.aside().y();
      asideUp = up * pose.aside().z();
      minRange = scan.minRange();
      maxRange = scan.maxRange();
    }

    /** Marks the cells in which beams end, and notes how far each beam flew. */
    void enterEnds(List<Double> ranges, List<Boolean> returns) {
      for (int i = from; i < to; i++) {
        double cos = directions.cos(i);
        double sin = directions.sin(i);
        double measured = ranges.get(i);
        boolean echo = returns.get(i) && measured <= maxRange;
        double inBand = inBand(cos * aheadUp + sin * asideUp);
        if (echo && measured < minRange) {
          free.noEcho(i, 0.0); // of the vehicle itself
        } else if (echo && measured <= inBand) {
          free.echo(i, measured);
          hits.mark(
              x + measured * (cos * aheadX + sin * asideX),
              y + measured * (cos * aheadY + sin * asideY));
        } else if (echo) {
          free.harmless(i, measured, inBand); // below or above all obstacles
        } else {
          free.noEcho(i, Math.min(inBand, Math.min(maxRange, band.freeRange())));
        }
      }
    }

    /** Outlines what is free between the beams, and marks what further away is free along them. */
    void enterFree() {
      double lastX = x;
      double lastY = y;
      double before = 0.0;
      for (int i = from; i < to; i++) {
        double toX = directions.cos(i) * aheadX + directions.sin(i) * asideX;
        double toY = directions.cos(i) * aheadY + directions.sin(i) * asideY;
        double after = i + 1 < to ? free.between(i + 1, window.resolution()) : 0.0;
        polygon.edge(lastX, lastY, x + before * toX, y + before * toY);
        lastX = x + after * toX;
        lastY = y + after * toY;
        if (before != after) {
          polygon.edge(x + before * toX, y + before * toY, lastX, lastY);
        }
        double near = Math.min(before, after) + window.resolution(); // less is not worth a line
        if (free.of(i) > near) {
          double far = free.of(i, BEAM_MARGIN * window.resolution());
          if (far > near) {
            along(toX, toY, near - window.resolution(), far);
          }
        }
        before = after;
      }
      polygon.edge(lastX, lastY, x, y);
    }

    /** Marks cells between two ranges of a beam: of each column or row, the one it crosses. */
    private void along(double toX, double toY, double near, double far) {
      int side = window.side();
      boolean isSteep = Math.abs(toY) > Math.abs(toX);
      double start = isSteep ? y : x;
      double pace = isSteep ? toY : toX; // cells a metre along the longer axis
      int step = pace > 0.0 ? 1 : -1;
      double slope = isSteep ? toX / toY : toY / toX;
      double nearest = Math.floor(start + near * pace); // column or row
      double from = Math.max(0.0, step > 0 ? -nearest : nearest - (side - 1)); // in the window
      double to =
          Math.min(
              Math.ceil((start + far * pace - nearest - 0.5) * step),
              step > 0 ? side - nearest : nearest + 1.0);
      if (!(from < to)) {
        return;
      }
      double first = nearest + from * step;
      double other = (isSteep ? x : y) + (first + 0.5 - start) * slope;
      int stride = step * (isSteep ? side : 1);
      int otherStride = isSteep ? 1 : side;
      int cell = (int) first * (isSteep ? side : 1);
      byte[] cells = window.cells();
      byte freest = odds.freest(); // most cells: not worth a call
      long across = (long) Math.floor(other * FRACTIONS);
      long acrossStep = (long) (step * slope * FRACTIONS);
      for (int left = (int) (to - from); left > 0; left--) {
        int at = (int) (across >> FRACTION_BITS);
        if (at >= 0 && at < side && cells[cell + at * otherStride] != freest) {
          passed.mark(cell + at * otherStride);
        }
        cell += stride;
        across += acrossStep;
      }
    }

    /** How far a beam stays between lowest and highest [m]; 0 if it starts outside. */
    private double inBand(double climb) {
      if (height < band.lowest() || height > band.highest()) {
        return 0.0;
      }
      if (climb == 0.0) {
        return Double.POSITIVE_INFINITY;
      }
      return ((climb > 0.0 ? band.highest() : band.lowest()) - height) / climb;
    }
  }
}
