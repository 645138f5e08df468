package org.u2sa.vision.object;

/**
 * Pixels of one colour that touch, by their bounds in the picture [pixels], all included.
 *
 * @param count pixels of the colour within
 */
record ColourPatch(ColourClass colour, int left, int top, int right, int bottom, int count) {
  int width() {
    return right - left + 1;
  }

  int height() {
    return bottom - top + 1;
  }

  /** Columns that both span, as a share of the narrower's. */
  double overlap(ColourPatch other) {
    int common = Math.min(right, other.right) - Math.max(left, other.left) + 1;
    return Math.max(0.0, (double) common / Math.min(width(), other.width()));
  }

  /** Rows between the two; negative if they overlap. */
  int rowsBetween(ColourPatch other) {
    return Math.max(top, other.top) - Math.min(bottom, other.bottom) - 1;
  }

  /** Both together. */
  ColourPatch with(ColourPatch other) {
    return new ColourPatch(
        colour,
        Math.min(left, other.left),
        Math.min(top, other.top),
        Math.max(right, other.right),
        Math.max(bottom, other.bottom),
        count + other.count);
  }
}
