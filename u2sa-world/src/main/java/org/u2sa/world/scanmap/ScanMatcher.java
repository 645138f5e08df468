package org.u2sa.world.scanmap;

import java.util.Optional;

/**
 * Matches a scan to a map: a correlative search of a window (Olson, "Real-time correlative scan
 * matching", ICRA 2009), then Gauss-Newton on the point-to-line distances (Censi, "An ICP variant
 * using a point-to-line metric", ICRA 2008).
 */
final class ScanMatcher {
  /**
   * Result of a match.
   *
   * @param pose the best pose, given the guess
   * @param information information matrix from the echoes alone, in the map's axes; excludes the
   *     prior, so it is about 0 along a featureless corridor
   * @param share fraction of the echoes that lie on surfaces of the map, 0…1
   * @param score mean likelihood of the echoes [0…1]
   */
  record Match(Pose2 pose, double[] information, double share, double score) {}

  /** Distance of poses from which on they are different places [m]. */
  static final double ELSEWHERE_M = 0.7;

  /** Angle between poses from which on they are different places [rad]. */
  static final double ELSEWHERE_RAD = 0.3;

  private static final double COARSE_M = 0.2;
  private static final double FINE_M = 0.1;
  private static final double WIDE_M = 1.2; // larger windows are searched by branch and bound
  private static final double COARSE_RAD = 0.035;
  private static final double COARSE_SHARE = 0.5; // of a score, between two coarse steps
  private static final double FINE_RAD = 0.0125;
  private static final int SEARCHED_POINTS = 90;
  private static final int STEPS = 15;
  private static final int WIDE_STEPS = 4; // number of steps with the wide reach
  private static final int WIDE_CELLS = 4;
  private static final int NARROW_CELLS = 2;
  private static final double HUBER_M = 0.06;
  private static final double MIN_SIGMA_M = 0.02;
  private static final double POINT_SIGMA = 3.0; // multiplier for echoes off any surface
  private static final double NEAR_M = 0.12; // an echo this close to a surface supports the match

  /** Number of neighbouring beams that count as one independent measurement. */
  private static final double BEAMS_ALIKE = 8.0;

  /** Variance of a surface normal's direction [rad²]. */
  private static final double DIRECTION_NOISE = 0.004;

  private static final double DONE_M = 1e-4;
  private static final double DONE_RAD = 1e-5;
  private static final double FULL = 100.0;

  /**
   * Matches a scan.
   *
   * @param guess predicted pose
   * @param prior information about the guess, in the map's axes
   * @param windowM half-width of the search window [m]; 0 for no search
   * @param windowRad half-width of the search window [rad]
   */
  Match match(
      LocalMap map,
      ScanPoints scan,
      Pose2 guess,
      double[] prior,
      double windowM,
      double windowRad) {
    Pose2 start = windowM > 0.0 ? searched(map, scan, guess, windowM, windowRad) : guess;
    return refined(map, scan, start, guess, prior);
  }

  /** The pose with the highest likelihood in a window. */
  Pose2 searched(LocalMap map, ScanPoints scan, Pose2 guess, double windowM, double windowRad) {
    Pose2 coarse =
        windowM > WIDE_M
            ? bounded(map, scan, guess, windowM, windowRad, null, 0.0).orElse(guess)
            : best(map, scan, guess, windowM, windowRad, COARSE_M, COARSE_RAD);
    return best(map, scan, coarse, COARSE_M, COARSE_RAD, FINE_M, FINE_RAD);
  }

  /**
   * The pose with the highest likelihood in a large window, except near another one.
   *
   * @param least score that it must be able to have; fewer poses are compared for a higher one
   */
  Optional<Pose2> elsewhere(
      LocalMap map,
      ScanPoints scan,
      Pose2 guess,
      double windowM,
      double windowRad,
      Pose2 except,
      double least) {
    return bounded(map, scan, guess, windowM, windowRad, except, COARSE_SHARE * least)
        .map(coarse -> best(map, scan, coarse, COARSE_M, COARSE_RAD, FINE_M, FINE_RAD));
  }

