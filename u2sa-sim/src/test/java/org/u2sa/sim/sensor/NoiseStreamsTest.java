package org.u2sa.sim.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;

class NoiseStreamsTest {
  @Test
  void of_sameSeedAndName_givesTheSameNumbers() {
    assertThat(new NoiseStreams(7L).of("gps").nextLong())
        .isEqualTo(new NoiseStreams(7L).of("gps").nextLong());
  }

  @Test
  void of_otherNamesAndSeeds_giveUncorrelatedNumbers() {
    NoiseStreams streams = new NoiseStreams(7L);
    assertUncorrelated(streams.of("gps"), streams.of("gps bias"));
    assertUncorrelated(streams.of("compass"), new NoiseStreams(8L).of("compass"));
    assertUncorrelated(streams.of("ab"), streams.of("ba"));
  }

  private static void assertUncorrelated(Random a, Random b) {
    int n = 10_000;
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
      sum += a.nextGaussian() * b.nextGaussian();
    }
    assertThat(sum / Math.sqrt(n)).isCloseTo(0.0, within(5.0));
  }
}
