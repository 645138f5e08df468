package org.u2sa.vision.line;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import org.u2sa.messages.frame.Point;
import org.u2sa.vision.ground.GroundView;
import org.u2sa.vision.ground.TopView;
import org.u2sa.vision.line.PaintFinder.PaintSettings;
import org.u2sa.vision.line.PaintFinder.PaintedLine;

/**
 * Traces paint from its strongest spots, step by step in both directions and across gaps: curves of
 * any shape become polylines along the centre of the paint. Reuses its buffers.
 */
final class LineTracer {
  private static final double STEP_M = 0.12;
  private static final double WINDOW_M = 0.10; // search window around the predicted position
  private static final double DIRECTION_M = 0.30; // window for the paint's direction
  private static final double SHARPEST = Math.cos(Math.toRadians(35.0)); // sharpest turn per step
  private static final double ELONGATION = 3.0; // min. ratio of spread along to across a line
  private static final double MIN_SUPPORT = 0.55;
  private static final int BLOCK = 6; // cells

  private final TopView.Area area;
  private final PaintSettings settings;
  private final byte[] left; // strength of paint not yet assigned to a line
  private final int[] order; // blocks by amount of paint
  private final long[] weight;
  private final double leastWeight; // minimum paint in a window
  private double middleX; // result of the last search, columns
  private double middleY;
  private double alongX;
  private double alongY;

  LineTracer(TopView.Area area, PaintSettings settings) {
    this.area = area;
    this.settings = settings;
    left = new byte[area.rows() * area.columns()];
    int blocks = (area.rows() / BLOCK + 1) * (area.columns() / BLOCK + 1);
    order = new int[blocks];
    weight = new long[blocks];
    leastWeight = 0.25 * settings.widthM() * WINDOW_M / (area.cellM() * area.cellM());
  }

  /** Lines of a map, nearest first, cut into pieces. */
  List<PaintedLine> trace(PaintMap map, TopView top, GroundView view) {
    System.arraycopy(map.strength(), 0, left, 0, left.length);
    List<PaintedLine> lines = new ArrayList<>();
    int seeds = sortBlocks();
    int across = area.columns() / BLOCK + 1;
    for (int i = 0; i < seeds; i++) {
      int row = order[i] / across * BLOCK;
      int column = order[i] % across * BLOCK;
      if (strongest(row, column)) {
        follow(top, view, lines);
      }
    }
    lines.sort(
        (a, b) ->
            Double.compare(
                a.points().get(a.points().size() / 2).distance(),
                b.points().get(b.points().size() / 2).distance()));
    return lines;
  }

  private int sortBlocks() {
    int across = area.columns() / BLOCK + 1;
    Arrays.fill(weight, 0);
    for (int row = 0; row < area.rows(); row++) {
      int base = row / BLOCK * across;
      for (int column = 0, at = row * area.columns(); column < area.columns(); column++, at++) {
        weight[base + column / BLOCK] += left[at] & 0xFF;
      }
    }
    int count = 0;
    for (int block = 0; block < weight.length; block++) {
      if (weight[block] > 0) {
        weight[count++] = weight[block] << 32 | block;
      }
    }
    Arrays.sort(weight, 0, count);
    for (int i = 0; i < count; i++) {
      order[i] = (int) weight[count - 1 - i];
    }
    return count;
  }

  /** Moves to the centre of a block's unassigned paint. */
  private boolean strongest(int row, int column) {
    double half = 0.5 * (BLOCK - 1);
    return centre(column + half, row + half, 0.5 * BLOCK + 0.5) >= leastWeight;
  }