  /**
   * Best pose in a large window by branch and bound over squares of block size (Hess et al., ICRA
   * 2016).
   *
   * @param except pose that it must differ from by ELSEWHERE_M or ELSEWHERE_RAD, or null
   * @param least score that it must exceed, if it is not 0
   */
  private static Optional<Pose2> bounded(
      LocalMap map,
      ScanPoints scan,
      Pose2 guess,
      double windowM,
      double windowRad,
      Pose2 except,
      double least) {
    int turns = (int) Math.ceil(windowRad / COARSE_RAD);
    int squares = (int) Math.ceil(windowM / LocalMap.BLOCK_M);
    int every = Math.max(1, scan.count / SEARCHED_POINTS);
    int points = (scan.count + every - 1) / every;
    double[][] px = new double[2 * turns + 1][points];
    double[][] py = new double[2 * turns + 1][points];
    int side = 2 * squares;
    long most = (long) (least * FULL * points) - 1;
    long[] order = new long[(2 * turns + 1) * side * side];
    int count = 0;
    map.bound();
    for (int turn = 0; turn <= 2 * turns; turn++) {
      double theta = guess.theta() + (turn - turns) * COARSE_RAD;
      double c = StrictMath.cos(theta);
      double s = StrictMath.sin(theta);
      for (int p = 0; p < points; p++) {
        px[turn][p] = guess.x() + c * scan.x[p * every] - s * scan.y[p * every];
        py[turn][p] = guess.y() + s * scan.x[p * every] + c * scan.y[p * every];
      }
      for (int square = 0; square < side * side; square++) {
        double dx = (square / side - squares) * LocalMap.BLOCK_M;
        double dy = (square % side - squares) * LocalMap.BLOCK_M;
        long sum = map.sum(LocalMap.BLOCK, px[turn], py[turn], dx, dy, most);
        if (sum > most) {
          order[count++] = -sum << 32 | turn * side * side + square;
        }
      }
    }
    java.util.Arrays.sort(order, 0, count);
    Pose2 best = null;
    for (int k = 0; k < count && -(order[k] >> 32) > most; k++) {
      int number = (int) order[k];
      int turn = number / (side * side);
      int square = number % (side * side);
      double theta = guess.theta() + (turn - turns) * COARSE_RAD;
      boolean isTurned =
          except == null || Math.abs(Pose2.wrapped(theta - except.theta())) >= ELSEWHERE_RAD;
      for (int i = 0; i < 16; i++) { // four quarters of four poses
        double cornerX = (square / side - squares) * LocalMap.BLOCK_M + i / 8 * 2 * COARSE_M;
        double cornerY = (square % side - squares) * LocalMap.BLOCK_M + i / 4 % 2 * 2 * COARSE_M;
        if (i % 4 == 0
            && map.sum(LocalMap.HALF_BLOCK, px[turn], py[turn], cornerX, cornerY, most) <= most) {
          i += 3;
          continue;
        }
        double dx = cornerX + i / 2 % 2 * COARSE_M;
        double dy = cornerY + i % 2 * COARSE_M;
        boolean isNear =
            !isTurned
                && Math.hypot(guess.x() + dx - except.x(), guess.y() + dy - except.y())
                    < ELSEWHERE_M;
        long sum = isNear ? -1 : map.sum(1, px[turn], py[turn], dx, dy, most);
        if (sum > most) {
          most = sum;
          best = new Pose2(guess.x() + dx, guess.y() + dy, Pose2.wrapped(theta));
        }
      }
    }
    return Optional.ofNullable(best);
  }

