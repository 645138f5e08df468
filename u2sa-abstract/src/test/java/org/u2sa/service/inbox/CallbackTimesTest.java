package org.u2sa.service.inbox;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CallbackTimesTest {
  @Test
  void percentiles_noTimes_areZero() {
    assertThat(new CallbackTimes().percentiles())
        .isEqualTo(new CallbackTimes.Percentiles(0.0, 0.0));
  }

  @ParameterizedTest
  @ValueSource(longs = {2, 64, 130, 5_000_000})
  void percentiles_anyTimes_areThoseOfTheLastOnesSorted(long lessThanMicros) {
    SplittableRandom random = new SplittableRandom(lessThanMicros);
    long[] all = random.longs(3L * CallbackTimes.REMEMBERED, 0, lessThanMicros).toArray();
    CallbackTimes times = new CallbackTimes();
    for (int count = 1; count <= all.length; count++) {
      times.add(all[count - 1]);

      int first = Math.max(0, count - CallbackTimes.REMEMBERED);
      long[] sorted = Arrays.copyOfRange(all, first, count);
      Arrays.sort(sorted);
      assertThat(times.percentiles())
          .isEqualTo(
              new CallbackTimes.Percentiles(
                  sorted[sorted.length / 2] / 1e6, sorted[sorted.length * 99 / 100] / 1e6));
    }
  }
}
