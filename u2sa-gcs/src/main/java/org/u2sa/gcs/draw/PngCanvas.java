package org.u2sa.gcs.draw;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/** Draws into an image in memory, by Java 2D and without a screen; ends as a PNG file. */
public final class PngCanvas implements Canvas, AutoCloseable {

  private static final List<String> FONTS =
      List.of("Liberation Sans", "Arial", "Helvetica", "DejaVu Sans");

  private final BufferedImage image;
  private final Graphics2D graphics;
  private final String font;

  public PngCanvas(int width, int height) {
    image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
    graphics = image.createGraphics();
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    graphics.setRenderingHint(
        RenderingHints.KEY_FRACTIONALMETRICS, RenderingHints.VALUE_FRACTIONALMETRICS_ON);
    graphics.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    font = FONTS.stream().filter(PngCanvas::isInstalled).findFirst().orElse(Font.SANS_SERIF);
  }

  private static boolean isInstalled(String family) {
    return new Font(family, Font.PLAIN, 1)
        .getFamily()
        .equals(family); // Java answers Dialog for an unknown one
  }

  /**
   * Why this Java cannot draw, if it cannot: one without fonts or font libraries fails at the first
   * text, each in its own way.
   */
  public static Optional<String> obstacle() {
    try (PngCanvas probe = new PngCanvas(1, 1)) {
      probe.text(0.0, 1.0, "x", TextStyle.of(Color.BLACK, 1.0));
      return Optional.empty();
    } catch (RuntimeException | LinkageError | InternalError e) {
      return Optional.of(
          "this Java cannot draw text ("
              + e
              + "); a font may help, e.g. apt install fonts-dejavu-core");
    }
  }

  /** Writes the image as PNG. */
  public void writeTo(OutputStream out) throws IOException {
    // In memory: ImageIO's own cache file needs a shutdown hook, which an interrupted run cannot
    // have.
    try (ImageOutputStream png = new MemoryCacheImageOutputStream(out)) {
      if (!ImageIO.write(image, "png", png)) {
        throw new IOException("this Java has no writer for PNG");
      }
    }
  }

  @Override
  public void close() {
    graphics.dispose();
  }

  @Override
  public void polyline(List<Pixel> points, Stroke stroke) {
    if (points.size() >= 2) {
      paint(path(points), null, stroke);
    }
  }

  @Override
  public void polygon(List<Pixel> points, Color fill) {
    if (points.size() >= 3) {
      Path2D path = path(points);
      path.closePath();
      paint(path, fill, null);
    }
  }

  @Override
  public void circle(double x, double y, double radius, Color fill, Stroke stroke) {
    paint(new Ellipse2D.Double(x - radius, y - radius, 2.0 * radius, 2.0 * radius), fill, stroke);
  }

  @Override
  public void rectangle(PixelBox box, Color fill, Stroke stroke) {
    paint(new Rectangle2D.Double(box.x(), box.y(), box.width(), box.height()), fill, stroke);
  }

  @Override
  public void text(double x, double y, String text, TextStyle style) {
    graphics.setFont(
        new Font(font, style.bold() ? Font.BOLD : Font.PLAIN, 1).deriveFont((float) style.size()));
    graphics.setColor(style.color());
    double width = graphics.getFontMetrics().getStringBounds(text, graphics).getWidth();
    double left =
        switch (style.anchor()) {
          case START -> x;
          case MIDDLE -> x - width / 2.0;
          case END -> x - width;
        };
    graphics.drawString(text, (float) left, (float) y);
  }

  @Override
  public void clipped(PixelBox box, Runnable content) {
    Shape before = graphics.getClip();
    graphics.clip(new Rectangle2D.Double(box.x(), box.y(), box.width(), box.height()));
    try {
      content.run();
    } finally {
      graphics.setClip(before);
    }
  }

  private void paint(Shape shape, Color fill, Stroke stroke) {
    if (fill != null) {
      graphics.setColor(fill);
      graphics.fill(shape);
    }
    if (stroke != null) {
      float width = (float) stroke.width();
      float[] dash = stroke.dash() > 0.0 ? new float[] {(float) stroke.dash()} : null;
      graphics.setStroke(
          new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 1.0f, dash, 0.0f));
      graphics.setColor(stroke.color());
      graphics.draw(shape);
    }
  }

  private static Path2D path(List<Pixel> points) {
    Path2D path = new Path2D.Double();
    path.moveTo(points.get(0).x(), points.get(0).y());
    for (Pixel p : points.subList(1, points.size())) {
      path.lineTo(p.x(), p.y());
    }
    return path;
  }
}
