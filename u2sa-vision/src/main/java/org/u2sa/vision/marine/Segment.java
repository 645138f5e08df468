package org.u2sa.vision.marine;

/**
 * Connected cells that differ from the background; a cell is 2 × 2 pixels. Positions are in cells.
 *
 * @param paint ordinal of the colour plus one, 0 if not yet determined (under water)
 * @param count number of cells
 * @param dome its upper part, without reflections in the water below
 * @param x mean column
 * @param y mean row
 * @param major standard deviation along the longer principal axis
 * @param minor standard deviation along the other one
 * @param turn angle of the longer axis, from right to down [rad]
 * @param isOpen whether its middle is background, as in a hoop
 * @param colour mean linear red, green, blue of its inner cells
 * @param around mean colour of the background of its rows
 */
record Segment(
    int paint,
    int left,
    int top,
    int right,
    int bottom,
    int count,
    Dome dome,
    double x,
    double y,
    double major,
    double minor,
    double turn,
    boolean isOpen,
    double[] colour,
    double[] around) {
  /**
   * Upper part of a segment, down to 0.6 of its width: half a ball and a little more.
   *
   * @param width columns of its widest row, apart from one outlier
   * @param row that row
   * @param middle middle column of that row
   * @param height rows
   * @param fill share of width × height that it covers
   */
  record Dome(double width, double row, double middle, int height, double fill) {}

  int width() {
    return right - left + 1;
  }

  int height() {
    return bottom - top + 1;
  }

  /** Share of the bounding box that it covers. */
  double fill() {
    return count / (double) (width() * height());
  }

  double elongation() {
    return major / Math.max(0.3, minor);
  }

  boolean touchesBorder(int columns, int rows) {
    return left < 1 || top < 1 || right > columns - 2 || bottom > rows - 2;
  }
}
