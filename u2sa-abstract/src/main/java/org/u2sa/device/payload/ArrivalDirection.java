package org.u2sa.device.payload;

import java.util.List;
import org.u2sa.messages.frame.Point;

/**
 * Direction of a distant sound source by its arrival times at an array of hydrophones: the unit
 * vector u to the source that minimises Σ (c·(tᵢ − t̄) + u·(pᵢ − p̄))², by Gauss-Newton on the unit
 * sphere. An array in one plane cannot tell a source below it from its mirror image above: the
 * result is the one below.
 *
 * @param direction unit vector to the source, in the axes of the hydrophones' places
 * @param sigmaRad standard deviation of the less certain of two angles across the direction [rad]
 * @param residualS RMS difference between measured and expected arrival times [s]
 */
record ArrivalDirection(Point direction, double sigmaRad, double residualS) {
  private static final int STEPS = 30;
  private static final int STARTS = 8; // azimuths, below and above
  private static final double SMALL = 1e-10;
  private static final double TIE = 1e-6; // minima of equal depth
  private static final double ZERO = 1e-18; // [m²]

  /**
   * Computes the direction.
   *
   * @param positions of the hydrophones: forward, left, down [m]; at least three, not in one line
   * @param arrivalsS arrival times, in the same order [s]
   * @param soundMps speed of sound [m/s]
   * @param sigmaS standard deviation of an arrival time [s]
   */
  static ArrivalDirection of(
      List<Point> places, List<Double> arrivalsS, double soundMps, double sigmaS) {
    Array array = new Array(places, arrivalsS, soundMps);
    Point best = null;
    for (int k = 0; k < 2 * STARTS; k++) { // downward directions first
      double azimuth = 2.0 * Math.PI * k / STARTS;
      double down = k < STARTS ? 0.5 : -0.5;
      Point end = descended(array, Point.of(Math.cos(azimuth), Math.sin(azimuth), down));
      boolean isBetter = best == null || array.cost(end) < (1.0 - TIE) * array.cost(best) - ZERO;
      best = isBetter ? end : best;
    }
    return new ArrivalDirection(
        best,
        soundMps * sigmaS / Math.sqrt(array.curvature(best)),
        Math.sqrt(array.cost(best) / places.size()) / soundMps);
  }

  /** Minimum reached from a start. */
  private static Point descended(Array array, Point start) {
    Point best = unit(start);
    for (int i = 0; i < STEPS; i++) {
      Point next = array.improved(best);
      if (array.cost(next) > array.cost(best)) {
        break;
      }
      boolean isDone = next.distanceTo(best) < SMALL;
      best = next;
      if (isDone) {
        break;
      }
    }
    return best;
  }

  private static Point unit(Point vector) {
    return vector.times(1.0 / vector.distance());
  }

  /** Places and path lengths relative to their means [m]. */
  private static final class Array {
    private final Point[] places;
    private final double[] paths;

    Array(List<Point> all, List<Double> arrivalsS, double soundMps) {
      places = new Point[all.size()];
      paths = new double[all.size()];
      Point middle = all.stream().reduce(Point.ORIGIN, Point::plus).times(1.0 / all.size());
      double mean = arrivalsS.stream().mapToDouble(Double::doubleValue).average().orElse(0.0);
      for (int i = 0; i < places.length; i++) {
        places[i] = all.get(i).minus(middle);
        paths[i] = soundMps * (arrivalsS.get(i) - mean);
      }
    }

    double cost(Point u) {
      double sum = 0.0;
      for (int i = 0; i < places.length; i++) {
        double error = paths[i] + u.dot(places[i]);
        sum += error * error;
      }
      return sum;
    }

    /** Two unit vectors across a direction. */
    private static Point[] across(Point u) {
      Point aside = Math.abs(u.z()) < 0.9 ? Point.of(0.0, 0.0, 1.0) : Point.of(1.0, 0.0, 0.0);
      Point first = unit(aside.minus(u.times(aside.dot(u))));
      return new Point[] {first, u.cross(first)};
    }

    /** Sums of the normal equations: first², second², first·second, and both times the error. */
    private double[] normal(Point u, Point[] across) {
      double[] sums = new double[5];
      for (int i = 0; i < places.length; i++) {
        double first = across[0].dot(places[i]);
        double second = across[1].dot(places[i]);
        double error = paths[i] + u.dot(places[i]);
        sums[0] += first * first;
        sums[1] += second * second;
        sums[2] += first * second;
        sums[3] += first * error;
        sums[4] += second * error;
      }
      return sums;
    }

    /** One step of Gauss-Newton. */
    Point improved(Point u) {
      Point[] across = across(u);
      double[] n = normal(u, across);
      double determinant = n[0] * n[1] - n[2] * n[2] + SMALL * (n[0] + n[1]) * (n[0] + n[1]);
      double a = (n[2] * n[4] - n[1] * n[3]) / determinant;
      double b = (n[2] * n[3] - n[0] * n[4]) / determinant;
      double scale = Math.min(1.0, 0.5 / Math.max(SMALL, Math.hypot(a, b)));
      return unit(u.plus(across[0].times(a * scale)).plus(across[1].times(b * scale)));
    }

    /** Least eigenvalue of the normal matrix [m²]. */
    double curvature(Point u) {
      double[] n = normal(u, across(u));
      double half = (n[0] + n[1]) / 2.0;
      return Math.max(1e-12, half - Math.hypot((n[0] - n[1]) / 2.0, n[2]));
    }
  }
}
