package org.u2sa.vision.line;

import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.vision.ground.GroundView;
import org.u2sa.vision.ground.TopView;

/** Detects painted lines and discs in a bird's-eye view. Not thread-safe; reuses its buffers. */
public final class PaintFinder {
  private final PaintMap map;
  private final LineTracer tracer;
  private final DiscFinder discs;

  public record Paint(List<PaintedLine> lines, List<PaintedDisc> discs) {}

  /**
   * @param discRadiusM radius of the discs to find [m]
   */
  public PaintFinder(TopView.Area area, PaintSettings settings, double discRadiusM) {
    map = new PaintMap(area, settings);
    tracer = new LineTracer(area, settings);
    discs = new DiscFinder(area, discRadiusM);
  }

  /** Detects lines and discs, nearest first. */
  public Paint find(TopView top, GroundView view) {
    map.look(top);
    return new Paint(tracer.trace(map, top, view), discs.find(map, top, view));
  }

  /** Paint strength of each cell in the last view, 0 for none; unsigned, nearest row first. */
  public byte[] strength() {
    return map.strength();
  }

  /**
   * A white disc on the ground, IGVC's pothole marking.
   *
   * @param centre LEVEL
   * @param radiusM radius of a disc of equal area [m]
   */
  public record PaintedDisc(Point centre, double radiusM) {}

  /**
   * A visible piece of a painted line.
   *
   * @param points centre line, LEVEL, in order; at least two
   * @param support fraction of its length with visible paint, 0…1
   */
  public record PaintedLine(List<Point> points, double support) {
    /** Length along the points [m]. */
    public double lengthM() {
      double length = 0.0;
      for (int i = 1; i < points.size(); i++) {
        length += points.get(i).distanceTo(points.get(i - 1));
      }
      return length;
    }
  }

  /**
   * Criteria for painted lines.
   *
   * @param widthM line width [m]; 0.0762 is 3 in
   * @param contrast minimum contrast to the ground on both sides, as brightness ratio minus 1: 0.15
   *     is 15 %
   * @param noiseFactor minimum contrast in multiples of the ground's roughness
   * @param shortestM minimum length of a line [m]
   * @param longestGapM longest gap of worn or missing paint to bridge [m]
   * @param pieceM maximum length of a piece; longer lines are cut [m]
   */
  public record PaintSettings(
      double widthM,
      double contrast,
      double noiseFactor,
      double shortestM,
      double longestGapM,
      double pieceM) {}
}
