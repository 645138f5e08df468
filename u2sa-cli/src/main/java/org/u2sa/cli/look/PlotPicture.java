package org.u2sa.cli.look;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.imageio.ImageIO;
import org.u2sa.report.ReportFile;

/** Draws series as a PNG, a chart for each unit, one below the other. */
final class PlotPicture {
  private static final int WIDTH = 1000;
  private static final int CHART_HEIGHT = 320;
  private static final int LEFT = 90;
  private static final int RIGHT = 40;
  private static final int TOP = 64;
  private static final int BOTTOM = 40;
  private static final int MARKS = 6;
  private static final int LEGEND_GAP = 24;
  private static final int LEGEND_LINE = 16;
  private static final Color GRID = new Color(0xDD, 0xDD, 0xDD);
  private static final List<Color> COLOURS =
      List.of(
          new Color(0x1F, 0x77, 0xB4),
          new Color(0xD6, 0x62, 0x00),
          new Color(0x2C, 0x8A, 0x2C),
          new Color(0xC0, 0x28, 0x28),
          new Color(0x76, 0x4F, 0xA5),
          new Color(0x6B, 0x49, 0x42));

  private PlotPicture() {}

  /** Writes the charts of the given units. */
  static void write(Path file, Map<String, List<Series>> byUnit, double fromS, double toS) {
    int height = CHART_HEIGHT * Math.max(1, byUnit.size());
    BufferedImage image = new BufferedImage(WIDTH, height, BufferedImage.TYPE_INT_RGB);
    Graphics2D g = image.createGraphics();
    g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    g.setColor(Color.WHITE);
    g.fillRect(0, 0, WIDTH, height);
    g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13));
    int top = 0;
    for (Map.Entry<String, List<Series>> chart : byUnit.entrySet()) {
      draw(g, top, chart.getKey(), chart.getValue(), new Axis(fromS, toS));
      top += CHART_HEIGHT;
    }
    g.dispose();
    ReportFile.write(
        file,
        out -> {
          if (!ImageIO.write(image, "png", out)) {
            throw new IOException("this Java has no writer of PNG");
          }
        });
  }

  private static void draw(Graphics2D g, int top, String unit, List<Series> series, Axis times) {
    double lowest = Double.POSITIVE_INFINITY;
    double highest = Double.NEGATIVE_INFINITY;
    for (Series each : series) {
      for (Series.Sample sample : each.samples()) {
        lowest = Math.min(lowest, sample.value());
        highest = Math.max(highest, sample.value());
      }
    }
    if (lowest > highest) {
      return;
    }
    Axis values = Axis.around(lowest, highest);
    grid(g, top, unit, times, values);
    int legendX = LEFT;
    int legendY = top + LEGEND_LINE;
    for (int i = 0; i < series.size(); i++) {
      g.setColor(COLOURS.get(i % COLOURS.size()));
      line(g, top, series.get(i).samples(), times, values);
      int width = g.getFontMetrics().stringWidth(series.get(i).name());
      if (legendX > LEFT && legendX + width > WIDTH - RIGHT) {
        legendX = LEFT;
        legendY += LEGEND_LINE;
      }
      g.drawString(series.get(i).name(), legendX, legendY);
      legendX += width + LEGEND_GAP;
    }
  }

  private static double x(Axis times, double timeS) {
    return LEFT + times.share(timeS) * (WIDTH - LEFT - RIGHT);
  }

  private static double y(int top, Axis values, double value) {
    return top + TOP + (1 - values.share(value)) * (CHART_HEIGHT - TOP - BOTTOM);
  }

  private static void grid(Graphics2D g, int top, String unit, Axis times, Axis values) {
    g.setStroke(new BasicStroke(1f));
    for (double mark : values.marks(MARKS)) {
      int at = (int) y(top, values, mark);
      g.setColor(GRID);
      g.drawLine(LEFT, at, WIDTH - RIGHT, at);
      g.setColor(Color.DARK_GRAY);
      String label = values.label(mark);
      g.drawString(label, LEFT - 8 - g.getFontMetrics().stringWidth(label), at + 4);
    }
    for (double mark : times.marks(MARKS)) {
      int at = (int) x(times, mark);
      g.setColor(GRID);
      g.drawLine(at, top + TOP, at, top + CHART_HEIGHT - BOTTOM);
      g.setColor(Color.DARK_GRAY);
      g.drawString(
          String.format(Locale.ROOT, "%s s", times.label(mark)),
          at - 20,
          top + CHART_HEIGHT - BOTTOM + 18);
    }
    g.drawString(unit.isEmpty() ? "" : "[" + unit + "]", 8, top + LEGEND_LINE);
  }

  private static void line(
      Graphics2D g, int top, List<Series.Sample> samples, Axis times, Axis values) {
    Path2D path = new Path2D.Double();
    for (int i = 0; i < samples.size(); i++) {
      double x = x(times, samples.get(i).timeS());
      double y = y(top, values, samples.get(i).value());
      if (i == 0) {
        path.moveTo(x, y);
      } else {
        path.lineTo(x, y);
      }
    }
    g.setStroke(new BasicStroke(1.6f));
    g.draw(path);
  }
}
