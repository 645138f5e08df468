package org.u2sa.vision.line;

import java.util.List;
import org.u2sa.vision.ground.GroundView;
import org.u2sa.vision.ground.TopView;

/** Detects painted lines and discs in a bird's-eye view. Not thread-safe; reuses its buffers. */
public final class PaintFinder {
  private final PaintMap map;
  private final LineTracer tracer;
  private final DiscFinder discs;

  /** Detections. */
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

  /**
   * Paint strength of each cell in the last view, 0 for none; unsigned, row-major from the nearest
   * row. For display.
   */
  public byte[] strength() {
    return map.strength();
  }
}
