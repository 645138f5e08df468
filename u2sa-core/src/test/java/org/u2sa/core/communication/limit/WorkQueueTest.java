package org.u2sa.core.communication.limit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** How much of the network thread's time work gets, and in which order. */
class WorkQueueTest {
  private static final long LOOK_AGAIN_MICROS = 2_000;

  private long nowMicros;
  private Runnable next; // what the thread runs later
  private final WorkQueue queue = new WorkQueue(() -> nowMicros);
  private final List<Integer> done = new ArrayList<>();

  private void add(int number, long takesMicros) {
    queue.run(
        () -> {
          nowMicros += takesMicros;
          done.add(number);
        },
        later -> {
          assertThat(next).as("one look at a time").isNull();
          next = later;
        });
  }

  private void passUntil(long micros) {
    while (nowMicros < micros) {
      nowMicros += LOOK_AGAIN_MICROS;
      Runnable now = next;
      next = null;
      if (now != null) {
        now.run();
      }
    }
  }

  @Test
  void run_littleWork_isDoneAtOnce() {
    add(1, 100);
    add(2, 100);

    assertThat(done).containsExactly(1, 2);
    assertThat(next).isNull();
  }

  @Test
  void run_moreWorkThanTime_getsAFifthOfItInOrder() {
    for (int i = 0; i < 1_000; i++) {
      add(i, 1_000);
    }
    assertThat(done).hasSizeBetween(5, 8);

    passUntil(1_000_000);
    assertThat(done).hasSizeBetween(190, 215);
    assertThat(done).isEqualTo(IntStream.range(0, done.size()).boxed().toList());
  }

  @Test
  void run_workThatFails_doesNotKeepTheRestFromItsTurn() {
    add(1, 50_000);
    queue.run(
        () -> {
          throw new IllegalStateException("test");
        },
        later -> next = later);
    add(2, 100);
    nowMicros += 1_000_000;
    Runnable failing = next;
    next = null;
    assertThatIllegalStateException().isThrownBy(failing::run);

    passUntil(2_000_000);
    assertThat(done).containsExactly(1, 2);
  }
}
