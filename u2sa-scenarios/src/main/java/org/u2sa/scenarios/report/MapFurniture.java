package org.u2sa.scenarios.report;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.Locale;
import org.u2sa.scenarios.report.Drawing.Anchor;
import org.u2sa.scenarios.report.Drawing.Pen;

/** The map's arrow, scale bar and key of colours, in the corners of its frame. */
final class MapFurniture {

  private static final double INSET = 18.0;
  private static final double BAR_SHARE = 0.10; // least share of the map's width for the scale bar
  private static final double KEY_WIDTH = 240.0;
  private static final double KEY_HEIGHT = 58.0;

  private final Drawing drawing;
  private final MapView view;
  private final Rectangle2D.Double arrow;
  private final Rectangle2D.Double bar;
  private final double barM;
  private final Rectangle2D.Double key;

  MapFurniture(Drawing drawing, MapView view) {
    this.drawing = drawing;
    this.view = view;
    Rectangle2D.Double frame = view.frame();
    arrow = new Rectangle2D.Double(frame.getMaxX() - INSET - 30.0, frame.y + INSET, 30.0, 56.0);
    barM = Ticks.stepFor(view.widthM() * BAR_SHARE);
    double length = barM * view.pixelsPerMetre();
    bar =
        new Rectangle2D.Double(
            frame.x + INSET, frame.getMaxY() - INSET - 34.0, length + 24.0, 34.0);
    key =
        new Rectangle2D.Double(
            frame.getMaxX() - INSET - KEY_WIDTH,
            frame.getMaxY() - INSET - KEY_HEIGHT,
            KEY_WIDTH,
            KEY_HEIGHT);
  }

  /** What other things on the map should stay off. */
  List<Rectangle2D.Double> boxes() {
    return List.of(arrow, bar, key);
  }

  void draw(Quantity colour) {
    north();
    scale();
    colourKey(colour);
  }

  private void north() {
    double x = arrow.x + arrow.width / 2.0;
    double top = arrow.y + 20.0;
    drawing.text(x, arrow.y + 13.0, "N", Ink.HEADING, Anchor.MIDDLE);
    drawing.polygon(
        List.of(
            new Point2D.Double(x, top),
            new Point2D.Double(x + 9.0, top + 32.0),
            new Point2D.Double(x, top + 25.0),
            new Point2D.Double(x - 9.0, top + 32.0)),
        Ink.TEXT);
  }

  private void scale() {
    double left = bar.x + 12.0;
    double right = bar.getMaxX() - 12.0;
    double y = bar.getMaxY() - 8.0;
    drawing.draw(bar, Ink.PANEL_VEIL, null);
    Pen stroke = Pen.solid(Ink.TEXT, 2.0);
    drawing.polyline(
        List.of(
            new Point2D.Double(left, y - 6.0),
            new Point2D.Double(left, y),
            new Point2D.Double(right, y),
            new Point2D.Double(right, y - 6.0)),
        stroke);
    drawing.text((left + right) / 2.0, y - 9.0, length(barM), Ink.TICK, Anchor.MIDDLE);
  }

  private static String length(double metres) {
    return metres >= 1000.0
        ? String.format(Locale.ROOT, "%.0f km", metres / 1000.0)
        : String.format(Locale.ROOT, "%.0f m", metres);
  }

  private void colourKey(Quantity colour) {
    drawing.draw(key, Ink.PANEL_VEIL, null);
    double left = key.x + 12.0;
    double width = key.width - 24.0;
    double cell = width / ColourScale.STEPS;
    drawing.text(key.x + key.width / 2.0, key.y + 15.0, colour.name(), Ink.TICK, Anchor.MIDDLE);
    for (int step = 0; step < ColourScale.STEPS; step++) {
      drawing.draw(
          new Rectangle2D.Double(left + step * cell, key.y + 22.0, cell + 0.3, 12.0),
          ColourScale.colour(step),
          null);
    }
    drawing.text(left, key.getMaxY() - 8.0, colour.text(colour.low()), Ink.TICK);
    drawing.text(
        left + width, key.getMaxY() - 8.0, colour.text(colour.high()), Ink.TICK, Anchor.END);
  }
}
