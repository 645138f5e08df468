package org.u2sa.gcs.ros;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Future;
import java.util.concurrent.FutureTask;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.LockstepClock;

/** What a subscription with a rate limit sends, by a clock that the test moves. */
class RosSubscriptionTest {
  private final List<String> sent = new ArrayList<>();
  private final List<FutureTask<Void>> later = new ArrayList<>();
  private final RosBacklog backlog = new RosBacklog(10);
  private final LockstepClock clock = new LockstepClock();

  private RosSubscription subscription(long throttleMs, long queueLength) {
    return new RosSubscription(
        RosTopic.all(new RosFrames()).get(0),
        throttleMs,
        queueLength,
        backlog,
        String::valueOf,
        text -> sent.add(text.get()),
        (task, ms) -> {
          FutureTask<Void> planned = new FutureTask<>(task, null);
          later.add(planned);
          return planned;
        },
        clock);
  }

  private void pass(long ms) throws InterruptedException {
    clock.runUntil(() -> false, clock.micros() + ms * 1_000L);
    List<FutureTask<Void>> due = List.copyOf(later);
    later.clear();
    due.forEach(Runnable::run);
  }

  @Test
  void offer_withoutALimit_sendsEach() {
    RosSubscription all = subscription(0, 0);
    all.offer(1);
    all.offer(2);
    assertThat(sent).containsExactly("1", "2");
  }

  @Test
  void offer_tooSoonWithoutAQueue_isDropped() throws Exception {
    RosSubscription slow = subscription(100, 0);
    slow.offer(1);
    slow.offer(2);
    pass(100);
    slow.offer(3);
    assertThat(sent).containsExactly("1", "3");
  }

  @Test
  void offer_tooSoonWithAQueue_waitsAndTheOldestGoes() throws Exception {
    RosSubscription slow = subscription(100, 2);
    for (int i = 1; i <= 4; i++) {
      slow.offer(i);
    }
    pass(100);
    assertThat(sent).containsExactly("1", "3");
    pass(100);
    assertThat(sent).containsExactly("1", "3", "4");
    assertThat(later).isEmpty();
  }

  @Test
  void end_messagesWaiting_sendsNone() throws Exception {
    RosSubscription slow = subscription(100, 5);
    slow.offer(1);
    slow.offer(2);
    slow.end();
    pass(100);
    assertThat(sent).containsExactly("1");
  }

  @Test
  void end_messageWaitsForAnHour_itsTaskIsCancelledAtOnce() {
    RosSubscription slow = subscription(3_600_000, 1);
    slow.offer(1);
    slow.offer(2);
    assertThat(later).hasSize(1).noneMatch(Future::isCancelled);
    slow.end();
    assertThat(later).allMatch(Future::isCancelled);
  }

  @Test
  void offer_moreCharactersThanAClientMayHold_keepsTheNewestThatFit() throws Exception {
    RosSubscription slow = subscription(100, 100);
    RosSubscription other = subscription(100, 100);
    for (String text : List.of("first", "aaaa", "bbbb", "cccc", "longer than ten")) {
      slow.offer(text);
    }
    other.offer("first");
    other.offer("dddd");
    slow.end();
    for (String text : List.of("eeee", "ffff")) {
      other.offer(text);
    }
    pass(100);
    pass(100);
    assertThat(sent).containsExactly("first", "first", "eeee", "ffff");
  }
}
