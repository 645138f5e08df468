package org.u2sa.world.grid;

import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.RangeScan;
import org.u2sa.world.modeller.ScanPoses;
import org.u2sa.world.modeller.SensorPose;

/**
 * Inserts scans into a window of cells. Where a scan's beams are less than a cell apart, the space
 * between them is free as well and is filled as one polygon; farther away, only the cells crossed
 * by a beam are free. Each cell is updated once per scan, however many beams cross it or end in it;
 * a cell in which a beam ends does not count as free for other beams. Not thread-safe.
 */
public final class ScanEntry {
  /**
   * Limits of beams that are used.
   *
   * @param lowest minimum height of obstacles above the vehicle's reference point [m]
   * @param highest maximum height of obstacles above the vehicle's reference point [m]
   * @param freeRange range over which a beam without an echo proves free space [m]
   */
  public record Band(double lowest, double highest, double freeRange) {}

  /** Number of parts of a scan, during each of which the scanner hardly moves. */
  public static final int PARTS = 8;

  private static final int MAX_SCANNERS = 64; // messages may name any number of them

  /** From a cell's centre to its corner [cells], because the polygon fill tests cell centres. */
  private static final double MARGIN = Math.sqrt(0.5);

  /** Margin of a single beam, which marks cells whose centre is up to half a cell beside it. */
  private static final double BEAM_MARGIN = MARGIN + 0.5;

  private final GridWindow window;
  private final LogOdds odds;
  private final PolygonFill polygon;
  private final ByteBuffer eight; // view of the window's cells, eight at a time
  private final long eightFreest;
  private final Map<String, FreeRanges> scanners = // by sensor, in order of last use
      new LinkedHashMap<>(16, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Map.Entry<String, FreeRanges> eldest) {
          return size() > MAX_SCANNERS;
        }
      };
  private final MarkedCells hits;
  private final MarkedCells passed;
  private final BeamTrace trace;

  ScanEntry(GridWindow window, LogOdds odds) {
    this.window = window;
    this.odds = odds;
    polygon = new PolygonFill(window.side());
    eight = ByteBuffer.wrap(window.cells());
    eightFreest = (odds.freest() & 0xFFL) * 0x0101_0101_0101_0101L;
    hits = new MarkedCells(window, LogOdds.MARK);
    passed = new MarkedCells(window, odds.freest());
    trace = new BeamTrace(window, odds.freest(), passed);
  }

  /**
   * Inserts one scan.
   *
   * @param up +1 if the map's z axis points up, else -1
   * @return number of beams used
   */
  int enter(RangeScan scan, ScanPoses poses, Band band, double up) {
    List<Double> ranges = scan.ranges();
    List<Boolean> returns = scan.returns();
    int beams = scan.beamCount();
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
    trace.begin();
    for (Part part : parts) {
      part.enterFree();
    }
    polygon.fill(this::pass);
    passed.replace(odds.passed());
    hits.forEach(trace::raised);
    hits.replace(odds.ended());
    return beams;
  }

  int scanners() {
    return scanners.size();
  }

  /** Updates a span of cells that beams passed; most are at their minimum and stay there. */
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

  /** One part of a scan, with the beams sent from one pose. */
  private final class Part {
    private final FreeRanges free;
    private final BeamDirections directions;
    private final Band band;
    private final int from; // first beam
    private final int to; // exclusive
    private final double scale = 1.0 / window.resolution();
    private final double x; // scanner position [cells]
    private final double y;
    private final double height; // scanner height above the vehicle's reference point [m]
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

    /** Marks the cells in which beams end and records the range of each beam. */
    void enterEnds(List<Double> ranges, List<Boolean> returns) {
      for (int i = from; i < to; i++) {
        double cos = directions.cos(i);
        double sin = directions.sin(i);
        double measured = ranges.get(i);
        boolean echo = returns.get(i) && measured <= maxRange;
        double inBand = inBand(cos * aheadUp + sin * asideUp);
        if (echo && measured < minRange) {
          free.noEcho(i, 0.0); // self-return
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

    /** Outlines the free space between beams, and marks the free cells along beams beyond it. */
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
        double near = Math.min(before, after) + window.resolution(); // less is not worth tracing
        if (free.of(i) > near) {
          double far = free.of(i, BEAM_MARGIN * window.resolution());
          if (far > near) {
            trace.mark(x, y, toX, toY, near - window.resolution(), far);
          }
        }
        before = after;
      }
      polygon.edge(lastX, lastY, x, y);
    }

    /** Range over which a beam stays between lowest and highest [m]; 0 if it starts outside. */
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
