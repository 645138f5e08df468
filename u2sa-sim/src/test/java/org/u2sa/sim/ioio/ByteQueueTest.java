package org.u2sa.sim.ioio;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ByteQueueTest {
  private static final int CAPACITY = 17;

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void pull_afterPushesOfAnyLength_givesWhatFittedInOrder(long seed) {
    Random random = new Random(seed);
    ByteQueue queue = new ByteQueue(CAPACITY);
    Deque<Byte> expected = new ArrayDeque<>();
    byte[] pulled = new byte[CAPACITY];
    for (int step = 0; step < 2_000; step++) {
      byte[] bytes = new byte[12];
      random.nextBytes(bytes);
      int offset = random.nextInt(3);
      int length = random.nextInt(10);
      if (expected.size() + length <= CAPACITY) { // or else all are dropped
        for (int i = 0; i < length; i++) {
          expected.add(bytes[offset + i]);
        }
      }
      queue.push(bytes, offset, length);
      assertThat(queue.size()).isEqualTo(expected.size());

      int count = queue.pull(pulled, random.nextInt(8));
      for (int i = 0; i < count; i++) {
        assertThat(pulled[i]).isEqualTo(expected.remove());
      }
    }
  }
}
