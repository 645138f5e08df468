package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What the broker counts: messages inside it, what it refuses, and what each user may ask. */
class CountersTest {
  private static final long SECOND = 1_000_000L;

  private final Backlog backlog = new Backlog();
  private final List<String> log = new ArrayList<>();
  private final Refusals refusals = new Refusals(log::add);

  private void letIn(int messages) {
    for (int i = 0; i < messages; i++) {
      backlog.in(1);
    }
  }

  @Test
  void backlog_asManyMessagesAsItHolds_isFullUntilOneComesOut() {
    letIn(BrokerLimits.ON_THE_WAY - 1);
    assertThat(backlog.isFull()).isFalse();
    letIn(1);
    assertThat(backlog.isFull()).isTrue();
    backlog.out(1);
    assertThat(backlog.isFull()).isFalse();
  }

  @Test
  void backlog_asManyBytesAsItHolds_isFullUntilTheyComeOut() {
    backlog.in((int) BrokerLimits.BYTES_ON_THE_WAY - 1);
    assertThat(backlog.isFull()).isFalse();
    backlog.in(1);
    assertThat(backlog.isFull()).isTrue();
    backlog.out(1);
    assertThat(backlog.isFull()).isFalse();
  }

  @Test
  void settle_nothingMovedSince_whatIsInsideIsLostAndMakesRoom() {
    letIn(BrokerLimits.ON_THE_WAY);
    assertThat(backlog.settle()).as("it moved").isZero();
    assertThat(backlog.isFull()).isTrue();

    assertThat(backlog.settle()).isEqualTo(BrokerLimits.ON_THE_WAY);

    assertThat(backlog.isFull()).isFalse();
    assertThat(backlog.settle()).as("told once").isZero();
    letIn(BrokerLimits.ON_THE_WAY - 1);
    assertThat(backlog.isFull()).isFalse();
    letIn(1);
    assertThat(backlog.isFull()).isTrue();
  }

  @Test
  void settle_oneCameOutMeanwhile_nothingIsLostYet() {
    letIn(2);
    backlog.settle();
    backlog.out(1);

    assertThat(backlog.settle()).isZero();
    assertThat(backlog.settle()).isOne();
  }

  @Test
  void settle_bytesOfWhatIsLost_areForgotten() {
    backlog.in((int) BrokerLimits.BYTES_ON_THE_WAY);
    backlog.settle();
    assertThat(backlog.isFull()).isTrue();

    backlog.settle();

    assertThat(backlog.isFull()).isFalse();
  }

  @Test
  void settle_bytesThatNeverComeOutThoughTheirMessageDid_areForgotten() {
    backlog.in((int) BrokerLimits.BYTES_ON_THE_WAY + 1);
    backlog.out(1);
    backlog.settle();

    assertThat(backlog.settle()).isZero();

    assertThat(backlog.isFull()).isFalse();
  }

  @Test
  void settle_moreCameOutThanWentIn_isNoLossAndLeavesNoExtraRoom() {
    backlog.out(1); // a will, which Moquette publishes by itself
    backlog.settle();
    assertThat(backlog.settle()).isZero();

    letIn(BrokerLimits.ON_THE_WAY);
    assertThat(backlog.isFull()).isTrue();
  }

  @Test
  void kept_bytes_areSummed() {
    backlog.keep(3);
    backlog.keep(4);

    assertThat(backlog.kept()).isEqualTo(7);
  }

  @Test
  void refusals_ofOneKind_areToldAtPowersOfTwo() {
    for (int i = 1; i <= 5; i++) {
      refusals.add("will", "no " + i);
    }
    refusals.add("login", "other");

    assertThat(log)
        .containsExactly(
            "will: no 1 (1 so far)",
            "will: no 2 (2 so far)",
            "will: no 4 (4 so far)",
            "login: other (1 so far)");
    assertThat(refusals.total()).isEqualTo(6);
    assertThat(refusals.of("will")).isEqualTo(5);
    assertThat(refusals.of("none")).isZero();
  }

  @Test
  void refusals_ofMoreKindsThanAreToldApart_areCountedTogether() {
    for (int i = 1; i <= 512; i++) {
      refusals.add("kind " + i, "x");
    }
    refusals.add("one more", "x");
    refusals.add("kind 512", "x");

    assertThat(refusals.of("kind 512")).isEqualTo(2);
    assertThat(refusals.of("one more")).isZero();
    assertThat(refusals.of("others")).isOne();
    assertThat(refusals.total()).isEqualTo(514);
  }

  @Test
  void shown_longTextWithControlCharacters_isOneShortLine() {
    assertThat(Refusals.shown("a\nb\u0000\u009b")).isEqualTo("\"a b \"");
    assertThat(Refusals.shown("x".repeat(120))).isEqualTo("\"" + "x".repeat(120) + "\"");
    assertThat(Refusals.shown("x".repeat(121))).isEqualTo("\"" + "x".repeat(120) + "…\"");
  }

  @Test
  void take_ofOneUser_leavesTheOthersAlone() {
    Allowance.PerUser allowances = new Allowance.PerUser(4.0);
    assertThat(allowances.take("ann", 1.0, 0)).isTrue();
    assertThat(allowances.take("ann", 1.0, 0)).isFalse();
    assertThat(allowances.take("bob", 1.0, 0)).isTrue();

    assertThat(allowances.take("ann", 1.0, SECOND / 4)).isTrue();
  }

  @Test
  void take_moreUsersThanAreRemembered_theOneNotSeenLongestBeginsAnew() {
    Allowance.PerUser allowances = new Allowance.PerUser(1.0);
    for (int i = 1; i <= 1_024; i++) {
      allowances.take("u" + i, 1.0, 0);
    }
    assertThat(allowances.take("u1", 1.0, 0)).isFalse(); // and so was seen last

    assertThat(allowances.take("one more", 1.0, 0)).isTrue();

    assertThat(allowances.take("u1", 1.0, 0)).isFalse();
    assertThat(allowances.take("u2", 1.0, 0)).isTrue();
  }
}
