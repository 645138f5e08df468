package org.u2sa.scenarios.fields;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;

/** Draws a field and the track through it. */
final class FieldPicture {
  private static final int SIZE = 700;

  private FieldPicture() {}

  static void write(Path file, RandomField field, FieldResult result) {
    BufferedImage image = new BufferedImage(SIZE, SIZE, BufferedImage.TYPE_INT_RGB);
    double scale = SIZE / field.kind.sideM();
    for (int y = 0; y < SIZE; y++) {
      for (int x = 0; x < SIZE; x++) {
        boolean full = field.distanceM(x / scale, (SIZE - 1 - y) / scale) == 0.0;
        image.setRGB(x, y, full ? 0x404040 : 0xf4f4f0);
      }
    }
    Graphics2D g = image.createGraphics();
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setStroke(new BasicStroke(1.5f));
    for (RandomField.Traffic other : field.traffic) {
      g.setColor(new Color(200, 120, 0));
      for (double t = 0.0; t < 60.0; t += 1.0) {
        dot(g, other.eastM(t) * scale, SIZE - other.northM(t) * scale, 2.0);
      }
      double r = other.radiusM * scale;
      dot(g, other.eastM(result.simS()) * scale, SIZE - other.northM(result.simS()) * scale, r);
    }
    g.setColor(result.contacts().isEmpty() ? new Color(0, 90, 200) : Color.RED);
    List<double[]> track = result.track();
    for (int i = 1; i < track.size(); i++) {
      g.draw(
          new Line2D.Double(
              track.get(i - 1)[0] * scale,
              SIZE - track.get(i - 1)[1] * scale,
              track.get(i)[0] * scale,
              SIZE - track.get(i)[1] * scale));
    }
    g.setColor(new Color(0, 150, 0));
    dot(g, field.startEast * scale, SIZE - field.startNorth * scale, 5.0);
    g.setColor(Color.MAGENTA);
    dot(g, field.goalEast * scale, SIZE - field.goalNorth * scale, 5.0);
    g.dispose();
    try {
      Files.createDirectories(file.getParent());
      ImageIO.write(image, "png", file.toFile());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void dot(Graphics2D g, double x, double y, double radius) {
    g.fill(new Ellipse2D.Double(x - radius, y - radius, 2.0 * radius, 2.0 * radius));
  }
}
