package org.u2sa.vision.picture;

/** Quantisation steps of a block's frequencies, in zigzag order (ITU-T T.81, annex K.1). */
final class QuantizationTable {
  private static final int[] LUMINANCE = {
    16, 11, 10, 16, 24, 40, 51, 61, //
    12, 12, 14, 19, 26, 58, 60, 55, //
    14, 13, 16, 24, 40, 57, 69, 56, //
    14, 17, 22, 29, 51, 87, 80, 62, //
    18, 22, 37, 56, 68, 109, 103, 77, //
    24, 35, 55, 64, 81, 104, 113, 92, //
    49, 64, 78, 87, 103, 121, 120, 101, //
    72, 92, 95, 98, 112, 100, 103, 99
  };
  private static final int[] CHROMINANCE = {
    17, 18, 24, 47, 99, 99, 99, 99, //
    18, 21, 26, 66, 99, 99, 99, 99, //
    24, 26, 56, 99, 99, 99, 99, 99, //
    47, 66, 99, 99, 99, 99, 99, 99, //
    99, 99, 99, 99, 99, 99, 99, 99, //
    99, 99, 99, 99, 99, 99, 99, 99, //
    99, 99, 99, 99, 99, 99, 99, 99, //
    99, 99, 99, 99, 99, 99, 99, 99
  };

  private static final int LARGEST_STEP = 255;
  private static final int PERCENT = 100;
  private static final int MIDDLE_QUALITY = 50;

  private final int[] places = zigzag();
  private final int[] steps = new int[CosineTransform.SAMPLES];

  private QuantizationTable(int[] usual, int quality) {
    if (quality < 1 || quality > PERCENT) {
      throw new IllegalArgumentException("JPEG quality: expected 1…100, not " + quality);
    }
    int scale = // as libjpeg's jpeg_quality_scaling: 50 is the table itself
        quality < MIDDLE_QUALITY ? MIDDLE_QUALITY * PERCENT / quality : 2 * (PERCENT - quality);
    for (int i = 0; i < steps.length; i++) {
      int step = (usual[places[i]] * scale + PERCENT / 2) / PERCENT;
      steps[i] = Math.max(1, Math.min(LARGEST_STEP, step));
    }
  }

  static QuantizationTable luminance(int quality) {
    return new QuantizationTable(LUMINANCE, quality);
  }

  static QuantizationTable chrominance(int quality) {
    return new QuantizationTable(CHROMINANCE, quality);
  }

  /** Row-major indexes in zigzag order (figure 5). */
  private static int[] zigzag() {
    int side = CosineTransform.SIDE;
    int[] places = new int[CosineTransform.SAMPLES];
    int next = 0;
    for (int diagonal = 0; diagonal < 2 * side - 1; diagonal++) {
      for (int i = 0; i <= diagonal; i++) {
        int row = diagonal % 2 == 0 ? diagonal - i : i;
        int column = diagonal - row;
        if (row < side && column < side) {
          places[next++] = row * side + column;
        }
      }
    }
    return places;
  }

  /** Steps in zigzag order, each 1…255. */
  int[] steps() {
    return steps;
  }

  /**
   * Divides by the steps and rounds.
   *
   * @param frequencies row-major
   * @param coefficients output, in zigzag order
   */
  void quantize(double[] frequencies, int[] coefficients) {
    for (int i = 0; i < coefficients.length; i++) {
      coefficients[i] = (int) Math.round(frequencies[places[i]] / steps[i]);
    }
  }
}
