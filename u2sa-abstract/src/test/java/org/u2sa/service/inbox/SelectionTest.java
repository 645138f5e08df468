package org.u2sa.service.inbox;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class SelectionTest {
  @Test
  void nth_anyNumbers_isThatOfTheSortedOnes() {
    SplittableRandom random = new SplittableRandom(5);
    for (int count = 1; count < 60; count++) {
      for (long range : new long[] {1, 3, 1_000_000}) {
        long[] numbers = random.longs(count, -range, range).toArray();
        long[] sorted = numbers.clone();
        Arrays.sort(sorted);
        for (int index = 0; index < count; index++) {
          assertThat(Selection.nth(Arrays.copyOf(numbers, count + 3), count, index))
              .isEqualTo(sorted[index]);
        }
      }
    }
  }
}
