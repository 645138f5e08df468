package org.u2sa.vision.line;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.u2sa.vision.ground.GroundView;
import org.u2sa.vision.ground.TopView;
import org.u2sa.vision.line.PaintFinder.PaintedDisc;
import org.u2sa.vision.picture.Shades;

/**
 * Detects white discs of a known size: brighter and paler inside than on all four sides, of about
 * the right size, and filled. Reuses its buffers.
 */
final class DiscFinder {
  private static final double COARSE_M = 0.08;
  private static final double MIN_CONTRAST = 0.35; // minimum brightness ratio, in octaves
  private static final double GREYISH = 25.0;
  private static final double PALER = 0.65;
  private static final double FILLED =
      0.72; // minimum fraction of its bounding circle; 1 for a disc
  private static final double OFF_SIZE = 0.40; // relative radius tolerance

  private final TopView.Area area;
  private final double radiusM;
  private final boolean[] taken;
  private final int[] stack;

  DiscFinder(TopView.Area area, double radiusM) {
    this.area = area;
    this.radiusM = radiusM;
    taken = new boolean[area.rows() * area.columns()];
    stack = new int[taken.length];
  }

  List<PaintedDisc> find(PaintMap map, TopView top, GroundView view) {
    Arrays.fill(taken, false);
    List<PaintedDisc> discs = new ArrayList<>();
    int step = Math.max(1, (int) Math.round(COARSE_M / area.cellM()));
    for (int row = 0; row < area.rows(); row += step) {
      for (int column = 0; column < area.columns(); column += step) {
        if (!taken[row * area.columns() + column] && looksLike(map, row, column)) {
          grow(map, top, row, column, view, discs);
        }
      }
    }
    return discs;
  }

  /** Whether the centre is brighter and paler than its four sides, of which two must be visible. */
  private boolean looksLike(PaintMap map, int row, int column) {
    int inner = (int) Math.round(0.5 * radiusM / area.cellM());
    double middle = mean(map.sums(), row, column, inner);
    if (middle < 0.0) {
      return false;
    }
    return middle - ground(map.sums(), row, column) >= Shades.OCTAVE * MIN_CONTRAST
        && isPale(map, row, column, inner);
  }

  private boolean isPale(PaintMap map, int row, int column, int inner) {
    double tint = mean(map.tints(), row, column, inner);
    return tint <= GREYISH || tint <= PALER * ground(map.tints(), row, column);
  }

  /** Mean of the surrounding patches; infinite if too few are visible. */
  private double ground(SummedArea sums, int row, int column) {
    int off = (int) Math.round(1.7 * radiusM / area.cellM());
    int half = Math.max(1, (int) Math.round(0.3 * radiusM / area.cellM()));
    double sum = 0.0;
    int seen = 0;
    for (int side = 0; side < 4; side++) {
      int away = side % 2 == 0 ? off : -off;
      double each = mean(sums, row + (side < 2 ? away : 0), column + (side < 2 ? 0 : away), half);
      if (each >= 0.0) {
        sum += each;
        seen++;
      }
    }
    return seen < 2 ? Double.POSITIVE_INFINITY : sum / seen;
  }

  private static double mean(SummedArea sums, int row, int column, int half) {
    int all = (2 * half + 1) * (2 * half + 1);
    return sums.mean(row - half, column - half, row + half + 1, column + half + 1, (all + 1) / 2);
  }

  /** Grows the region over all cells closer to the disc's brightness than to the ground's. */
  private void grow(
      PaintMap map, TopView top, int row, int column, GroundView view, List<PaintedDisc> discs) {
    int inner = (int) Math.round(0.5 * radiusM / area.cellM());
    double least = 0.5 * (mean(map.sums(), row, column, inner) + ground(map.sums(), row, column));
    int most = (int) (16.0 * radiusM * radiusM / (area.cellM() * area.cellM()));
    int depth = 0;
    int count = 0;
    double sumX = 0.0;
    double sumY = 0.0;
    double squares = 0.0;
    int first = row * area.columns() + column;
    if (!isBright(top, first, least)) {
      return;
    }
    taken[first] = true;
    stack[depth++] = first;
    while (depth > 0 && count <= most) {
      int at = stack[--depth];
      int x = at % area.columns();
      int y = at / area.columns();
      count++;
      sumX += x;
      sumY += y;
      squares += (double) x * x + (double) y * y;
      for (int side = 0; side < 4; side++) {
        int nextX = x + (side == 0 ? 1 : side == 1 ? -1 : 0);
        int nextY = y + (side == 2 ? 1 : side == 3 ? -1 : 0);
        int next = nextY * area.columns() + nextX;
        if (nextX >= 0
            && nextY >= 0
            && nextX < area.columns()
            && nextY < area.rows()
            && !taken[next]
            && isBright(top, next, least)) {
          taken[next] = true;
          stack[depth++] = next;
        }
      }
    }
    double meanX = sumX / count;
    double meanY = sumY / count;
    double spread = squares / count - meanX * meanX - meanY * meanY;
    double radius = Math.sqrt(count / Math.PI) * area.cellM();
    double round = count / Math.PI / Math.max(1.0, 2.0 * spread); // 1 for a disc, less for others
    if (count <= most && Math.abs(radius - radiusM) <= OFF_SIZE * radiusM && round >= FILLED) {
      discs.add(new PaintedDisc(view.onGround(top.forwardM(meanY), top.rightM(meanX)), radius));
    }
  }

  private static boolean isBright(TopView top, int at, double least) {
    return top.seen()[at] && (top.white()[at] & 0xFF) >= least;
  }
}