  private static Pose2 best(
      LocalMap map,
      ScanPoints scan,
      Pose2 guess,
      double windowM,
      double windowRad,
      double stepM,
      double stepRad) {
    int cells = (int) Math.ceil(windowM / stepM);
    int turns = (int) Math.ceil(windowRad / stepRad);
    int every = Math.max(1, scan.count / SEARCHED_POINTS);
    double[] px = new double[scan.count / every + 1];
    double[] py = new double[px.length];
    Pose2 best = guess;
    double most = -1.0;
    for (int turn = -turns; turn <= turns; turn++) {
      double theta = guess.theta() + turn * stepRad;
      double c = StrictMath.cos(theta);
      double s = StrictMath.sin(theta);
      int points = 0;
      for (int i = 0; i < scan.count; i += every, points++) {
        px[points] = guess.x() + c * scan.x[i] - s * scan.y[i];
        py[points] = guess.y() + s * scan.x[i] + c * scan.y[i];
      }
      for (int i = -cells; i <= cells; i++) {
        for (int k = -cells; k <= cells; k++) {
          int sum = 0;
          for (int p = 0; p < points; p++) {
            sum += map.likelihood(px[p] + i * stepM, py[p] + k * stepM);
          }
          double far =
              (i * i + k * k) / (cells * cells + 1.0) + turn * turn / (turns * turns + 1.0);
          double score = sum * (1.0 - 0.03 * far); // on ties, the pose nearest to the guess
          if (score > most) {
            most = score;
            best = new Pose2(guess.x() + i * stepM, guess.y() + k * stepM, Pose2.wrapped(theta));
          }
        }
      }
    }
    return best;
  }

  private static Match refined(
      LocalMap map, ScanPoints scan, Pose2 start, Pose2 guess, double[] prior) {
    Pose2 pose = start;
    double sigma = HUBER_M;
    Fit fit = new Fit();
    for (int step = 0; step < STEPS; step++) {
      int reach = step < WIDE_STEPS ? WIDE_CELLS : NARROW_CELLS;
      fit.take(map, scan, pose, reach);
      if (fit.supported == 0) {
        break;
      }
      sigma = Math.max(MIN_SIGMA_M, fit.rms());
      double scale = 1.0 / (sigma * sigma * BEAMS_ALIKE);
      double[] h = Matrix3.plus(Matrix3.times(fit.h, scale), prior);
      double dx = guess.x() - pose.x();
      double dy = guess.y() - pose.y();
      double dt = Pose2.wrapped(guess.theta() - pose.theta());
      double[] g = new double[3];
      for (int i = 0; i < 3; i++) {
        g[i] = scale * fit.g[i] + prior[i * 3] * dx + prior[i * 3 + 1] * dy + prior[i * 3 + 2] * dt;
      }
      double[] inverse = Matrix3.inverse(h);
      double[] d = new double[3];
      for (int i = 0; i < 3; i++) {
        d[i] = inverse[i * 3] * g[0] + inverse[i * 3 + 1] * g[1] + inverse[i * 3 + 2] * g[2];
      }
      pose = new Pose2(pose.x() + d[0], pose.y() + d[1], Pose2.wrapped(pose.theta() + d[2]));
      if (step >= WIDE_STEPS && Math.hypot(d[0], d[1]) < DONE_M && Math.abs(d[2]) < DONE_RAD) {
        break;
      }
    }
    fit.take(map, scan, pose, NARROW_CELLS);
    sigma = Math.max(MIN_SIGMA_M, fit.rms());
    double[] information = Matrix3.times(fit.h, 1.0 / (sigma * sigma * BEAMS_ALIKE));
    double share = fit.told == 0 ? 0.0 : fit.near / (double) fit.told;
    return new Match(pose, information, share, score(map, scan, pose));
  }

  /** Mean likelihood of the echoes at a pose, 0…1. */
  static double score(LocalMap map, ScanPoints scan, Pose2 pose) {
    double c = StrictMath.cos(pose.theta());
    double s = StrictMath.sin(pose.theta());
    long sum = 0;
    for (int i = 0; i < scan.count; i++) {
      sum +=
          map.likelihood(
              pose.x() + c * scan.x[i] - s * scan.y[i], pose.y() + s * scan.x[i] + c * scan.y[i]);
    }
    return scan.count == 0 ? 0.0 : sum / FULL / scan.count;
  }

  /** Normal equations of one step. */
  private static final class Fit {
    private final double[] h = new double[9];
    private final double[] g = new double[3];
    private double squares;
    private double weights;
    private int supported;
    private int told; // echoes that can support the match
    private int near;

