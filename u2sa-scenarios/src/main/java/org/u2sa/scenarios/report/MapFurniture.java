package org.u2sa.scenarios.report;

import java.util.List;
import java.util.Locale;
import org.u2sa.gcs.draw.Canvas;
import org.u2sa.gcs.draw.Canvas.Pixel;
import org.u2sa.gcs.draw.ColourScale;
import org.u2sa.gcs.draw.PixelBox;
import org.u2sa.gcs.draw.Stroke;
import org.u2sa.gcs.draw.TextStyle.Anchor;
import org.u2sa.gcs.draw.Ticks;

/** The map's arrow, scale bar and key of colours, in the corners of its frame. */
final class MapFurniture {

  private static final double INSET = 18.0;
  private static final double BAR_SHARE = 0.10; // least share of the map's width for the scale bar
  private static final double KEY_WIDTH = 240.0;
  private static final double KEY_HEIGHT = 58.0;

  private final Canvas canvas;
  private final MapView view;
  private final PixelBox arrow;
  private final PixelBox bar;
  private final double barM;
  private final PixelBox key;

  MapFurniture(Canvas canvas, MapView view) {
    this.canvas = canvas;
    this.view = view;
    PixelBox frame = view.frame();
    arrow = new PixelBox(frame.right() - INSET - 30.0, frame.y() + INSET, 30.0, 56.0);
    barM = Ticks.stepFor(view.widthM() * BAR_SHARE);
    double length = barM * view.pixelsPerMetre();
    bar = new PixelBox(frame.x() + INSET, frame.bottom() - INSET - 34.0, length + 24.0, 34.0);
    key =
        new PixelBox(
            frame.right() - INSET - KEY_WIDTH,
            frame.bottom() - INSET - KEY_HEIGHT,
            KEY_WIDTH,
            KEY_HEIGHT);
  }

  /** What other things on the map should stay off. */
  List<PixelBox> boxes() {
    return List.of(arrow, bar, key);
  }

  void draw(Quantity colour) {
    north();
    scale();
    colourKey(colour);
  }

  private void north() {
    double x = arrow.x() + arrow.width() / 2.0;
    double top = arrow.y() + 20.0;
    canvas.text(x, arrow.y() + 13.0, "N", Ink.HEADING.anchored(Anchor.MIDDLE));
    canvas.polygon(
        List.of(
            new Pixel(x, top),
            new Pixel(x + 9.0, top + 32.0),
            new Pixel(x, top + 25.0),
            new Pixel(x - 9.0, top + 32.0)),
        Ink.TEXT);
  }

  private void scale() {
    double left = bar.x() + 12.0;
    double right = bar.right() - 12.0;
    double y = bar.bottom() - 8.0;
    canvas.rectangle(bar, Ink.PANEL_VEIL, null);
    Stroke stroke = Stroke.solid(Ink.TEXT, 2.0);
    canvas.polyline(
        List.of(
            new Pixel(left, y - 6.0),
            new Pixel(left, y),
            new Pixel(right, y),
            new Pixel(right, y - 6.0)),
        stroke);
    canvas.text((left + right) / 2.0, y - 9.0, length(barM), Ink.TICK.anchored(Anchor.MIDDLE));
  }

  private static String length(double metres) {
    return metres >= 1000.0
        ? String.format(Locale.ROOT, "%.0f km", metres / 1000.0)
        : String.format(Locale.ROOT, "%.0f m", metres);
  }

  private void colourKey(Quantity colour) {
    canvas.rectangle(key, Ink.PANEL_VEIL, null);
    double left = key.x() + 12.0;
    double width = key.width() - 24.0;
    double cell = width / ColourScale.STEPS;
    canvas.text(
        key.x() + key.width() / 2.0,
        key.y() + 15.0,
        colour.name(),
        Ink.TICK.anchored(Anchor.MIDDLE));
    for (int step = 0; step < ColourScale.STEPS; step++) {
      canvas.rectangle(
          new PixelBox(left + step * cell, key.y() + 22.0, cell + 0.3, 12.0),
          ColourScale.colour(step),
          null);
    }
    canvas.text(left, key.bottom() - 8.0, colour.text(colour.low()), Ink.TICK);
    canvas.text(
        left + width,
        key.bottom() - 8.0,
        colour.text(colour.high()),
        Ink.TICK.anchored(Anchor.END));
  }
}