  private void follow(TopView top, GroundView view, List<PaintedLine> lines) {
    double seedX = middleX;
    double seedY = middleY;
    if (!direction(seedX, seedY)) {
      wipe(seedX, seedY);
      return;
    }
    double dx = alongX;
    double dy = alongY;
    Deque<double[]> chain = new ArrayDeque<>();
    chain.add(new double[] {seedX, seedY});
    int[] painted = {1, 1}; // steps on paint, total steps
    extend(seedX, seedY, dx, dy, chain, true, painted);
    extend(seedX, seedY, -dx, -dy, chain, false, painted);
    chain.forEach(place -> wipe(place[0], place[1]));
    double support = (double) painted[0] / painted[1];
    double length = (chain.size() - 1) * STEP_M;
    if (length >= settings.shortestM() && support >= MIN_SUPPORT) {
      cut(new ArrayList<>(chain), support, top, view, lines);
    }
  }

  private void extend(
      double x, double y, double dx, double dy, Deque<double[]> chain, boolean last, int[] steps) {
    double step = STEP_M / area.cellM();
    int mostMissed = (int) Math.floor(settings.longestGapM() / STEP_M);
    double hereX = x;
    double hereY = y;
    double toX = dx;
    double toY = dy;
    List<double[]> bridge = new ArrayList<>(); // steps since the last one on paint
    while (bridge.size() <= mostMissed) {
      double nextX = hereX + step * toX;
      double nextY = hereY + step * toY;
      double reach = Math.min(1.0 + 0.5 * bridge.size(), 2.5) * WINDOW_M / area.cellM();
      boolean isPaint = centre(nextX, nextY, reach) >= leastWeight;
      double foundX = middleX;
      double foundY = middleY;
      double[] anchor = last ? chain.getLast() : chain.getFirst();
      double wayX = foundX - anchor[0];
      double wayY = foundY - anchor[1];
      double way = Math.hypot(wayX, wayY);
      boolean isAhead = way > 0.4 * step && (wayX * toX + wayY * toY) / way >= SHARPEST;
      if (!isPaint || !isAhead) { // no paint, or already traced
        bridge.add(new double[] {nextX, nextY});
        hereX = nextX;
        hereY = nextY;
        continue;
      }
      if (wasHere(chain, foundX, foundY, step)) {
        return;
      }
      if (direction(foundX, foundY)) {
        double sign = alongX * toX + alongY * toY < 0.0 ? -1.0 : 1.0;
        double newX = sign * alongX + toX + wayX / way;
        double newY = sign * alongY + toY + wayY / way;
        double size = Math.hypot(newX, newY);
        if (sign * (alongX * toX + alongY * toY) < SHARPEST && !bridge.isEmpty()) {
          return; // paint beyond the gap belongs to another line
        }
        toX = newX / size;
        toY = newY / size;
      } else if (!bridge.isEmpty()) {
        return;
      }
      steps[0]++;
      steps[1] += 1 + bridge.size();
      for (int i = 0; i < bridge.size(); i++) { // bridge the gap
        double share = (i + 1.0) / (bridge.size() + 1.0);
        add(chain, last, anchor[0] + share * wayX, anchor[1] + share * wayY);
      }
      bridge.clear();
      add(chain, last, foundX, foundY);
      hereX = foundX;
      hereY = foundY;
    }
  }

  private static void add(Deque<double[]> chain, boolean last, double x, double y) {
    if (last) {
      chain.addLast(new double[] {x, y});
    } else {
      chain.addFirst(new double[] {x, y});
    }
  }

  private static boolean wasHere(Deque<double[]> chain, double x, double y, double step) {
    for (double[] place : chain) {
      if (Math.hypot(place[0] - x, place[1] - y) < 0.5 * step) {
        return true;
      }
    }
    return false;
  }

  /** Removes the paint around a line's centre, so that no other line claims it. */
  private void wipe(double x, double y) {
    double reach = (0.5 * STEP_M + settings.widthM()) / area.cellM();
    for (int row = least(y - reach); row <= most(y + reach, area.rows()); row++) {
      for (int column = least(x - reach); column <= most(x + reach, area.columns()); column++) {
        left[row * area.columns() + column] = 0;
      }
    }
  }

  private static int least(double place) {
    return Math.max(0, (int) Math.ceil(place));
  }

