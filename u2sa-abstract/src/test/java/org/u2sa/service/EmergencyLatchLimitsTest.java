package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.service.actuator.EmergencyLatch;

/** How many stops are told apart, how many lifted ones are remembered, and what comes after. */
class EmergencyLatchLimitsTest {
  private static final int TOLD_APART = 64;

  private final LockstepClock clock = new LockstepClock();
  private final EmergencyLatch latch = new EmergencyLatch(clock, "boat");

  private static EmergencyStop stop(String id, long micros) {
    EmergencyStop stop = new EmergencyStop().active(true).stopId(id);
    stop.timestamp(micros);
    return stop;
  }

  private static EmergencyStop clear(String id) {
    return new EmergencyStop().active(false).lifts(List.of(id));
  }

  private static EmergencyStop clearUntil(long micros) {
    return new EmergencyStop().active(false).clears(micros);
  }

  private void fill() {
    for (int i = 1; i <= TOLD_APART; i++) {
      latch.accept(stop("s" + i, i));
    }
  }

  private String newest() {
    return latch.stop().orElseThrow().stopId().orElseThrow();
  }

  @Test
  void accept_clearOfTheOwnSystem_lifts() {
    latch.accept(stop("a", 1));
    EmergencyStop clear = clear("a");
    clear.systemId("boat");

    assertThat(latch.accept(clear)).isTrue();
    assertThat(latch.stop()).isEmpty();
  }

  @Test
  void accept_stopWithoutATime_isOfNow() throws InterruptedException {
    clock.advance(500);
    EmergencyStop timeless = new EmergencyStop().active(true);
    latch.accept(timeless);
    assertThat(latch.stop().orElseThrow().timestamp()).hasValue(500);

    assertThat(latch.accept(clearUntil(499))).isFalse();
    assertThat(latch.accept(clearUntil(500))).isTrue();
    assertThat(timeless.timestamp()).as("the message is its sender's").isEmpty();
  }

  @Test
  void accept_stopThatHoldsAlready_isThereOnce() {
    latch.accept(stop("a", 1));

    assertThat(latch.accept(stop("a", 1))).isFalse();
    assertThat(latch.identities()).containsExactly("a");
  }

  @Test
  void accept_asManyStopsAsAreToldApart_eachIsLiftedByItsName() {
    fill();
    for (int i = 1; i < TOLD_APART; i++) {
      assertThat(latch.accept(clear("s" + i))).isFalse();
    }
    assertThat(latch.accept(clear("s" + TOLD_APART))).isTrue();
  }

  @Test
  void accept_oneStopMore_standsUntilItsTimeIsCleared() {
    fill();
    latch.accept(stop("late", 1_000));
    assertThat(latch.identities()).hasSize(TOLD_APART + 1).endsWith("late");

    latch.accept(clearUntil(999));
    latch.accept(clear("late"));
    assertThat(latch.identities()).containsExactly("late");

    assertThat(latch.accept(clearUntil(1_000))).isTrue();
  }

  @Test
  void accept_severalStopsMore_theNewestOfThemStands() {
    fill();
    latch.accept(stop("x", 1_000));
    latch.accept(stop("y", 999));
    assertThat(newest()).isEqualTo("x");
    latch.accept(stop("same moment", 1_000));
    assertThat(newest()).isEqualTo("x");

    latch.accept(stop("z", 1_001));

    assertThat(newest()).isEqualTo("z");
    assertThat(latch.stops()).hasSize(TOLD_APART + 1);
  }

  @Test
  void stop_ofOneMoment_isTheOneThatCameLast() {
    latch.accept(stop("a", 7));
    latch.accept(stop("b", 7));
    latch.accept(stop("earlier", 6));

    assertThat(newest()).isEqualTo("b");
  }

  @Test
  void accept_stopsThatWereLifted_areKnownAsLongAsTwiceAsManyWereNotLifted() {
    for (int i = 1; i <= 2 * TOLD_APART; i++) {
      latch.accept(stop("s" + i, i));
      latch.accept(clear("s" + i));
    }
    assertThat(latch.accept(stop("s1", 1))).isFalse();

    latch.accept(stop("one more", 1_000));
    latch.accept(clear("one more"));

    assertThat(latch.accept(stop("s2", 2))).isFalse();
    assertThat(latch.accept(stop("s1", 1))).isTrue();
  }

  @Test
  void identities_list_isNobodysToChange() {
    latch.accept(stop("a", 1));

    assertThatThrownBy(() -> latch.identities().clear())
        .isInstanceOf(UnsupportedOperationException.class);
  }
}
