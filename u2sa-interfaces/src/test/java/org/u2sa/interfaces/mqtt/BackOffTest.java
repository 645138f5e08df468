package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;

/** How the waits between two attempts to connect grow. */
class BackOffTest {
  private static Random always(double value) {
    return new Random() {
      private static final long serialVersionUID = 1L;

      @Override
      public double nextDouble() {
        return value;
      }
    };
  }

  private static long[] waits(MqttLink.BackOff backOff, int count) {
    long[] waits = new long[count];
    for (int i = 0; i < count; i++) {
      waits[i] = backOff.nextMs();
    }
    return waits;
  }

  @Test
  void nextMs_leastChance_isHalfOfWhatDoublesUpToTwoSeconds() {
    assertThat(waits(new MqttLink.BackOff(always(0.0)), 7))
        .containsExactly(50, 100, 200, 400, 800, 1_000, 1_000);
  }

  @Test
  void nextMs_mostChance_isTheWholeOfWhatDoublesUpToTwoSeconds() {
    assertThat(waits(new MqttLink.BackOff(always(Math.nextDown(1.0))), 7))
        .containsExactly(100, 200, 400, 800, 1_600, 2_000, 2_000);
  }

  @Test
  void reset_afterFailures_beginsWithTheShortestWait() {
    MqttLink.BackOff backOff = new MqttLink.BackOff(always(0.0));
    waits(backOff, 4);

    backOff.reset();

    assertThat(backOff.nextMs()).isEqualTo(50);
  }
}
