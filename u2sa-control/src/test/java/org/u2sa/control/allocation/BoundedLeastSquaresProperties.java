package org.u2sa.control.allocation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

class BoundedLeastSquaresProperties {
  /** A random problem: five equations of unlike weight, effort, and bounds. */
  private static final class Problem {
    final double[][] h;
    final double[] g;
    final double[] lowest;
    final double[] highest;

    Problem(long seed, int size, double errorOverEffort) {
      Random random = new Random(seed);
      h = new double[size][size];
      g = new double[size];
      lowest = new double[size];
      highest = new double[size];
      for (int i = 0; i < size; i++) {
        h[i][i] = 0.5 + random.nextDouble();
        lowest[i] = random.nextInt(4) == 0 ? 0.0 : -random.nextDouble();
        highest[i] = random.nextInt(5) == 0 ? 0.0 : random.nextDouble();
      }
      for (int row = 0; row < 5; row++) {
        double[] a = random.doubles(size, -1.0, 1.0).toArray();
        double wanted = random.nextGaussian() * size * 0.5;
        for (int i = 0; i < size; i++) {
          g[i] += errorOverEffort * a[i] * wanted;
          for (int k = 0; k < size; k++) {
            h[i][k] += errorOverEffort * a[i] * a[k];
          }
        }
      }
    }

    double cost(double[] x) {
      double cost = 0.0;
      for (int i = 0; i < x.length; i++) {
        cost -= g[i] * x[i];
        for (int k = 0; k < x.length; k++) {
          cost += 0.5 * x[i] * h[i][k] * x[k];
        }
      }
      return cost;
    }

    /** The least cost of all ways to hold unknowns at their bounds: 3^n of them. */
    double leastCost() {
      int size = g.length;
      double least = Double.POSITIVE_INFINITY;
      int ways = (int) Math.pow(3, size);
      for (int way = 0; way < ways; way++) {
        double[] x = at(way);
        if (x != null) {
          least = Math.min(least, cost(x));
        }
      }
      return least;
    }

    private double[] at(int way) {
      int size = g.length;
      double[] x = new double[size];
      boolean[] isFree = new boolean[size];
      int free = 0;
      for (int i = 0, rest = way; i < size; i++, rest /= 3) {
        isFree[i] = rest % 3 == 0;
        x[i] = rest % 3 == 1 ? lowest[i] : rest % 3 == 2 ? highest[i] : 0.0;
        free += isFree[i] ? 1 : 0;
      }
      if (free > 0) {
        double[][] matrix = new double[free][free];
        double[] right = new double[free];
        for (int i = 0, row = 0; i < size; i++) {
          if (isFree[i]) {
            right[row] = g[i];
            for (int k = 0, column = 0; k < size; k++) {
              if (isFree[k]) {
                matrix[row][column++] = h[i][k];
              } else {
                right[row] -= h[i][k] * x[k];
              }
            }
            row++;
          }
        }
        double[] solved = Gauss.solve(matrix, right);
        for (int i = 0, row = 0; i < size; i++) {
          if (isFree[i]) {
            x[i] = solved[row++];
            if (x[i] < lowest[i] - 1e-12 || x[i] > highest[i] + 1e-12) {
              return null;
            }
          }
        }
      }
      return x;
    }
  }

  @Property(tries = 300)
  void solve_anyProblem_costsWhatTheBestOfAllActiveSetsCosts(
      @ForAll long seed, @ForAll @IntRange(min = 1, max = 6) int size) {
    Problem problem = new Problem(seed, size, 100.0);

    double[] x =
        new BoundedLeastSquares(size).solve(problem.h, problem.g, problem.lowest, problem.highest);

    for (int i = 0; i < size; i++) {
      assertThat(x[i]).isBetween(problem.lowest[i], problem.highest[i]);
    }
    double best = problem.leastCost();
    assertThat(problem.cost(x)).isCloseTo(best, within(1e-9 * (1.0 + Math.abs(best))));
  }

  /** Karush–Kuhn–Tucker: no unknown can be moved within its bounds to a lower cost. */
  @Property(tries = 500)
  void solve_largeStiffProblem_fulfilsTheConditionsOfOptimality(
      @ForAll long seed, @ForAll @IntRange(min = 4, max = 16) int size) {
    Problem problem = new Problem(seed, size, 1e6);

    double[] x =
        new BoundedLeastSquares(size).solve(problem.h, problem.g, problem.lowest, problem.highest);

    double scale = 0.0;
    for (double each : problem.g) {
      scale = Math.max(scale, Math.abs(each));
    }
    for (int i = 0; i < size; i++) {
      double slope = -problem.g[i];
      for (int k = 0; k < size; k++) {
        slope += problem.h[i][k] * x[k];
      }
      if (x[i] > problem.lowest[i]) {
        assertThat(slope).isLessThan(1e-7 * scale);
      }
      if (x[i] < problem.highest[i]) {
        assertThat(slope).isGreaterThan(-1e-7 * scale);
      }
    }
  }
}
