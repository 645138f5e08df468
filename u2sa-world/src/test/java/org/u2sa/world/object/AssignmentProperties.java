package org.u2sa.world.object;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;

/** The least sum of costs, against trying all pairings. */
class AssignmentProperties {
  @Property(tries = 500)
  void of_anyCosts_isAsCheapAsTheCheapestOfAll(
      @ForAll @IntRange(min = 1, max = 6) int rows,
      @ForAll @IntRange(min = 0, max = 2) int more,
      @ForAll long seed) {
    Random random = new Random(seed);
    double[][] cost = new double[rows][rows + more];
    for (double[] row : cost) {
      for (int k = 0; k < row.length; k++) {
        row[k] = random.nextInt(4) == 0 ? random.nextInt(5) : 100.0 * random.nextDouble();
      }
    }

    int[] columnOf = Assignment.of(cost);

    assertThat(columnOf).doesNotHaveDuplicates();
    double sum = IntStream.range(0, rows).mapToDouble(i -> cost[i][columnOf[i]]).sum();
    assertThat(sum).isCloseTo(cheapest(cost, 0, new boolean[rows + more]), within(1e-9));
  }

  private static double cheapest(double[][] cost, int row, boolean[] taken) {
    if (row == cost.length) {
      return 0.0;
    }
    double best = Double.POSITIVE_INFINITY;
    for (int k = 0; k < taken.length; k++) {
      if (!taken[k]) {
        taken[k] = true;
        best = Math.min(best, cost[row][k] + cheapest(cost, row + 1, taken));
        taken[k] = false;
      }
    }
    return best;
  }
}