    void take(LocalMap map, ScanPoints scan, Pose2 pose, int reach) {
      java.util.Arrays.fill(h, 0.0);
      java.util.Arrays.fill(g, 0.0);
      squares = 0.0;
      weights = 0.0;
      supported = 0;
      told = 0;
      near = 0;
      double c = StrictMath.cos(pose.theta());
      double s = StrictMath.sin(pose.theta());
      for (int i = 0; i < scan.count; i++) {
        if (scan.loose[i]) {
          continue;
        }
        told++;
        double ax = c * scan.x[i] - s * scan.y[i];
        double ay = s * scan.x[i] + c * scan.y[i];
        double nx = c * scan.nx[i] - s * scan.ny[i];
        double ny = s * scan.nx[i] + c * scan.ny[i];
        int at = map.nearest(pose.x() + ax, pose.y() + ay, nx, ny, reach);
        if (at < 0) {
          continue;
        }
        supported++;
        double ox = map.meanX(at) - pose.x() - ax;
        double oy = map.meanY(at) - pose.y() - ay;
        double length = map.normalLength(at);
        boolean isMapped = length > 0.3;
        if (isMapped || !Double.isNaN(nx)) {
          double mx = isMapped ? map.normalX(at) / length : nx;
          double my = isMapped ? map.normalY(at) / length : ny;
          double off = row(mx, my, ax, ay, mx * ox + my * oy, 1.0);
          near += Math.abs(off) < NEAR_M ? 1 : 0;
        } else {
          double weight = 1.0 / (POINT_SIGMA * POINT_SIGMA);
          row(1.0, 0.0, ax, ay, ox, weight);
          row(0.0, 1.0, ax, ay, oy, weight);
          near += Math.hypot(ox, oy) < NEAR_M ? 1 : 0;
        }
      }
      discount();
    }

    /**
     * Removes spurious information, due to noisy surface normals, along the least constrained
     * direction, such as along a corridor.
     */
    private void discount() {
      double mean = (h[0] + h[4]) / 2.0;
      double half = Math.hypot((h[0] - h[4]) / 2.0, h[1]);
      double most = mean + half;
      double least = Math.max(0.0, mean - half);
      double told = Math.max(0.0, least - DIRECTION_NOISE * most);
      double factor = least > 0.0 ? Math.sqrt(told / least) - 1.0 : 0.0;
      double angle = StrictMath.atan2(2.0 * h[1], h[0] - h[4]) / 2.0 + Math.PI / 2.0; // of least
      double c = StrictMath.cos(angle);
      double s = StrictMath.sin(angle);
      double[] scale = {
        1.0 + factor * c * c,
        factor * c * s,
        0.0,
        factor * c * s,
        1.0 + factor * s * s,
        0.0,
        0.0,
        0.0,
        1.0
      };
      System.arraycopy(Matrix3.sandwich(scale, h), 0, h, 0, h.length);
      double x = scale[0] * g[0] + scale[1] * g[1];
      g[1] = scale[3] * g[0] + scale[4] * g[1];
      g[0] = x;
    }

    private double row(double nx, double ny, double ax, double ay, double off, double factor) {
      double weight = factor * Math.min(1.0, HUBER_M / Math.max(Math.abs(off), 1e-12));
      double turn = ny * ax - nx * ay;
      h[0] += weight * nx * nx;
      h[1] += weight * nx * ny;
      h[2] += weight * nx * turn;
      h[4] += weight * ny * ny;
      h[5] += weight * ny * turn;
      h[8] += weight * turn * turn;
      h[3] = h[1];
      h[6] = h[2];
      h[7] = h[5];
      g[0] += weight * nx * off;
      g[1] += weight * ny * off;
      g[2] += weight * turn * off;
      squares += weight * off * off;
      weights += weight;
      return off;
    }

    double rms() {
      return weights == 0.0 ? HUBER_M : Math.sqrt(squares / weights);
    }
  }
}
