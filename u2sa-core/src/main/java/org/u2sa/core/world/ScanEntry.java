package org.u2sa.core.world;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.RangeScan;

/**
 * Enters scans into a window of cells. The sectors of a scan's beams, each as long as its beam flew
 * free, are one polygon: what lies in it was seen to be free and is taken once, however many beams
 * cross a cell near the scanner. Cells in which beams end are taken once too, and are not free for
 * the beams that pass beside. Belongs to one thread.
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

  private final GridWindow window;
  private final LogOdds odds;
  private final PolygonFill polygon;
  private final Map<String, BeamDirections> directions = new HashMap<>(); // by sensor
  private int[] hits = new int[4_096];
  private byte[] before = new byte[4_096]; // what these cells held
  private int hitCount;

  ScanEntry(GridWindow window, LogOdds odds) {
    this.window = window;
    this.odds = odds;
    polygon = new PolygonFill(window.side());
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
    BeamDirections sensor =
        directions.computeIfAbsent(scan.sensorName(), name -> new BeamDirections());
    sensor.of(scan, beams);
    hitCount = 0;
    int parts = poses.moved() ? Math.min(PARTS, beams) : 1;
    for (int part = 0; part < parts; part++) {
      int from = beams * part / parts;
      int to = beams * (part + 1) / parts;
      SensorPose pose = poses.at(scan, (from + to) / 2.0 / beams);
      new Part(scan, sensor, pose, band, up).enter(ranges, returns, from, to);
    }
    polygon.fill(this::pass);
    byte[] cells = window.cells();
    for (int i = 0; i < hitCount; i++) {
      cells[hits[i]] = odds.ended(before[i]);
    }
    return beams;
  }

  /** Takes cells that beams passed. Most were often passed before: these stay as they are. */
  private void pass(int row, int from, int to) {
    byte[] cells = window.cells();
    byte[] passed = odds.passed();
    byte freest = odds.freest();
    int last = row * window.side() + to;
    for (int k = row * window.side() + from; k <= last; k++) {
      byte cell = cells[k];
      if (cell != freest) {
        cells[k] = passed[cell - Byte.MIN_VALUE];
      }
    }
  }

  private void hit(double column, double row) {
    int side = window.side();
    if (column < 0.0 || row < 0.0 || column >= side || row >= side) {
      return;
    }
    int cell = (int) row * side + (int) column;
    byte[] cells = window.cells();
    if (cells[cell] == LogOdds.HIT) {
      return; // by another beam
    }
    if (hitCount == hits.length) {
      hits = Arrays.copyOf(hits, 2 * hitCount);
      before = Arrays.copyOf(before, 2 * hitCount);
    }
    hits[hitCount] = cell;
    before[hitCount++] = cells[cell];
    cells[cell] = LogOdds.HIT;
  }

  /** The beams of one part, seen from one place. */
  private final class Part {
    private final BeamDirections sensor;
    private final Band band;
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

    Part(RangeScan scan, BeamDirections sensor, SensorPose pose, Band band, double up) {
      this.sensor = sensor;
      this.band = band;
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

    void enter(List<Double> ranges, List<Boolean> returns, int from, int to) {
      double lastX = x;
      double lastY = y;
      for (int i = from; i < to; i++) {
        double cos = sensor.cos(i);
        double sin = sensor.sin(i);
        double measured = ranges.get(i);
        boolean echo = returns.get(i) && measured <= maxRange;
        double free = echo ? measured : Math.min(maxRange, band.freeRange());
        double climb = cos * aheadUp + sin * asideUp;
        double inBand = inBand(climb);
        if (echo && measured >= minRange && measured <= inBand) {
          hit(
              x + measured * (cos * aheadX + sin * asideX),
              y + measured * (cos * aheadY + sin * asideY));
        }
        free = echo && measured < minRange ? 0.0 : Math.min(free, inBand);
        double c = sensor.beforeCos(i);
        double s = sensor.beforeSin(i);
        double startX = x + free * (c * aheadX + s * asideX);
        double startY = y + free * (c * aheadY + s * asideY);
        c = sensor.afterCos(i);
        s = sensor.afterSin(i);
        double endX = x + free * (c * aheadX + s * asideX);
        double endY = y + free * (c * aheadY + s * asideY);
        if (sensor.isApart(i)) {
          polygon.edge(lastX, lastY, x, y);
          lastX = x;
          lastY = y;
        }
        polygon.edge(lastX, lastY, startX, startY);
        polygon.edge(startX, startY, endX, endY);
        lastX = endX;
        lastY = endY;
      }
      polygon.edge(lastX, lastY, x, y);
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