  private static int most(double place, int count) {
    return Math.min(count - 1, (int) Math.floor(place));
  }

  /** Finds the centroid of the paint around a position; its weight is in cells of full strength. */
  private double centre(double x, double y, double reach) {
    double sum = 0.0;
    double sumX = 0.0;
    double sumY = 0.0;
    int cells = 0;
    for (int row = least(y - reach); row <= most(y + reach, area.rows()); row++) {
      for (int column = least(x - reach); column <= most(x + reach, area.columns()); column++) {
        int strength = left[row * area.columns() + column] & 0xFF;
        sum += strength;
        sumX += (double) strength * column;
        sumY += (double) strength * row;
        cells += strength > 0 ? 1 : 0;
      }
    }
    if (sum > 0.0) {
      middleX = sumX / sum;
      middleY = sumY / sum;
    }
    return cells;
  }

  /** Finds the direction of the paint around a position; false if not found. */
  private boolean direction(double x, double y) {
    double reach = DIRECTION_M / area.cellM();
    double sum = 0.0;
    double sumX = 0.0;
    double sumY = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (int row = least(y - reach); row <= most(y + reach, area.rows()); row++) {
      for (int column = least(x - reach); column <= most(x + reach, area.columns()); column++) {
        double w = left[row * area.columns() + column] & 0xFF;
        if (w > 0.0) {
          sum += w;
          sumX += w * column;
          sumY += w * row;
          xx += w * column * column;
          xy += w * column * row;
          yy += w * row * row;
        }
      }
    }
    if (sum <= 0.0) {
      return false;
    }
    double meanX = sumX / sum;
    double meanY = sumY / sum;
    double a = xx / sum - meanX * meanX;
    double b = xy / sum - meanX * meanY;
    double c = yy / sum - meanY * meanY;
    double root = Math.sqrt(0.25 * (a - c) * (a - c) + b * b);
    double large = 0.5 * (a + c) + root;
    double small = Math.max(0.5 * (a + c) - root, 1.0 / 12.0);
    double angle = 0.5 * Math.atan2(2.0 * b, a - c);
    alongX = Math.cos(angle);
    alongY = Math.sin(angle);
    return Math.sqrt(large / small) >= ELONGATION;
  }

  private void cut(
      List<double[]> chain, double support, TopView top, GroundView view, List<PaintedLine> lines) {
    for (List<Point> points : UprightThings.cutOut(smooth(chain, top, view), view.camera())) {
      double length = (points.size() - 1) * STEP_M;
      if (length < settings.shortestM()) {
        continue;
      }
      int pieces = Math.max(1, (int) Math.ceil(length / settings.pieceM()));
      for (int piece = 0; piece < pieces; piece++) {
        int from = piece * (points.size() - 1) / pieces;
        int to = (piece + 1) * (points.size() - 1) / pieces;
        List<Point> own = new ArrayList<>(points.subList(from, to + 1));
        if (own.get(0).distance() > own.get(own.size() - 1).distance()) {
          Collections.reverse(own); // near to far
        }
        lines.add(new PaintedLine(List.copyOf(own), support));
      }
    }
  }

  /** Smooths by a three-point mean against cell quantisation, keeping the ends. */
  private static List<Point> smooth(List<double[]> chain, TopView top, GroundView view) {
    List<Point> points = new ArrayList<>(chain.size());
    for (int i = 0; i < chain.size(); i++) {
      double[] here = chain.get(i);
      double x = here[0];
      double y = here[1];
      if (i > 0 && i < chain.size() - 1) {
        double[] before = chain.get(i - 1);
        double[] after = chain.get(i + 1);
        x = 0.25 * before[0] + 0.5 * x + 0.25 * after[0];
        y = 0.25 * before[1] + 0.5 * y + 0.25 * after[1];
      }
      points.add(view.onGround(top.forwardM(y), top.rightM(x)));
    }
    return points;
  }
}
