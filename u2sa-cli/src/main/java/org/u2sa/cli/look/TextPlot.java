package org.u2sa.cli.look;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * Draws series of one unit with Braille characters of two by four dots. Where lines overlap, the
 * later series determines the colour.
 */
final class TextPlot {
  private static final char EMPTY = '\u2800';
  private static final int DOTS_ACROSS = 2;
  private static final int DOTS_DOWN = 4;

  /** Bits of a Braille character's dots, row-major (Unicode, chapter 21.1). */
  private static final int[] DOT_BITS = {0x01, 0x08, 0x02, 0x10, 0x04, 0x20, 0x40, 0x80};

  private static final String[] COLOURS = {"36", "33", "35", "32", "34", "31"};

  private final int columns;
  private final int rows;
  private final boolean colours;
  private final char[][] cells;
  private final int[][] owner; // index of the series that drew there last

  /** Creates a plot with this many columns, excluding labels. */
  TextPlot(int columns, int rows, boolean colours) {
    this.columns = columns;
    this.rows = rows;
    this.colours = colours;
    cells = new char[rows][columns];
    owner = new int[rows][columns];
    for (char[] row : cells) {
      Arrays.fill(row, EMPTY);
    }
  }

  /** Draws the series between the two times, with a labelled value axis. */
  List<String> lines(List<Series> series, double fromS, double toS) {
    double lowest = Double.POSITIVE_INFINITY;
    double highest = Double.NEGATIVE_INFINITY;
    for (Series each : series) {
      for (Series.Sample sample : each.samples()) {
        lowest = Math.min(lowest, sample.value());
        highest = Math.max(highest, sample.value());
      }
    }
    if (lowest > highest) {
      return List.of("(nothing yet)");
    }
    Axis values = Axis.around(lowest, highest);
    Axis times = new Axis(fromS, toS);
    for (int i = 0; i < series.size(); i++) {
      draw(series.get(i).samples(), i, times, values);
    }
    return labelled(values, legend(series));
  }

  private void draw(List<Series.Sample> samples, int index, Axis times, Axis values) {
    int lastX = 0;
    int lastY = 0;
    for (int i = 0; i < samples.size(); i++) {
      int x = (int) Math.round(times.share(samples.get(i).timeS()) * (columns * DOTS_ACROSS - 1));
      int y = (int) Math.round((1 - values.share(samples.get(i).value())) * (rows * DOTS_DOWN - 1));
      line(i == 0 ? x : lastX, i == 0 ? y : lastY, x, y, index);
      lastX = x;
      lastY = y;
    }
  }

  private void line(int fromX, int fromY, int toX, int toY, int index) {
    int steps = Math.max(1, Math.max(Math.abs(toX - fromX), Math.abs(toY - fromY)));
    for (int i = 0; i <= steps; i++) {
      dot(fromX + (toX - fromX) * i / steps, fromY + (toY - fromY) * i / steps, index);
    }
  }

  private void dot(int x, int y, int index) {
    if (x < 0 || y < 0 || x >= columns * DOTS_ACROSS || y >= rows * DOTS_DOWN) {
      return;
    }
    int bit = DOT_BITS[y % DOTS_DOWN * DOTS_ACROSS + x % DOTS_ACROSS];
    cells[y / DOTS_DOWN][x / DOTS_ACROSS] |= (char) bit;
    owner[y / DOTS_DOWN][x / DOTS_ACROSS] = index;
  }

  private String legend(List<Series> series) {
    StringBuilder legend = new StringBuilder();
    for (int i = 0; i < series.size(); i++) {
      Series each = series.get(i);
      List<Series.Sample> samples = each.samples();
      String newest =
          samples.isEmpty() ? "-" : String.valueOf(samples.get(samples.size() - 1).value());
      legend.append(i == 0 ? "" : "   ").append(coloured("━━ ", i)).append(each.name());
      legend.append(" ").append(newest);
      legend.append(each.unit().isEmpty() ? "" : " " + each.unit());
    }
    return legend.toString();
  }

  private List<String> labelled(Axis values, String legend) {
    List<String> lines = new ArrayList<>();
    lines.add(legend);
    int width = Math.max(values.label(values.from()).length(), values.label(values.to()).length());
    for (int row = 0; row < rows; row++) {
      boolean marked = row == 0 || row == rows - 1 || row == rows / 2;
      double value = values.to() - (values.to() - values.from()) * row / Math.max(1, rows - 1);
      String label = marked ? values.label(value) : "";
      StringBuilder line = new StringBuilder(" ".repeat(width - label.length()) + label + " ┤");
      for (int column = 0; column < columns; column++) {
        String cell = String.valueOf(cells[row][column]);
        line.append(cells[row][column] == EMPTY ? cell : coloured(cell, owner[row][column]));
      }
      lines.add(line.toString());
    }
    return lines;
  }

  private String coloured(String text, int index) {
    return colours ? "\u001b[" + COLOURS[index % COLOURS.length] + "m" + text + "\u001b[0m" : text;
  }

  /**
   * Range of an axis, with tick marks.
   *
   * @param from lower end
   * @param to upper end, above the lower
   */
  record Axis(double from, double to) {
    private static final double MARGIN = 0.05;

    /** Creates an axis that covers the given range; a single value gets margins. */
    static Axis around(double lowest, double highest) {
      double span = highest - lowest;
      double least = Math.max(1e-9, 1e-6 * Math.max(Math.abs(lowest), Math.abs(highest)));
      double room =
          span < least
              ? Math.max(least, 0.5 * Math.max(1e-3, Math.abs(highest) * 1e-3))
              : span * MARGIN;
      return new Axis(lowest - room, highest + room);
    }

    /** Relative position of a value, from 0 at the lower end to 1 at the upper. */
    double share(double value) {
      return (value - from) / (to - from);
    }

    /** Formats a value with just enough digits to distinguish neighbouring marks. */
    String label(double value) {
      int digits = (int) Math.ceil(-Math.log10((to - from) / 100.0));
      return String.format(Locale.ROOT, "%." + Math.max(0, Math.min(9, digits)) + "f", value);
    }
  }
}
