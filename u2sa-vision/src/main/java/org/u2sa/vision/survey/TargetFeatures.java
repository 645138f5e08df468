package org.u2sa.vision.survey;

/** Scale-invariant descriptors of outlines and letters. */
final class TargetFeatures {
  /** Directions of an outline. */
  static final int DIRECTIONS = 48;

  /** Cells along a side of a letter's grid. */
  static final int GRID = 14;

  private TargetFeatures() {}

  /**
   * Distance of the outline from the middle in each direction, clockwise from the top of the image,
   * divided by their mean.
   */
  static double[] outline(TargetPatch patch) {
    double[] radius = new double[DIRECTIONS];
    double sum = 0.0;
    double middleX = patch.column() - patch.left();
    double middleY = patch.row() - patch.top();
    for (int i = 0; i < DIRECTIONS; i++) {
      double angle = 2.0 * Math.PI * i / DIRECTIONS;
      double away = 0.0;
      for (double r = 0.0; r < patch.width() + patch.height(); r += 0.5) {
        int x = (int) Math.round(middleX + r * Math.sin(angle));
        int y = (int) Math.round(middleY - r * Math.cos(angle));
        boolean isIn = x >= 0 && y >= 0 && x < patch.width() && y < patch.height();
        if (isIn && patch.isOn()[y * patch.width() + x]) {
          away = r;
        }
      }
      radius[i] = away;
      sum += away / DIRECTIONS;
    }
    for (int i = 0; i < DIRECTIONS && sum > 0.0; i++) {
      radius[i] /= sum;
    }
    return radius;
  }

  /**
   * The ink of a letter in a fitted grid, rotated so that a direction of the image is up; mean 0
   * and length 1, or all 0 without enough ink.
   *
   * @param upRad direction of the letter's top, clockwise from the top of the image
   */
  static double[] letter(TargetPatch patch, boolean[] ink, double upRad) {
    double cos = Math.cos(upRad);
    double sin = Math.sin(upRad);
    double left = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < ink.length; i++) {
      if (ink[i]) {
        double x = i % patch.width();
        double y = -(i / patch.width());
        left = Math.min(left, x * cos - y * sin);
        right = Math.max(right, x * cos - y * sin);
        low = Math.min(low, x * sin + y * cos);
        high = Math.max(high, x * sin + y * cos);
      }
    }
    double[] grid = new double[GRID * GRID];
    if (!(right - left > 2.0 && high - low > 2.0)) {
      return grid;
    }
    double mean = 0.0;
    for (int i = 0; i < grid.length; i++) {
      double across = left + (right - left) * (i % GRID + 0.5) / GRID;
      double up = high - (high - low) * (i / GRID + 0.5) / GRID;
      int x = (int) Math.round(across * cos + up * sin);
      int y = (int) Math.round(-(up * cos - across * sin));
      boolean isIn = x >= 0 && y >= 0 && x < patch.width() && y < patch.height();
      grid[i] = isIn && ink[y * patch.width() + x] ? 1.0 : 0.0;
      mean += grid[i] / grid.length;
    }
    return normalised(grid, mean);
  }

  static double[] normalised(double[] grid, double mean) {
    double square = 0.0;
    for (int i = 0; i < grid.length; i++) {
      grid[i] -= mean;
      square += grid[i] * grid[i];
    }
    for (int i = 0; i < grid.length && square > 0.0; i++) {
      grid[i] /= Math.sqrt(square);
    }
    return grid;
  }
}
