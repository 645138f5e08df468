package org.u2sa.vision.picture;

/** The forward discrete cosine transform of blocks of 8 x 8 samples (ITU-T T.81, A.3.3). */
final class CosineTransform {
  static final int SIDE = 8;
  static final int SAMPLES = SIDE * SIDE;

  private final double[] cosines = new double[SAMPLES]; // row: frequency, column: sample
  private final double[] acrossRows = new double[SAMPLES];

  CosineTransform() {
    for (int frequency = 0; frequency < SIDE; frequency++) {
      double scale = frequency == 0 ? Math.sqrt(0.5) / 2.0 : 0.5;
      for (int place = 0; place < SIDE; place++) {
        double angle = (2 * place + 1) * frequency * Math.PI / (2 * SIDE);
        cosines[frequency * SIDE + place] =
            scale * StrictMath.cos(angle); // identical on every platform
      }
    }
  }

  /**
   * Transforms a block.
   *
   * @param samples row-major, centred on 0
   * @param coefficients output: vertical frequency by row, horizontal by column
   */
  void forward(double[] samples, double[] coefficients) {
    for (int row = 0; row < SAMPLES; row += SIDE) {
      for (int frequency = 0; frequency < SIDE; frequency++) {
        double sum = 0.0;
        for (int column = 0; column < SIDE; column++) {
          sum += samples[row + column] * cosines[frequency * SIDE + column];
        }
        acrossRows[row + frequency] = sum;
      }
    }
    for (int column = 0; column < SIDE; column++) {
      for (int frequency = 0; frequency < SIDE; frequency++) {
        double sum = 0.0;
        for (int row = 0; row < SIDE; row++) {
          sum += acrossRows[row * SIDE + column] * cosines[frequency * SIDE + row];
        }
        coefficients[frequency * SIDE + column] = sum;
      }
    }
  }
}
