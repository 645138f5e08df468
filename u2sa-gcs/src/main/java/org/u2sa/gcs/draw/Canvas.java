package org.u2sa.gcs.draw;

import java.awt.Color;
import java.util.List;

/**
 * Something to draw on; the origin is the upper left corner, y grows downwards, lengths are pixels.
 * What is drawn later lies above.
 */
public interface Canvas {

  /** A point of the canvas [px]. */
  record Pixel(double x, double y) {}

  /** An open line through {@code points}; nothing if fewer than two. */
  void polyline(List<Pixel> points, Stroke stroke);

  /** A filled area within {@code points}, without an edge; nothing if fewer than three. */
  void polygon(List<Pixel> points, Color fill);

  /** A circle. @param fill null: empty. @param stroke null: no edge */
  void circle(double x, double y, double radius, Color fill, Stroke stroke);

  /** A rectangle. @param fill null: empty. @param stroke null: no edge */
  void rectangle(PixelBox box, Color fill, Stroke stroke);

  /** One line of text on the base line y. */
  void text(double x, double y, String text, TextStyle style);

  /** Draws {@code content} cut off outside {@code box}. */
  void clipped(PixelBox box, Runnable content);

  /** A straight line. */
  default void line(double x1, double y1, double x2, double y2, Stroke stroke) {
    polyline(List.of(new Pixel(x1, y1), new Pixel(x2, y2)), stroke);
  }

  /** Text on a halo of {@code background}, readable on any ground. */
  default void textOnHalo(double x, double y, String text, TextStyle style, Color background) {
    double width = style.widthOf(text);
    double left =
        switch (style.anchor()) {
          case START -> x;
          case MIDDLE -> x - width / 2.0;
          case END -> x - width;
        };
    rectangle(
        new PixelBox(left - 2.0, y - 0.8 * style.size(), width + 4.0, style.size() + 1.0),
        background,
        null);
    text(x, y, text, style);
  }
}
