package org.u2sa.service.actuator;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.service.handover.HandOver;

class EmergencyLatchTest {
  private final LockstepClock clock = new LockstepClock();
  private final EmergencyLatch latch = new EmergencyLatch(clock, "boat");

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

  private static EmergencyStop named(String id, long micros) {
    return stop(micros).stopId(id);
  }

  /** A button, or a program, that calls all its stops the same. */
  @Test
  void accept_laterStopUnderTheIdOfALiftedOne_latchesAgain() {
    latch.accept(named("button", 100));
    latch.accept(clear(100).lifts(List.of("button")));

    assertThat(latch.accept(named("button", 100))).as("a repetition").isFalse();
    assertThat(latch.accept(named("button", 101))).isTrue();
    assertThat(latch.accept(clear(0).lifts(List.of("button")))).isTrue();
    assertThat(latch.accept(named("button", 101))).isFalse();
    assertThat(latch.accept(named("button", 90))).as("after a step of its clock").isTrue();
  }

  @Test
  void accept_laterStopUnderTheIdOfOneThatHolds_countsForClearsUpToATime() {
    latch.accept(named("button", 100));
    latch.accept(named("button", 200));
    latch.accept(named("button", 150));

    assertThat(latch.identities()).containsExactly("button");
    assertThat(latch.accept(clear(199))).isFalse();
    assertThat(latch.accept(clear(200))).isTrue();
  }

  private static EmergencyStop untimed(String id) {
    return new EmergencyStop().active(true).stopId(id);
  }

  @Test
  void accept_stopWithoutATimeUnderTheIdOfALiftedOne_latchesAgainAfterTheTimeOfRepetitions()
      throws InterruptedException {
    latch.accept(untimed("button"));
    latch.accept(clear(0).lifts(List.of("button")));

    clock.advance(10_000_000);
    assertThat(latch.accept(untimed("button"))).isFalse();
    assertThat(latch.accept(named("button", 5))).as("of who stamped it on arrival").isFalse();
    clock.advance(1);
    assertThat(latch.accept(untimed("button"))).isTrue();
  }

  @Test
  void takeOver_stopUnderTheIdOfALiftedOne_latchesIfItIsAnother() {
    latch.accept(named("button", 100));
    latch.accept(clear(100));
    HandOver state = new HandOver("test");
    latch.handOver(state);

    EmergencyLatch successor = new EmergencyLatch(clock, "boat");
    successor.takeOver(state);

    assertThat(successor.accept(named("button", 100))).isFalse();
    assertThat(successor.accept(named("button", 101))).isTrue();
  }

  @Test
  void accept_anotherStopOfTheLiftedOnesMicrosecond_latches() {
    latch.accept(named("Ann 1", 100));
    latch.accept(clear(100).lifts(List.of("Ann 1")));

    assertThat(latch.accept(named("Ann 1", 100))).isFalse();
    assertThat(latch.accept(named("Bob 1", 100))).isTrue();
    assertThat(latch.stop().orElseThrow().stopId()).contains("Bob 1");
  }

  @Test
  void accept_stopsOfOneMicrosecondWithoutIds_areToldApartByWhoStopped() {
    latch.accept(stop(100).operator("Ann"));
    latch.accept(clear(100));

    assertThat(latch.accept(stop(100).operator("Bob"))).isTrue();
  }

  @Test
  void accept_clearThatNamesOne_leavesTheOtherWhateverItsTime() {
    latch.accept(named("Ann 1", 100));
    latch.accept(named("Bob 1", 50)); // a clock that is behind: nobody has seen it yet

    assertThat(latch.accept(clear(200).lifts(List.of("Ann 1")))).isFalse();
    assertThat(latch.identities()).containsExactly("Bob 1");
    assertThat(latch.accept(clear(50))).isTrue();
  }

  @Test
  void accept_floodOfStops_holdsUntilTheNewestIsCleared() {
    for (int i = 1; i <= 1000; i++) {
      latch.accept(named("flood " + i, i));
    }
    assertThat(latch.stops()).hasSizeLessThan(100);
    assertThat(latch.stop().orElseThrow().stopId()).contains("flood 1000");

    assertThat(latch.accept(clear(999))).isFalse();
    assertThat(latch.accept(clear(1000))).isTrue();
  }

  @Test
  void takeOver_afterLatchOfTheSameService_knowsWhatHoldsAndWhatWasLifted() {
    latch.accept(named("Ann 1", 100));
    latch.accept(clear(100));
    latch.accept(named("Ann 2", 200));
    HandOver state = new HandOver("test");
    latch.handOver(state);

    EmergencyLatch successor = new EmergencyLatch(new LockstepClock(), "boat");
    successor.takeOver(state);

    assertThat(successor.identities()).containsExactly("Ann 2");
    assertThat(successor.accept(clear(200))).isTrue();
    assertThat(successor.accept(named("Ann 1", 100))).isFalse();
    assertThat(successor.accept(named("Ann 2", 200))).isFalse();
  }

  @Test
  void accept_stopWithoutTimeOrOfAnotherSystem_latches() {
    EmergencyStop unknown = new EmergencyStop().active(true);
    unknown.systemId("other");

    assertThat(latch.accept(unknown)).isTrue();
  }

  @Test
  void accept_stopWithATimeUnderTheIdOfALiftedOneWithout_latchesAfterTheTimeOfRepetitions()
      throws InterruptedException {
    latch.accept(untimed("button"));
    latch.accept(clear(0).lifts(List.of("button")));

    clock.advance(10_000_001);
    assertThat(latch.accept(named("button", 5))).isTrue();
  }

  @Test
  void takeOver_longAfterTheClear_untimedStopUnderItsIdLatches() throws InterruptedException {
    latch.accept(untimed("button"));
    latch.accept(clear(0).lifts(List.of("button")));
    clock.advance(60_000_000);
    HandOver state = new HandOver("test");
    latch.handOver(state);

    EmergencyLatch successor = new EmergencyLatch(clock, "boat");
    successor.takeOver(state);

    assertThat(successor.accept(untimed("button"))).isTrue();
  }

  @Test
  void takeOver_stopThatStandsUnderTheIdOfALiftedOne_stands() throws InterruptedException {
    latch.accept(untimed("button"));
    latch.accept(clear(0).lifts(List.of("button")));
    clock.advance(10_000_001);
    latch.accept(untimed("button"));
    HandOver state = new HandOver("test");
    latch.handOver(state);

    EmergencyLatch successor = new EmergencyLatch(clock, "boat");
    successor.takeOver(state);

    assertThat(successor.identities()).containsExactly("button");
  }
}
