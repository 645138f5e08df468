package org.u2sa.report.picture;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Places labels beside the points they name: each takes the position around its point that overlaps
 * least with what is already there.
 */
final class LabelPlacer {

  private static final int DIRECTIONS = 16;
  private static final double[] DISTANCES = {6.0, 16.0, 30.0, 50.0, 75.0};
  private static final double OUTSIDE_COST = 1e6;
  private static final double BOX_COST = 50.0; // per px² of a covered box
  private static final double LINE_COST = 40.0; // per covered point of a line
  private static final double LINE_SPACING = 6.0; // of the points that represent a line [px]
  private static final double DISTANCE_COST = 4.0; // per px from the point

  private static final int PARTS = 200; // of an edge, to find its visible part

  private final Rectangle2D frame;
  private final List<Rectangle2D.Double> taken = new ArrayList<>();
  private final List<Point2D.Double> lines = new ArrayList<>();

  /** Places labels within the frame. */
  LabelPlacer(Rectangle2D frame) {
    this.frame = frame;
  }

  void avoid(Rectangle2D.Double box) {
    taken.add(box);
  }

  void avoidLine(List<Point2D> corners) {
    for (int i = 0; i + 1 < corners.size(); i++) {
      Point2D a = corners.get(i);
      Point2D b = corners.get(i + 1);
      int parts = 1 + (int) (a.distance(b) / LINE_SPACING);
      for (int k = 0; k < parts; k++) {
        lines.add(
            new Point2D.Double(
                a.getX() + (b.getX() - a.getX()) * k / parts,
                a.getY() + (b.getY() - a.getY()) * k / parts));
      }
    }
  }

  /**
   * Best position for a label of {@code width} by {@code height} beside a mark of radius {@code
   * radius} at (x, y); marks it as taken.
   */
  Rectangle2D.Double place(double x, double y, double radius, double width, double height) {
    Rectangle2D.Double best = null;
    double bestCost = Double.POSITIVE_INFINITY;
    for (double distance : DISTANCES) {
      for (int i = 0; i < DIRECTIONS; i++) {
        double angle = 2.0 * Math.PI * i / DIRECTIONS;
        double reach = radius + distance;
        // the box touches the circle of reach at the angle with the part of its edge that faces the
        // point
        double cx = x + reach * Math.cos(angle) + width / 2.0 * Math.cos(angle);
        double cy = y + reach * Math.sin(angle) + height / 2.0 * Math.sin(angle);
        Rectangle2D.Double candidate =
            new Rectangle2D.Double(cx - width / 2.0, cy - height / 2.0, width, height);
        double cost = cost(candidate, DISTANCE_COST * distance, bestCost);
        if (cost < bestCost) {
          bestCost = cost;
          best = candidate;
        }
      }
    }
    taken.add(best);
    return best;
  }

  /** Cost of a place, at least {@code farther}; stops counting at a limit. */
  private double cost(Rectangle2D.Double candidate, double farther, double limit) {
    double cost = frame.contains(candidate) ? 0.0 : OUTSIDE_COST;
    for (Rectangle2D.Double box : taken) {
      cost += BOX_COST * overlap(candidate, box);
    }
    for (int i = 0; i < lines.size() && cost + farther < limit; i++) {
      if (candidate.contains(lines.get(i))) {
        cost += LINE_COST;
      }
    }
    return cost + farther;
  }

  /** The middle of the longest visible part of an outline [px]; empty if none is visible. */
  static Optional<Point2D> visibleMiddle(List<Point2D> outline, Rectangle2D area) {
    Optional<Point2D> best = Optional.empty();
    double longest = 0.0;
    for (int i = 0; i + 1 < outline.size(); i++) {
      Point2D a = outline.get(i);
      Point2D b = outline.get(i + 1);
      Point2D first = null;
      Point2D last = null;
      for (int k = 0; k <= PARTS; k++) {
        double share = (double) k / PARTS;
        Point2D at =
            new Point2D.Double(
                a.getX() + share * (b.getX() - a.getX()), a.getY() + share * (b.getY() - a.getY()));
        if (area.contains(at)) {
          first = first == null ? at : first;
          last = at;
        }
      }
      if (first != null && first.distance(last) > longest) {
        longest = first.distance(last);
        best =
            Optional.of(
                new Point2D.Double(
                    0.5 * (first.getX() + last.getX()), 0.5 * (first.getY() + last.getY())));
      }
    }
    return best;
  }

  /** Overlapping area [px²]. */
  static double overlap(Rectangle2D a, Rectangle2D b) {
    Rectangle2D both = a.createIntersection(b);
    return both.isEmpty() ? 0.0 : both.getWidth() * both.getHeight();
  }
}
