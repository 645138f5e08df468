package org.u2sa.world.scanmap;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Pose graph, optimised by sparse Gauss-Newton (Grisetti, Kümmerle, Stachniss and Burgard, "A
 * tutorial on graph-based SLAM", IEEE ITS Magazine 2, 2010). The first pose is fixed. A Huber loss
 * beyond three standard deviations limits the influence of a wrong match or closure on the rest of
 * the graph.
 */
final class PoseGraph {
  /**
   * A measured relative pose.
   *
   * @param from index of the first pose
   * @param to index of the later pose
   * @param step pose of the later relative to the earlier pose
   * @param information in the axes of the earlier pose
   * @param isClosure whether it closes a loop and may be wrong
   */
  record Edge(int from, int to, Pose2 step, double[] information, boolean isClosure) {}

  private static final int STEPS = 30;
  private static final double DONE = 1e-3;
  private static final double TRUSTED_SIGMAS = 3.0; // Huber threshold, in standard deviations
  private static final int N = 3;

  private final List<Pose2> poses = new ArrayList<>();
  private final List<Edge> edges = new ArrayList<>();

  int add(Pose2 pose) {
    poses.add(pose);
    return poses.size() - 1;
  }

  void add(Edge edge) {
    edges.add(edge);
  }

  Pose2 pose(int number) {
    return poses.get(number);
  }

  int size() {
    return poses.size();
  }

  List<Edge> edges() {
    return List.copyOf(edges);
  }

  /**
   * Optimises all poses except the first.
   *
   * @return covariance of the last pose relative to the first
   */
  double[] optimise() {
    if (poses.size() < 2) {
      return new double[N * N];
    }
    SkylineSystem system = null;
    for (int step = 0; step < STEPS; step++) {
      double[] right = new double[N * (poses.size() - 1)];
      system = linear(right);
      double[] moved = system.solve(right);
      double largest = 0.0;
      for (int i = 1; i < poses.size(); i++) {
        int at = N * (i - 1);
        Pose2 p = poses.get(i);
        poses.set(
            i,
            new Pose2(
                p.x() + moved[at],
                p.y() + moved[at + 1],
                Pose2.wrapped(p.theta() + moved[at + 2])));
        for (int k = 0; k < N; k++) {
          largest = Math.max(largest, Math.abs(moved[at + k]));
        }
      }
      if (largest < DONE) {
        break;
      }
    }
    return lastCovariance(system);
  }

  private double[] lastCovariance(SkylineSystem system) {
    double[] covariance = new double[N * N];
    int at = N * (poses.size() - 2);
    for (int k = 0; k < N; k++) {
      double[] unit = new double[at + N];
      unit[at + k] = 1.0;
      double[] column = system.solve(unit);
      for (int i = 0; i < N; i++) {
        covariance[i * N + k] = column[at + i];
      }
    }
    return covariance;
  }

  /** Squared Mahalanobis error of an edge. */
  double square(Edge edge) {
    Pose2 off = error(edge);
    return Matrix3.square(edge.information(), off.x(), off.y(), off.theta());
  }

  /** Difference between the current and the measured relative pose, in the earlier pose's axes. */
  private Pose2 error(Edge edge) {
    Pose2 is = poses.get(edge.to()).from(poses.get(edge.from()));
    Pose2 step = edge.step();
    return new Pose2(
        is.x() - step.x(), is.y() - step.y(), Pose2.wrapped(is.theta() - step.theta()));
  }

  private SkylineSystem linear(double[] right) {
    int[] first = new int[right.length];
    for (int i = 0; i < first.length; i++) {
      first[i] = i / N * N;
    }
    for (Edge edge : edges) {
      if (edge.from() > 0) {
        for (int k = 0; k < N; k++) {
          int row = N * (edge.to() - 1) + k;
          first[row] = Math.min(first[row], N * (edge.from() - 1));
        }
      }
    }
    SkylineSystem system = new SkylineSystem(first);
    for (Edge edge : edges) {
      add(edge, system, right);
    }
    system.factor();
    return system;
  }

  private void add(Edge edge, SkylineSystem system, double[] right) {
    Pose2 a = poses.get(edge.from());
    Pose2 b = poses.get(edge.to());
    double c = StrictMath.cos(a.theta());
    double s = StrictMath.sin(a.theta());
    double dx = b.x() - a.x();
    double dy = b.y() - a.y();
    double[] ja = {-c, -s, -s * dx + c * dy, s, -c, -c * dx - s * dy, 0.0, 0.0, -1.0};
    double[] jb = {c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0};
    double scale = Math.min(1.0, TRUSTED_SIGMAS / Math.sqrt(Math.max(1e-12, square(edge))));
    double[] information = Matrix3.times(edge.information(), scale);
    Pose2 off = error(edge);
    double[] e = {off.x(), off.y(), off.theta()};
    int ra = N * (edge.from() - 1);
    int rb = N * (edge.to() - 1);
    double[] wa = Matrix3.times(information, ja);
    double[] wb = Matrix3.times(information, jb);
    for (int i = 0; i < N; i++) {
      for (int j = 0; j < N; j++) {
        double aa = column(ja, i, wa, j);
        double bb = column(jb, i, wb, j);
        if (edge.from() > 0 && j <= i) {
          system.add(ra + i, ra + j, aa);
        }
        if (j <= i) {
          system.add(rb + i, rb + j, bb);
        }
        if (edge.from() > 0) {
          system.add(rb + i, ra + j, column(jb, i, wa, j));
        }
        right[rb + i] -= wb[j * N + i] * e[j];
        if (edge.from() > 0) {
          right[ra + i] -= wa[j * N + i] * e[j];
        }
      }
    }
  }

  private static double column(double[] a, int i, double[] b, int j) {
    return a[i] * b[j] + a[N + i] * b[N + j] + a[2 * N + i] * b[2 * N + j];
  }

  /** Removes closures that contradict the rest, and returns their number. */
  int dropContradicted(double limit) {
    int before = edges.size();
    edges.removeIf(edge -> edge.isClosure() && square(edge) > limit);
    return before - edges.size();
  }

  @Override
  public String toString() {
    return Arrays.toString(new int[] {poses.size(), edges.size()});
  }
}
