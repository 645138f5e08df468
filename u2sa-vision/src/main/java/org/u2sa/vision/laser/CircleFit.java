package org.u2sa.vision.laser;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.frame.Point;

/**
 * Least-squares fit of a circle to points on its near side, by Gauss-Newton from Kåsa's algebraic
 * fit (IEEE Trans. Instrum. Meas. 25, 1976), with the uncertainty of the centre.
 *
 * @param x of the centre [m]
 * @param y of the centre [m]
 * @param radius [m]
 * @param sigmaX standard deviation of the centre along x [m]
 * @param sigmaY standard deviation of the centre along y [m]
 * @param offM RMS distance of the points from the circle [m]
 */
record CircleFit(double x, double y, double radius, double sigmaX, double sigmaY, double offM) {
  private static final int LEAST = 5; // points
  private static final int ITERATIONS = 15;
  private static final double SINGULAR = 1e-12;

  /**
   * @param noiseM lower bound of the range noise, 1 σ [m]
   * @return empty with too few or collinear points
   */
  static Optional<CircleFit> of(List<Point> points, double noiseM) {
    if (points.size() < LEAST) {
      return Optional.empty();
    }
    double[] circle = algebraic(points);
    if (circle == null) {
      return Optional.empty();
    }
    double[] normal = new double[6];
    for (int i = 0; i < ITERATIONS; i++) {
      double[] slope = new double[3];
      normal = equations(points, circle, slope);
      double[] step = solve(normal, slope);
      if (step == null) {
        return Optional.empty();
      }
      for (int k = 0; k < 3; k++) {
        circle[k] += step[k];
      }
    }
    double squares = 0.0;
    for (Point point : points) {
      double off = Math.hypot(point.x() - circle[0], point.y() - circle[1]) - circle[2];
      squares += off * off;
    }
    double off = Math.sqrt(squares / points.size());
    double noise = Math.max(noiseM, Math.sqrt(squares / Math.max(1, points.size() - 3)));
    double[] forX = solve(normal, new double[] {1.0, 0.0, 0.0});
    double[] forY = solve(normal, new double[] {0.0, 1.0, 0.0});
    if (forX == null || forY == null || !(circle[2] > 0.0) || !(forX[0] > 0.0 && forY[1] > 0.0)) {
      return Optional.empty();
    }
    return Optional.of(
        new CircleFit(
            circle[0],
            circle[1],
            circle[2],
            noise * Math.sqrt(forX[0]),
            noise * Math.sqrt(forY[1]),
            off));
  }

  /** x² + y² = 2 a x + 2 b y + c around the points' mean; null if collinear. */
  private static double[] algebraic(List<Point> points) {
    double meanX = points.stream().mapToDouble(Point::x).average().orElseThrow();
    double meanY = points.stream().mapToDouble(Point::y).average().orElseThrow();
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    double xs = 0.0;
    double ys = 0.0;
    double squares = 0.0;
    for (Point point : points) {
      double x = point.x() - meanX;
      double y = point.y() - meanY;
      double square = x * x + y * y;
      xx += x * x;
      xy += x * y;
      yy += y * y;
      xs += x * square;
      ys += y * square;
      squares += square;
    }
    double determinant = xx * yy - xy * xy;
    if (!(determinant > SINGULAR * squares * squares)) {
      return null;
    }
    double a = 0.5 * (yy * xs - xy * ys) / determinant;
    double b = 0.5 * (xx * ys - xy * xs) / determinant;
    return new double[] {meanX + a, meanY + b, Math.sqrt(a * a + b * b + squares / points.size())};
  }

  /** Coefficients xx, xy, xr, yy, yr, rr of the normal equations, and their right-hand side. */
  private static double[] equations(List<Point> points, double[] circle, double[] right) {
    double[] normal = new double[6];
    for (Point point : points) {
      double x = point.x() - circle[0];
      double y = point.y() - circle[1];
      double away = Math.max(1e-9, Math.hypot(x, y));
      double[] row = {x / away, y / away, 1.0};
      double off = away - circle[2];
      int at = 0;
      for (int i = 0; i < 3; i++) {
        right[i] += row[i] * off;
        for (int k = i; k < 3; k++) {
          normal[at++] += row[i] * row[k];
        }
      }
    }
    return normal;
  }

  /** Solves by Cramer's rule; null if singular. */
  private static double[] solve(double[] n, double[] right) {
    double a = n[3] * n[5] - n[4] * n[4];
    double b = n[2] * n[4] - n[1] * n[5];
    double c = n[1] * n[4] - n[2] * n[3];
    double determinant = n[0] * a + n[1] * b + n[2] * c;
    if (!(Math.abs(determinant) > SINGULAR)) {
      return null;
    }
    double d = n[0] * n[5] - n[2] * n[2];
    double e = n[1] * n[2] - n[0] * n[4];
    double f = n[0] * n[3] - n[1] * n[1];
    return new double[] {
      (a * right[0] + b * right[1] + c * right[2]) / determinant,
      (b * right[0] + d * right[1] + e * right[2]) / determinant,
      (c * right[0] + e * right[1] + f * right[2]) / determinant
    };
  }
}
