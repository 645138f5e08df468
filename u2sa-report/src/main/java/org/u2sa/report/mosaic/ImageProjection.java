package org.u2sa.report.mosaic;

import java.util.Optional;

/**
 * Projective map from level ground to the pixels of one image, from the positions of its four
 * corner pixels (Heckbert, Fundamentals of Texture Mapping and Image Warping, 1989, section 2.2.3).
 * Exact for a pinhole camera.
 */
final class ImageProjection {
  private static final double MIN_AREA_M2 = 1e-4;

  private final double[] h = new double[9]; // from ground to pixels, by rows
  private final double originX; // tolerance around the image for rounding
  private final double originY;

  private ImageProjection(double[] xs, double[] ys, int width, int height) {
    originX = xs[0];
    originY = ys[0];
    // from the unit square to the ground
    double sumX = xs[0] - xs[1] + xs[2] - xs[3];
    double sumY = ys[0] - ys[1] + ys[2] - ys[3];
    double x1 = xs[1] - xs[2];
    double x2 = xs[3] - xs[2];
    double y1 = ys[1] - ys[2];
    double y2 = ys[3] - ys[2];
    double whole = x1 * y2 - x2 * y1;
    double g = (sumX * y2 - sumY * x2) / whole;
    double k = (x1 * sumY - y1 * sumX) / whole;
    double[] m = {
      xs[1] - xs[0] + g * xs[1],
      xs[3] - xs[0] + k * xs[3],
      0.0,
      ys[1] - ys[0] + g * ys[1],
      ys[3] - ys[0] + k * ys[3],
      0.0,
      g,
      k,
      1.0
    };
    // relative to the origin
    for (int i = 0; i < 2; i++) {
      m[i] -= originX * m[6 + i];
      m[3 + i] -= originY * m[6 + i];
    }
    // its adjugate, scaled to pixels
    for (int i = 0; i < 9; i++) {
      int a = (i % 3 + 1) % 3;
      int b = (i % 3 + 2) % 3;
      int c = (i / 3 + 1) % 3;
      int d = (i / 3 + 2) % 3;
      double scale = i / 3 == 0 ? width - 1.0 : i / 3 == 1 ? height - 1.0 : 1.0;
      h[i] = scale * (m[3 * a + c] * m[3 * b + d] - m[3 * a + d] * m[3 * b + c]);
    }
  }

  /**
   * Creates the map; empty if the corners do not form a convex quadrilateral.
   *
   * @param xs eastings of the corner pixels' middles: upper left, upper right, lower right, lower
   *     left [m]
   * @param ys northings [m]
   */
  static Optional<ImageProjection> of(double[] xs, double[] ys, int width, int height) {
    double turn = 0.0;
    for (int i = 0; i < 4; i++) {
      int j = (i + 1) % 4;
      int k = (i + 2) % 4;
      double cross = (xs[j] - xs[i]) * (ys[k] - ys[j]) - (ys[j] - ys[i]) * (xs[k] - xs[j]);
      if (!(Math.abs(cross) > MIN_AREA_M2) || cross * turn < 0.0) {
        return Optional.empty();
      }
      turn = cross;
    }
    return Optional.of(new ImageProjection(xs, ys, width, height));
  }

  /**
   * Projects a point.
   *
   * @param out receives column, row, and the ground resolution in the worse direction [m per pixel]
   * @return false if the point is beyond the horizon
   */
  boolean project(double eastM, double northM, double[] out) {
    double x = eastM - originX;
    double y = northM - originY;
    double w = h[6] * x + h[7] * y + h[8];
    if (!(w * h[8] > 0.0)) { // the first corner lies in front of the camera
      return false;
    }
    double column = (h[0] * x + h[1] * y + h[2]) / w;
    double row = (h[3] * x + h[4] * y + h[5]) / w;
    double a = (h[0] - column * h[6]) / w; // derivatives [px/m]
    double b = (h[1] - column * h[7]) / w;
    double c = (h[3] - row * h[6]) / w;
    double d = (h[4] - row * h[7]) / w;
    double half = 0.5 * (a * a + b * b + c * c + d * d);
    double area = a * d - b * c;
    double least = half - Math.sqrt(Math.max(0.0, half * half - area * area));
    out[0] = column;
    out[1] = row;
    out[2] = 1.0 / Math.sqrt(Math.max(least, 1e-12)); // of the smaller singular value
    return true;
  }
}
