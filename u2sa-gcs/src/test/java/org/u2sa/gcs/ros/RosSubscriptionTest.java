package org.u2sa.gcs.ros;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.LockstepClock;

/** What a subscription with a rate limit sends, by a clock that the test moves. */
class RosSubscriptionTest {
  private final List<Object> sent = new ArrayList<>();
  private final List<Runnable> later = new ArrayList<>();
  private final LockstepClock clock = new LockstepClock();

  private RosSubscription subscription(long throttleMs, long queueLength) {
    return new RosSubscription(
        RosTopic.all(new RosFrames()).get(0),
        RosSpelling.ROS_2,
        throttleMs,
        queueLength,
        sent::add,
        (task, ms) -> later.add(task),
        clock);
  }

  private void pass(long ms) throws InterruptedException {
    clock.runUntil(() -> false, clock.micros() + ms * 1_000L);
    List<Runnable> due = List.copyOf(later);
    later.clear();
    due.forEach(Runnable::run);
  }

  @Test
  void offer_withoutALimit_sendsEach() {
    RosSubscription all = subscription(0, 0);
    all.offer(1);
    all.offer(2);
    assertThat(sent).containsExactly(1, 2);
  }

  @Test
  void offer_tooSoonWithoutAQueue_isDropped() throws Exception {
    RosSubscription slow = subscription(100, 0);
    slow.offer(1);
    slow.offer(2);
    pass(100);
    slow.offer(3);
    assertThat(sent).containsExactly(1, 3);
  }

  @Test
  void offer_tooSoonWithAQueue_waitsAndTheOldestGoes() throws Exception {
    RosSubscription slow = subscription(100, 2);
    for (int i = 1; i <= 4; i++) {
      slow.offer(i);
    }
    pass(100);
    assertThat(sent).containsExactly(1, 3);
    pass(100);
    assertThat(sent).containsExactly(1, 3, 4);
    assertThat(later).isEmpty();
  }

  @Test
  void end_messagesWaiting_sendsNone() throws Exception {
    RosSubscription slow = subscription(100, 5);
    slow.offer(1);
    slow.offer(2);
    slow.end();
    pass(100);
    assertThat(sent).containsExactly(1);
  }
}
