package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.LockstepClock;
import org.u2sa.messages.contract.EmergencyStop;

class EmergencyLatchTest {
  private final EmergencyLatch latch = new EmergencyLatch(new LockstepClock(), "boat");

  private static EmergencyStop stop(long micros) {
    EmergencyStop stop = new EmergencyStop().active(true);
    stop.timestamp(micros);
    return stop;
  }

  private static EmergencyStop clear(long clears) {
    return new EmergencyStop().active(false).clears(clears);
  }

  @Test
  void accept_clearOfTheStopItNames_lifts() {
    assertThat(latch.accept(stop(100))).isTrue();
    assertThat(latch.isStopped()).isTrue();

    assertThat(latch.accept(clear(100))).isTrue();
    assertThat(latch.isStopped()).isFalse();
  }

  @Test
  void accept_clearOfAnEarlierStop_liftsNothing() {
    latch.accept(stop(100));
    latch.accept(stop(200));
    latch.accept(stop(150));

    assertThat(latch.accept(clear(199))).isFalse();
    assertThat(latch.isStopped()).isTrue();
    assertThat(latch.stop().orElseThrow().timestamp()).hasValue(200);
  }

  @Test
  void accept_clearThatNamesNothingOrIsForeign_liftsNothing() {
    latch.accept(stop(100));
    EmergencyStop foreign = clear(100);
    foreign.systemId("other");

    assertThat(latch.accept(new EmergencyStop().active(false))).isFalse();
    assertThat(latch.accept(foreign)).isFalse();
    assertThat(latch.isStopped()).isTrue();
  }

  @Test
  void accept_echoOfTheLiftedStop_doesNotStopAgainButAnyOtherDoes() {
    latch.accept(stop(100));
    latch.accept(clear(100));

    assertThat(latch.accept(stop(100))).isFalse();
    assertThat(latch.accept(stop(99))).isTrue();
  }

  @Test
  void accept_stopWithoutTimeOrOfAnotherSystem_latches() {
    EmergencyStop unknown = new EmergencyStop().active(true);
    unknown.systemId("other");

    assertThat(latch.accept(unknown)).isTrue();
  }
}
