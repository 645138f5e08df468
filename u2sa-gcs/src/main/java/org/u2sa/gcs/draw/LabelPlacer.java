package org.u2sa.gcs.draw;

import java.util.ArrayList;
import java.util.List;

/**
 * Finds room for labels beside the points they name: each takes the place around its point that
 * covers least of what is there already.
 */
public final class LabelPlacer {

  private static final int DIRECTIONS = 16;
  private static final double[] DISTANCES = {6.0, 16.0, 30.0, 50.0, 75.0};
  private static final double OUTSIDE_COST = 1e6;
  private static final double BOX_COST = 50.0; // per px² of a covered box
  private static final double LINE_COST = 40.0; // per covered point of a line
  private static final double DISTANCE_COST = 4.0; // per px from the point

  private final PixelBox frame;
  private final List<PixelBox> taken = new ArrayList<>();
  private final List<Canvas.Pixel> lines = new ArrayList<>();

  /**
   * @param frame where all labels must be
   */
  public LabelPlacer(PixelBox frame) {
    this.frame = frame;
  }

  /** Keeps labels off {@code box}. */
  public void avoid(PixelBox box) {
    taken.add(box);
  }

  /** Keeps labels off a line where they can, given by points some pixels apart. */
  public void avoidLine(List<Canvas.Pixel> points) {
    lines.addAll(points);
  }

  /**
   * The best place for a label of {@code width} by {@code height} beside a mark of radius {@code
   * radius} at (x, y); it is taken from then on.
   */
  public PixelBox place(double x, double y, double radius, double width, double height) {
    PixelBox best = null;
    double bestCost = Double.POSITIVE_INFINITY;
    for (double distance : DISTANCES) {
      for (int i = 0; i < DIRECTIONS; i++) {
        double angle = 2.0 * Math.PI * i / DIRECTIONS;
        double reach = radius + distance;
        // the box touches the circle of reach at the angle with the part of its edge that faces the
        // point
        double cx = x + reach * Math.cos(angle) + width / 2.0 * Math.cos(angle);
        double cy = y + reach * Math.sin(angle) + height / 2.0 * Math.sin(angle);
        PixelBox candidate = new PixelBox(cx - width / 2.0, cy - height / 2.0, width, height);
        double cost = cost(candidate) + DISTANCE_COST * distance;
        if (cost < bestCost) {
          bestCost = cost;
          best = candidate;
        }
      }
    }
    taken.add(best);
    return best;
  }

  private double cost(PixelBox candidate) {
    double cost = frame.contains(candidate) ? 0.0 : OUTSIDE_COST;
    for (PixelBox box : taken) {
      cost += BOX_COST * candidate.overlap(box);
    }
    for (Canvas.Pixel p : lines) {
      if (candidate.contains(p.x(), p.y())) {
        cost += LINE_COST;
      }
    }
    return cost;
  }
}
