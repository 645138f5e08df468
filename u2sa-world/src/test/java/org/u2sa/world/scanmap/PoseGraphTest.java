package org.u2sa.world.scanmap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class PoseGraphTest {
  private static final double[] STEP = Matrix3.inverse(Matrix3.ofSigmas(0.05, 0.05, 0.02));
  private static final int SIDE = 20;

  /** Four sides of a square, driven twice, with steps that err. */
  private static PoseGraph driven(long seed) {
    Random random = new Random(seed);
    PoseGraph graph = new PoseGraph();
    Pose2 pose = Pose2.ORIGIN;
    graph.add(pose);
    for (int i = 1; i <= 8 * SIDE; i++) {
      Pose2 step =
          new Pose2(
              1.0 + 0.05 * random.nextGaussian(),
              0.05 * random.nextGaussian(),
              (i % SIDE == 0 ? Math.PI / 2 : 0.0) + 0.02 * random.nextGaussian());
      pose = pose.times(step);
      graph.add(pose);
      graph.add(new PoseGraph.Edge(i - 1, i, step, STEP, false));
    }
    return graph;
  }

  @Test
  void optimise_closedLoop_secondRoundLiesOnTheFirst() {
    PoseGraph graph = driven(5);
    double before = graph.pose(6 * SIDE).distance(graph.pose(2 * SIDE));
    for (int i = 0; i <= 4 * SIDE; i += 10) {
      graph.add(new PoseGraph.Edge(i, i + 4 * SIDE, Pose2.ORIGIN, STEP, true));
    }

    double[] covariance = graph.optimise();

    assertThat(before).isGreaterThan(1.0);
    assertThat(graph.pose(6 * SIDE).distance(graph.pose(2 * SIDE))).isLessThan(0.2);
    assertThat(Matrix3.largestSigma(covariance)).isLessThan(0.3);
    assertThat(graph.dropContradicted(40.0)).isZero();
  }

  @Test
  void optimise_oneWrongClosure_isOutweighedAndDropped() {
    PoseGraph graph = driven(5);
    for (int i = 0; i <= 4 * SIDE; i += 10) {
      graph.add(new PoseGraph.Edge(i, i + 4 * SIDE, Pose2.ORIGIN, STEP, true));
    }
    graph.add(new PoseGraph.Edge(5, 3 * SIDE, new Pose2(0.0, 0.0, 2.0), STEP, true));

    graph.optimise();

    assertThat(graph.dropContradicted(40.0)).isEqualTo(1);
    assertThat(graph.pose(6 * SIDE).distance(graph.pose(2 * SIDE))).isLessThan(0.3);
  }

  @Test
  void solve_randomSystem_givesTheSolution() {
    Random random = new Random(1);
    int n = 12;
    int[] first = {0, 0, 1, 2, 0, 4, 5, 3, 7, 8, 1, 10};
    double[][] full = new double[n][n];
    SkylineSystem system = new SkylineSystem(first);
    for (int i = 0; i < n; i++) {
      for (int k = first[i]; k <= i; k++) {
        double value = i == k ? 20.0 : random.nextGaussian();
        full[i][k] = value;
        full[k][i] = value;
        system.add(i, k, value);
      }
    }
    double[] right = random.doubles(n).toArray();
    system.factor();

    double[] x = system.solve(right);

    for (int i = 0; i < n; i++) {
      double sum = 0.0;
      for (int k = 0; k < n; k++) {
        sum += full[i][k] * x[k];
      }
      assertThat(sum).isCloseTo(right[i], within(1e-9));
    }
  }
}
