package org.u2sa.world.scanmap;

/** Symmetric 3 × 3 matrices over x, y and angle, stored row by row in arrays of nine. */
final class Matrix3 {
  static final int SIZE = 3;

  private Matrix3() {}

  /** Diagonal matrix of the squares of the arguments. */
  static double[] ofSigmas(double x, double y, double angle) {
    return new double[] {x * x, 0.0, 0.0, 0.0, y * y, 0.0, 0.0, 0.0, angle * angle};
  }

  /** Sum of two matrices. */
  static double[] plus(double[] a, double[] b) {
    double[] sum = new double[SIZE * SIZE];
    for (int i = 0; i < sum.length; i++) {
      sum[i] = a[i] + b[i];
    }
    return sum;
  }

  /** Matrix times a factor. */
  static double[] times(double[] a, double factor) {
    double[] product = new double[SIZE * SIZE];
    for (int i = 0; i < product.length; i++) {
      product[i] = a[i] * factor;
    }
    return product;
  }

  /** Product a · b. */
  static double[] times(double[] a, double[] b) {
    double[] product = new double[SIZE * SIZE];
    for (int i = 0; i < SIZE; i++) {
      for (int j = 0; j < SIZE; j++) {
        for (int k = 0; k < SIZE; k++) {
          product[i * SIZE + j] += a[i * SIZE + k] * b[k * SIZE + j];
        }
      }
    }
    return product;
  }

  /** a · b · aᵀ. */
  static double[] sandwich(double[] a, double[] b) {
    double[] transposed = {a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8]};
    return times(times(a, b), transposed);
  }

  /** Rotates the position part of a covariance or information by an angle. */
  static double[] rotated(double[] a, double angle) {
    double c = StrictMath.cos(angle);
    double s = StrictMath.sin(angle);
    return sandwich(new double[] {c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0}, a);
  }

  /**
   * Inverse of a positive definite matrix.
   *
   * @throws ArithmeticException if it is singular
   */
  static double[] inverse(double[] a) {
    double c0 = a[4] * a[8] - a[5] * a[7];
    double c1 = a[5] * a[6] - a[3] * a[8];
    double c2 = a[3] * a[7] - a[4] * a[6];
    double det = a[0] * c0 + a[1] * c1 + a[2] * c2;
    if (!(Math.abs(det) > 0.0) || Double.isInfinite(det)) {
      throw new ArithmeticException("singular matrix");
    }
    return new double[] {
      c0 / det, (a[2] * a[7] - a[1] * a[8]) / det, (a[1] * a[5] - a[2] * a[4]) / det,
      c1 / det, (a[0] * a[8] - a[2] * a[6]) / det, (a[2] * a[3] - a[0] * a[5]) / det,
      c2 / det, (a[1] * a[6] - a[0] * a[7]) / det, (a[0] * a[4] - a[1] * a[3]) / det
    };
  }

  /** Quadratic form vᵀ a v of the vector (x, y, angle). */
  static double square(double[] a, double x, double y, double angle) {
    return x * (a[0] * x + a[1] * y + a[2] * angle)
        + y * (a[3] * x + a[4] * y + a[5] * angle)
        + angle * (a[6] * x + a[7] * y + a[8] * angle);
  }

  /** Largest standard deviation of the position in any direction [m]. */
  static double largestSigma(double[] covariance) {
    double mean = (covariance[0] + covariance[4]) / 2.0;
    double half = Math.hypot((covariance[0] - covariance[4]) / 2.0, covariance[1]);
    return Math.sqrt(Math.max(0.0, mean + half));
  }

  /**
   * Covariance of {@code pose.times(step)}, both errors independent.
   *
   * @param step covariance of the step in the axes of the pose
   */
  static double[] propagated(double[] covariance, Pose2 pose, Pose2 next, double[] step) {
    double[] moved = {
      1.0, 0.0, -(next.y() - pose.y()), 0.0, 1.0, next.x() - pose.x(), 0.0, 0.0, 1.0
    };
    return plus(sandwich(moved, covariance), rotated(step, pose.theta()));
  }
}
