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
  private static final double PALER = 0.65; // relative to the surroundings

  private final TopView.Area area;
  private final int half; // cells from the paint's centre to its edge, rounded up
  private final int guard; // cells from the centre to the ground
  private final int side; // cells of ground compared on each side
  private final double leastContrast;
  private final double noiseFactor;
  private final SummedArea sums;
  private final SummedArea tints;
  private final long[] along; // strips of the sums: the rows of a line along a row
  private final long[] middle; // the rows of a line's centre, for a line across rows
  private final long[] nearer; // the rows of the ground on its two sides
  private final long[] farther;
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
    along = new long[area.columns() + 1];
    middle = new long[along.length];
    nearer = new long[along.length];
    farther = new long[along.length];
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
      sums.strip(row - 1, row + 2, along);
      for (int column = guard + side; column < area.columns() - half; column += 3) {
        double centre = centre(column, true);
        double left = left(column, true);
        if (centre >= 0.0 && left >= 0.0) {
          histogram[Math.min(511, (int) Math.round(Math.abs(centre - left)))]++;
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
    sums.strip(row - 1, row + 2, along);
    sums.strip(row - half, row + half + 1, middle);
    sums.strip(row - guard - side + 1, row - guard + 1, nearer);
    sums.strip(row + guard, row + guard + side, farther);
    for (int column = 0; column < area.columns(); column++) {
      int at = row * area.columns() + column;
      strength[at] = 0;
      if (!view.seen()[at]) {
        continue;
      }
      double most = Math.max(response(row, column, true), response(row, column, false));
      if (most >= threshold) {
        strength[at] = (byte) Math.min(255.0, most);
      }
    }
  }

  /** Contrast of the centre over the brighter side; 0 if not paint. */
  private double response(int row, int column, boolean alongRow) {
    double centre = centre(column, alongRow);
    double left = left(column, alongRow);
    if (centre < 0.0 || left < 0.0 || centre - left < leastContrast) {
      return 0.0;
    }
    double right =
        alongRow
            ? SummedArea.mean(along, column + guard, column + guard + side, side)
            : SummedArea.mean(farther, column - 1, column + 2, side);
    double response = centre - Math.max(left, right);
    if (right < 0.0 || response < leastContrast || !isPale(row, column, alongRow)) {
      return 0.0;
    }
    return response;
  }

  /** Mean shade around the centre, in the strips' rows; -1 if not visible. */
  private double centre(int column, boolean alongRow) {
    return alongRow
        ? SummedArea.mean(along, column - half, column + half + 1, 1)
        : SummedArea.mean(middle, column - 1, column + 2, 1);
  }

  private double left(int column, boolean alongRow) {
    return alongRow
        ? SummedArea.mean(along, column - guard - side + 1, column - guard + 1, side)
        : SummedArea.mean(nearer, column - 1, column + 2, side);
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

  private double tint(int row, int column, int from, int to, boolean alongRow) {
    int top = alongRow ? row - 1 : row + from;
    int bottom = alongRow ? row + 2 : row + to + 1;
    int left = alongRow ? column + from : column - 1;
    int right = alongRow ? column + to + 1 : column + 2;
    return tints.mean(top, left, bottom, right, 1);
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
