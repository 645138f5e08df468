package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.access.Refusals;
import org.u2sa.core.communication.limit.Allowance;

/** What the broker counts: what it refuses, and what each user may ask. */
class CountersTest {
  private static final long SECOND = 1_000_000L;

  private final List<String> log = new ArrayList<>();
  private final Refusals refusals = new Refusals(log::add);

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
