package org.u2sa.vision.line;

import java.util.Arrays;
import org.u2sa.vision.ground.TopView;
import org.u2sa.vision.line.PaintFinder.PaintSettings;
import org.u2sa.vision.picture.Shades;

/**
 * Likelihood of each ground cell to be the centre of a painted line: brighter than the ground on
 * both sides at a line's width, along rows or along columns (symmetrical local threshold: Veit et
 * al., Evaluation of Road Marking Feature Extraction, IEEE ITSC 2008). Shadow edges are brighter on
 * one side only, glare is too wide, and a strip as coloured as its surroundings is light rather
 * than paint. Reuses its buffers.
 */
final class PaintMap {
  private static final double MAD_TO_SIGMA = 1.4826;
  private static final double BAND_M = 1.0; // distance band for measuring roughness
  private static final double GREYISH = 20.0; // max. tint of white paint in any light
  private static final double PALER = 0.65; // of the surroundings' tint: paint in tinted light

  private final TopView.Area area;
  private final int half; // cells from the paint's centre to its edge, rounded up
  private final int guard; // cells from the centre to the ground
  private final int side; // cells of ground compared on each side
  private final double leastContrast;
  private final double noiseFactor;
  private final SummedArea sums;
  private final SummedArea tints;
  private final byte[] strength;
  private final int[] histogram = new int[512];

  PaintMap(TopView.Area area, PaintSettings settings) {
    this.area = area;
    double cells = settings.widthM() / area.cellM();
    half = Math.max(1, (int) Math.round(0.5 * (cells - 1.0)));
    guard = half + 1 + Math.max(1, (int) Math.round(0.3 * cells));
    side = Math.max(3, (int) Math.round(2.0 * cells));
    leastContrast = Shades.OCTAVE * Math.log(1.0 + settings.contrast()) / Math.log(2.0);
    noiseFactor = settings.noiseFactor();
    sums = new SummedArea(area);
    tints = new SummedArea(area);
    strength = new byte[area.rows() * area.columns()];
  }

  void look(TopView view) {
    sums.take(view.white(), view.seen());
    tints.take(view.tint(), view.seen());
    int band = Math.max(1, (int) Math.round(BAND_M / area.cellM()));
    for (int row = 0; row < area.rows(); row += band) {
      int end = Math.min(area.rows(), row + band);
      double threshold = Math.max(leastContrast, noiseFactor * roughness(row, end));
      for (int r = row; r < end; r++) {
        look(view, r, threshold);
      }
    }
  }

  /** Standard deviation of the difference of two adjacent ground patches. */
  private double roughness(int fromRow, int toRow) {
    Arrays.fill(histogram, 0);
    int all = 0;
    for (int row = fromRow; row < toRow; row += 2) {
      for (int column = guard + side; column < area.columns() - half; column += 3) {
        double middle = mean(row, column, half, true);
        double left = sideMean(row, column, -1, true);
        if (middle >= 0.0 && left >= 0.0) {
          histogram[Math.min(511, (int) Math.round(Math.abs(middle - left)))]++;
          all++;
        }
      }
    }
    int count = 0;
    for (int difference = 0; difference < histogram.length; difference++) {
      count += histogram[difference];
      if (2 * count > all) {
        return MAD_TO_SIGMA * difference;
      }
    }
    return 0.0;
  }

  private void look(TopView view, int row, double threshold) {
    for (int column = 0; column < area.columns(); column++) {
      int at = row * area.columns() + column;
      strength[at] = 0;
      if (!view.seen()[at]) {
        continue;
      }
      double middle = mean(row, column, half, true);
      double most = response(middle, row, column, true);
      middle = half == 1 ? middle : mean(row, column, half, false); // the same square
      most = Math.max(most, response(middle, row, column, false));
      if (most >= threshold) {
        strength[at] = (byte) Math.min(255.0, most);
      }
    }
  }

  /** Contrast of the centre over the brighter side; 0 if not paint. */
  private double response(double middle, int row, int column, boolean alongRow) {
    double left = sideMean(row, column, -1, alongRow);
    if (middle < 0.0 || left < 0.0 || middle - left < leastContrast) {
      return 0.0;
    }
    double right = sideMean(row, column, 1, alongRow);
    double response = middle - Math.max(left, right);
    if (right < 0.0 || response < leastContrast || !isPale(row, column, alongRow)) {
      return 0.0;
    }
    return response;
  }

  private boolean isPale(int row, int column, boolean alongRow) {
    double middle = tint(row, column, 0, 0, alongRow);
    if (middle <= GREYISH) {
      return true;
    }
    double left = tint(row, column, -guard - side + 1, -guard, alongRow);
    double right = tint(row, column, guard, guard + side - 1, alongRow);
    return middle <= PALER * 0.5 * (left + right);
  }

  /** Mean shade of a patch around the centre; -1 if not visible. */
  private double mean(int row, int column, int reach, boolean alongRow) {
    return patch(sums, row, column, -reach, reach, alongRow, 1);
  }

  private double sideMean(int row, int column, int direction, boolean alongRow) {
    return direction < 0
        ? patch(sums, row, column, -guard - side + 1, -guard, alongRow, side)
        : patch(sums, row, column, guard, guard + side - 1, alongRow, side);
  }

  private double tint(int row, int column, int from, int to, boolean alongRow) {
    return patch(tints, row, column, from, to, alongRow, 1);
  }

  private static double patch(
      SummedArea of, int row, int column, int from, int to, boolean alongRow, int least) {
    int top = alongRow ? row - 1 : row + from;
    int bottom = alongRow ? row + 2 : row + to + 1;
    int left = alongRow ? column + from : column - 1;
    int right = alongRow ? column + to + 1 : column + 2;
    return of.mean(top, left, bottom, right, least);
  }

  /** Contrast to the ground, in shades, where it looks like paint, otherwise 0; unsigned. */
  byte[] strength() {
    return strength;
  }

  SummedArea sums() {
    return sums;
  }

  SummedArea tints() {
    return tints;
  }
}
