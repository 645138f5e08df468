package org.u2sa.vision.line;

import java.util.List;
import org.u2sa.vision.ground.GroundView;
import org.u2sa.vision.ground.TopView;

/** Finds painted lines and discs in a view from above. For one thread; reuses its memory. */
public final class PaintFinder {
  private final PaintMap map;
  private final LineTracer tracer;
  private final DiscFinder discs;

  /** What was found. */
  public record Paint(List<PaintedLine> lines, List<PaintedDisc> discs) {}

  /**
   * @param discRadiusM of the discs to find [m]
   */
  public PaintFinder(TopView.Area area, PaintSettings settings, double discRadiusM) {
    map = new PaintMap(area, settings);
    tracer = new LineTracer(area, settings);
    discs = new DiscFinder(area, discRadiusM);
  }

  /** Lines and discs, nearest first. */
  public Paint find(TopView top, GroundView view) {
    map.look(top);
    return new Paint(tracer.trace(map, top, view), discs.find(map, top, view));
  }

  /**
   * How much each cell looked like paint in the view last looked at, 0 not at all; unsigned, row by
   * row from the nearest. For pictures of what is seen.
   */
  public byte[] strength() {
    return map.strength();
  }
}
