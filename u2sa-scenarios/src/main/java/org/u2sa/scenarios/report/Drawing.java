package org.u2sa.scenarios.report;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/**
 * Draws on any Graphics2D, an image or an SVG file. The origin is the upper left corner, y grows
 * downwards, lengths are pixels; what is drawn later lies above.
 */
final class Drawing {
  private static final FontRenderContext FONTS = new FontRenderContext(null, true, true);

  /** A line's colour, width [px] and dash length [px], 0 for solid. */
  record Pen(Color color, double width, double dash) {
    static Pen solid(Color color, double width) {
      return new Pen(color, width, 0.0);
    }
  }

  /** How text looks. */
  record Type(Color color, Font font) {
    /** Width of {@code text} [px]. */
    double widthOf(String text) {
      return font.getStringBounds(text, FONTS).getWidth();
    }
  }

  /** Which part of a text stands at its x. */
  enum Anchor {
    START(0.0),
    MIDDLE(0.5),
    END(1.0);

    private final double share; // of the width that is left of x

    Anchor(double share) {
      this.share = share;
    }
  }

  private final Graphics2D graphics;

  Drawing(Graphics2D graphics) {
    this.graphics = graphics;
  }

  /** An open line through {@code points}; nothing if fewer than two. */
  void polyline(List<Point2D.Double> points, Pen pen) {
    if (points.size() >= 2) {
      draw(path(points), null, pen);
    }
  }

  /** A filled area within {@code points}, without an edge; nothing if fewer than three. */
  void polygon(List<Point2D.Double> points, Color fill) {
    if (points.size() >= 3) {
      Path2D path = path(points);
      path.closePath();
      draw(path, fill, null);
    }
  }

  void line(double x1, double y1, double x2, double y2, Pen pen) {
    draw(new Line2D.Double(x1, y1, x2, y2), null, pen);
  }

  void circle(double x, double y, double radius, Color fill, Pen edge) {
    draw(new Ellipse2D.Double(x - radius, y - radius, 2.0 * radius, 2.0 * radius), fill, edge);
  }

  /** A shape. @param fill null: empty. @param edge null: none */
  void draw(Shape shape, Color fill, Pen edge) {
    if (fill != null) {
      graphics.setColor(fill);
      graphics.fill(shape);
    }
    if (edge != null) {
      float[] dash = edge.dash() > 0.0 ? new float[] {(float) edge.dash()} : null;
      graphics.setStroke(
          new BasicStroke(
              (float) edge.width(),
              BasicStroke.CAP_ROUND,
              BasicStroke.JOIN_ROUND,
              1.0f,
              dash,
              0.0f));
      graphics.setColor(edge.color());
      graphics.draw(shape);
    }
  }

  /** One line of text on the base line y, from x to the right. */
  void text(double x, double y, String text, Type type) {
    text(x, y, text, type, Anchor.START);
  }

  /** One line of text on the base line y. */
  void text(double x, double y, String text, Type type, Anchor anchor) {
    if (!text.isEmpty()) { // Java 2D lays no empty text out
      graphics.setFont(type.font());
      graphics.setColor(type.color());
      graphics.drawString(text, (float) (x - anchor.share * type.widthOf(text)), (float) y);
    }
  }

  /** Draws {@code content} cut off outside {@code box}. */
  void clipped(Rectangle2D.Double box, Runnable content) {
    Shape before = graphics.getClip();
    graphics.clip(box);
    try {
      content.run();
    } finally {
      graphics.setClip(before);
    }
  }

  private static Path2D path(List<Point2D.Double> points) {
    Path2D path = new Path2D.Double();
    path.moveTo(points.get(0).x, points.get(0).y);
    points.stream().skip(1).forEach(p -> path.lineTo(p.x, p.y));
    return path;
  }
}
