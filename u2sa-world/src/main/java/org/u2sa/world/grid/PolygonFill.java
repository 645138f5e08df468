package org.u2sa.world.grid;

import java.util.Arrays;

/**
 * Fills a polygon in a raster row by row: collects the crossings of its edges with the centre line
 * of each row and reports the spans between them (scan-line conversion; Foley et al., Computer
 * Graphics, 2nd ed., section 3.6). A cell is inside if its centre is, by the non-zero winding rule.
 */
final class PolygonFill {
  /** Receives a span of cells of a row, both columns inclusive. */
  @FunctionalInterface
  interface Span {
    void fill(int row, int from, int to);
  }

  private static final int NONE = -1;

  private final int side;
  private final int[] first; // first crossing of each row
  private int[] next = new int[4_096];
  private double[] at = new double[4_096]; // column of each crossing
  private byte[] senses = new byte[4_096]; // +1: upward edge, -1: downward edge
  private double[] sorted = new double[16];
  private byte[] turned = new byte[16];
  private int count;
  private int low;
  private int high;

  PolygonFill(int side) {
    this.side = side;
    first = new int[side];
    Arrays.fill(first, NONE);
    begin();
  }

  private void begin() {
    count = 0;
    low = side;
    high = -1;
  }

  /** Adds an edge, in fractional columns and rows. */
  void edge(double x0, double y0, double x1, double y1) {
    if (y0 > y1) {
      cross(x1, y1, x0, y0, -1);
    } else {
      cross(x0, y0, x1, y1, 1);
    }
  }

  private void cross(double x0, double y0, double x1, double y1, int sense) {
    int from = Math.max(0, (int) Math.ceil(y0 - 0.5));
    int to = Math.min(side, (int) Math.ceil(y1 - 0.5)); // a corner on a centre line counts once
    if (from >= to) {
      return;
    }
    low = Math.min(low, from);
    high = Math.max(high, to - 1);
    double slope = (x1 - x0) / (y1 - y0);
    double x = x0 + (from + 0.5 - y0) * slope;
    while (count + to - from > at.length) {
      at = Arrays.copyOf(at, 2 * at.length);
      next = Arrays.copyOf(next, 2 * next.length);
      senses = Arrays.copyOf(senses, 2 * senses.length);
    }
    for (int row = from; row < to; row++) {
      at[count] = x;
      senses[count] = (byte) sense;
      next[count] = first[row];
      first[row] = count++;
      x += slope;
    }
  }

  /** Reports all spans inside the edges and removes the edges. */
  void fill(Span span) {
    for (int row = low; row <= high; row++) {
      int crossings = sort(row);
      int turns = 0;
      for (int i = 0; i + 1 < crossings; i++) {
        turns += turned[i];
        if (turns == 0) {
          continue; // outside
        }
        int from = Math.max(0, (int) Math.ceil(sorted[i] - 0.5));
        int to = Math.min(side, (int) Math.ceil(sorted[i + 1] - 0.5)) - 1;
        if (from <= to) {
          span.fill(row, from, to);
        }
      }
    }
    begin();
  }

  /** Sorts a row's crossings from left to right, removes them and returns their number. */
  private int sort(int row) {
    int n = 0;
    for (int k = first[row]; k != NONE; k = next[k]) {
      if (n == sorted.length) {
        sorted = Arrays.copyOf(sorted, 2 * n);
        turned = Arrays.copyOf(turned, 2 * n);
      }
      double x = at[k];
      int i = n++;
      for (; i > 0 && sorted[i - 1] > x; i--) {
        sorted[i] = sorted[i - 1];
        turned[i] = turned[i - 1];
      }
      sorted[i] = x;
      turned[i] = senses[k];
    }
    first[row] = NONE;
    return n;
  }
}
