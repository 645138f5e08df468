package org.u2sa.sim.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SensorNoiseTest {
  private static final int COUNT = 10_000;

  @ParameterizedTest
  @ValueSource(longs = {0, 1, -1, 42, Long.MIN_VALUE, 0x9E3779B97F4A7C15L})
  void next_anySeed_isWhatRandomGives(long seed) {
    Random random = new Random(seed);
    Random noise = new SensorNoise(seed);
    for (int i = 0; i < COUNT; i++) {
      assertThat(noise.nextGaussian()).isEqualTo(random.nextGaussian());
      if (i % 3 == 0) { // between the two of a pair, too
        assertThat(noise.nextDouble()).isEqualTo(random.nextDouble());
        assertThat(noise.nextInt()).isEqualTo(random.nextInt());
        assertThat(noise.nextLong()).isEqualTo(random.nextLong());
        assertThat(noise.nextInt(7)).isEqualTo(random.nextInt(7));
        assertThat(noise.nextBoolean()).isEqualTo(random.nextBoolean());
      }
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {3, 4})
  void setSeed_betweenTheTwoOfAPair_beginsAnew(long seed) {
    Random random = new Random(1);
    Random noise = new SensorNoise(1);
    random.nextGaussian();
    noise.nextGaussian();
    random.setSeed(seed);
    noise.setSeed(seed);
    assertThat(noise.nextGaussian()).isEqualTo(random.nextGaussian());
  }
}
