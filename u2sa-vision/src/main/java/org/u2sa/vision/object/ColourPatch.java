package org.u2sa.vision.object;

/**
 * Bounding box of connected pixels of one colour in the image [px], inclusive.
 *
 * @param count number of pixels of the colour
 */
record ColourPatch(ColourClass colour, int left, int top, int right, int bottom, int count) {
  int width() {
    return right - left + 1;
  }

  int height() {
    return bottom - top + 1;
  }

  /** Overlap in columns, as a share of the narrower patch. */
  double overlap(ColourPatch other) {
    int common = Math.min(right, other.right) - Math.max(left, other.left) + 1;
    return Math.max(0.0, (double) common / Math.min(width(), other.width()));
  }

  /** Vertical gap in rows; negative if they overlap. */
  int rowsBetween(ColourPatch other) {
    return Math.max(top, other.top) - Math.min(bottom, other.bottom) - 1;
  }

  /** Union of both. */
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
