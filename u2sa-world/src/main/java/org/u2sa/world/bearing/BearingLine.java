package org.u2sa.world.bearing;

import java.util.Collection;
import org.u2sa.messages.frame.Point;

/**
 * A line of sight: from the sensor along a unit vector, in metres of the map.
 *
 * @param rangeM assumed distance, which may be wrong by the same amount [m]
 */
record BearingLine(Point from, Point direction, double rangeM) {
  private static final int ROUNDS = 10;
  private static final double TRUSTED_SIGMAS = 2.0; // scale of the weights
  private static final double NEAREST_M = 0.5;

  /**
   * A position with standard deviations along the map's axes [m].
   *
   * @param residual RMS distance of the lines from it, in standard deviations
   */
  record Meeting(Point place, Point sigma, double residual) {}

  /**
   * The point nearest to all lines: weighted least squares of the distances across the lines, with
   * Geman–McClure weights to suppress echoes and the newest line's assumed range.
   *
   * @param lines at least one, the newest last
   * @param sigmaRad standard deviation of a direction [rad]
   */
  static Meeting of(Collection<BearingLine> lines, double sigmaRad) {
    BearingLine newest = null;
    for (BearingLine line : lines) {
      newest = line;
    }
    Point place = newest.from.plus(newest.direction.times(newest.rangeM));
    double[][] matrix = new double[3][3];
    double squares = 0.0;
    for (int round = 0; round < ROUNDS; round++) {
      matrix = new double[3][3];
      double[] right = new double[3];
      double guess = 1.0 / (newest.rangeM * newest.rangeM);
      add(matrix, right, newest, newest.from.plus(newest.direction.times(newest.rangeM)), guess, 1);
      squares = 0.0;
      for (BearingLine line : lines) {
        Point way = place.minus(line.from);
        double sigmaM = sigmaRad * Math.max(NEAREST_M, way.distance());
        double errors = way.minus(line.direction.times(way.dot(line.direction))).distance();
        double sigmas = errors / sigmaM;
        double trust = Math.pow(1.0 + sigmas * sigmas / (TRUSTED_SIGMAS * TRUSTED_SIGMAS), -2.0);
        squares += sigmas * sigmas;
        add(matrix, right, line, line.from, trust / (sigmaM * sigmaM), 0);
      }
      place = solved(matrix, right);
    }
    double determinant = determinant(matrix);
    return new Meeting(
        place,
        Point.of(
            Math.sqrt(minor(matrix, 1, 2) / determinant),
            Math.sqrt(minor(matrix, 0, 2) / determinant),
            Math.sqrt(minor(matrix, 0, 1) / determinant)),
        Math.sqrt(squares / lines.size()));
  }

  /** Adds a weighted line through a point, or if {@code along} is 1, the plane across it there. */
  private static void add(
      double[][] matrix, double[] right, BearingLine line, Point at, double weight, int along) {
    double[] u = {line.direction.x(), line.direction.y(), line.direction.z()};
    double[] p = {at.x(), at.y(), at.z()};
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        double part = along == 1 ? u[i] * u[j] : (i == j ? 1.0 : 0.0) - u[i] * u[j];
        matrix[i][j] += weight * part;
        right[i] += weight * part * p[j];
      }
    }
  }

  private static double minor(double[][] m, int i, int j) {
    return m[i][i] * m[j][j] - m[i][j] * m[j][i];
  }

  private static double determinant(double[][] m) {
    return m[0][0] * minor(m, 1, 2)
        - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }

  /** Cramer's rule. */
  private static Point solved(double[][] matrix, double[] right) {
    double all = determinant(matrix);
    double[] solution = new double[3];
    for (int k = 0; k < 3; k++) {
      double[][] replaced = {matrix[0].clone(), matrix[1].clone(), matrix[2].clone()};
      for (int i = 0; i < 3; i++) {
        replaced[i][k] = right[i];
      }
      solution[k] = determinant(replaced) / all;
    }
    return Point.of(solution[0], solution[1], solution[2]);
  }
}
