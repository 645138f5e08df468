package org.u2sa.service.actuator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

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

  private static EmergencyStop clearGivenAt(long micros) {
    EmergencyStop clear = clear(micros).operator("Ann");
    clear.timestamp(micros);
    return clear;
  }

  /** The Safety Manager publishes it again, and a broker may deliver it twice. */
  @Test
  void accept_clearThatArrivesAgain_leavesAStopThatCameInBetweenWithAClockThatIsBehind()
      throws InterruptedException {
    latch.accept(stop(100));
    clock.advance(500_000);
    assertThat(latch.accept(clearGivenAt(200))).isTrue();
    assertThat(latch.accept(stop(50))).isTrue();
    clock.advance(500_000);

    assertThat(latch.accept(clearGivenAt(200))).isFalse();
    assertThat(successor().accept(clearGivenAt(200))).isFalse();
    assertThat(latch.isStopped()).isTrue();
    assertThat(latch.accept(clearGivenAt(201))).as("given again").isTrue();
  }

  /** Given by a program whose clock is behind; who cleared cannot have heard of it. */
  @Test
  void accept_clearUpToATime_sparesAnEarlierOneThatHasJustArrived() throws InterruptedException {
    latch.accept(stop(100));
    clock.advance(500_000);
    latch.accept(stop(50));

    assertThat(latch.accept(clear(200))).isFalse();
    assertThat(latch.stops()).containsExactly(stop(50));
    assertThat(latch.spared()).containsExactly(stop(50));

    clock.advance(500_000);
    assertThat(latch.accept(clear(200))).isTrue();
    assertThat(latch.spared()).isEmpty();
  }

  @Test
  void accept_clearByName_sparesAStopThatWasJustGivenAgainUnderItsName()
      throws InterruptedException {
    latch.accept(named("button", 100));
    clock.advance(5_000_000);
    latch.accept(named("button", 50));

    assertThat(latch.accept(lift("button"))).isFalse();
    clock.advance(500_000);
    assertThat(latch.accept(lift("button"))).isTrue();
  }

  /** The Safety Manager repeats it with the time at which it arrived there. */
  @Test
  void accept_stopWithoutATimeThatIsRepeatedWithOne_isClearedAtOnce() throws InterruptedException {
    clock.advance(100);
    latch.accept(untimed("button"));
    for (int i = 0; i < 3; i++) {
      latch.accept(named("button", 90));
    }
    assertThat(latch.accept(lift("button"))).isTrue();
    latch.accept(untimed("other"));
    latch.accept(named("other", 110));
    assertThat(latch.accept(lift("other"))).isTrue();
  }

  @Test
  void renew_standingStop_isClearedByItsNameAtOnce() throws InterruptedException {
    latch.accept(named("button", 100));
    clock.advance(200);
    EmergencyStop again = latch.renew(latch.stop().orElseThrow());

    assertThat(again.timestamp()).hasValue(200);
    assertThat(latch.stops()).containsExactly(again);
    assertThat(latch.accept(lift("button"))).isTrue();
  }

  @Test
  void accept_clearsWithoutTime_countEach() throws InterruptedException {
    latch.accept(stop(100));
    latch.accept(clear(100));
    latch.accept(stop(90));
    clock.advance(500_000);

    assertThat(latch.accept(clear(100))).isTrue();
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

  private static EmergencyStop lift(String id) {
    return new EmergencyStop().active(false).lifts(List.of(id));
  }

  private EmergencyLatch successor() {
    HandOver state = new HandOver("test");
    latch.handOver(state);
    EmergencyLatch successor = new EmergencyLatch(clock, "boat");
    successor.takeOver(state);
    return successor;
  }

  private static EmergencyStop named(String id, long micros) {
    return stop(micros).stopId(id);
  }

  /** A button, or a program, that calls all its stops the same. */
  @Test
  void accept_laterStopUnderTheIdOfALiftedOne_latchesAgain() {
    latch.accept(named("button", 100));
    latch.accept(lift("button"));

    assertThat(latch.accept(named("button", 100))).as("a repetition").isFalse();
    assertThat(latch.accept(named("button", 101))).isTrue();
    assertThat(latch.accept(lift("button"))).isTrue();
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
    latch.accept(lift("button"));

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
    latch.accept(lift("Ann 1"));

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
    latch.accept(lift("button"));

    clock.advance(10_000_001);
    assertThat(latch.accept(named("button", 5))).isTrue();
  }

  @Test
  void takeOver_longAfterTheClear_untimedStopUnderItsIdLatches() throws InterruptedException {
    latch.accept(untimed("button"));
    latch.accept(lift("button"));
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
    latch.accept(lift("button"));
    clock.advance(10_000_001);
    latch.accept(untimed("button"));
    HandOver state = new HandOver("test");
    latch.handOver(state);

    EmergencyLatch successor = new EmergencyLatch(clock, "boat");
    successor.takeOver(state);

    assertThat(successor.identities()).containsExactly("button");
  }

  private static final int TOLD_APART = 64;

  private void fill() {
    for (int i = 1; i <= TOLD_APART; i++) {
      latch.accept(named("s" + i, i));
    }
  }

  private String newest() {
    return latch.stop().orElseThrow().stopId().orElseThrow();
  }

  @Test
  void accept_clearOfTheOwnSystem_lifts() {
    latch.accept(named("a", 1));
    EmergencyStop clear = lift("a");
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

    assertThat(latch.accept(clear(499))).isFalse();
    assertThat(latch.accept(clear(500))).isTrue();
    assertThat(timeless.timestamp()).as("the message is its sender's").isEmpty();
  }

  @Test
  void accept_stopThatHoldsAlready_isThereOnce() {
    latch.accept(named("a", 1));

    assertThat(latch.accept(named("a", 1))).isFalse();
    assertThat(latch.identities()).containsExactly("a");
  }

  @Test
  void accept_asManyStopsAsAreToldApart_eachIsLiftedByItsName() {
    fill();
    for (int i = 1; i < TOLD_APART; i++) {
      assertThat(latch.accept(lift("s" + i))).isFalse();
    }
    assertThat(latch.accept(lift("s" + TOLD_APART))).isTrue();
  }

  @Test
  void accept_oneStopMore_standsUntilItsTimeIsCleared() throws InterruptedException {
    fill();
    latch.accept(named("late", 1_000));
    assertThat(latch.identities()).hasSize(TOLD_APART + 1).endsWith("late");
    clock.advance(500_000);

    latch.accept(clear(999));
    latch.accept(lift("late"));
    assertThat(latch.identities()).containsExactly("late");

    assertThat(latch.accept(clear(1_000))).isTrue();
  }

  @Test
  void accept_severalStopsMore_theNewestOfThemStands() {
    fill();
    latch.accept(named("x", 1_000));
    latch.accept(named("y", 999));
    assertThat(newest()).isEqualTo("x");
    latch.accept(named("same moment", 1_000));
    assertThat(newest()).isEqualTo("x");

    latch.accept(named("z", 1_001));

    assertThat(newest()).isEqualTo("z");
    assertThat(latch.stops()).hasSize(TOLD_APART + 1);
  }

  @Test
  void stop_ofOneMoment_isTheOneThatCameLast() {
    latch.accept(named("a", 7));
    latch.accept(named("b", 7));
    latch.accept(named("earlier", 6));

    assertThat(newest()).isEqualTo("b");
  }

  @Test
  void accept_stopsThatWereLifted_areKnownAsLongAsTwiceAsManyWereNotLifted() {
    for (int i = 1; i <= 2 * TOLD_APART; i++) {
      latch.accept(named("s" + i, i));
      latch.accept(lift("s" + i));
    }
    assertThat(latch.accept(named("s1", 1))).isFalse();

    latch.accept(named("one more", 1_000));
    latch.accept(lift("one more"));

    assertThat(latch.accept(named("s2", 2))).isFalse();
    assertThat(latch.accept(named("s1", 1))).isTrue();
  }

  @Test
  void identities_list_isNobodysToChange() {
    latch.accept(named("a", 1));

    assertThatThrownBy(() -> latch.identities().clear())
        .isInstanceOf(UnsupportedOperationException.class);
  }
}
