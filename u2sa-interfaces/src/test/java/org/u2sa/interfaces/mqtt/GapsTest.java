package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.schema.Origin;

class GapsTest {
  private static final String TOPIC = "u2sa/cessna/state/StateInformation";

  private long micros;
  private final Gaps gaps = new Gaps(() -> micros);

  @Test
  void arrived_numbersLeftOut_areMissed() {
    assertThat(arrived("a", 5)).isZero(); // heard first: what came before it was for others
    assertThat(arrived("a", 6)).isZero();
    assertThat(arrived("a", 9)).isEqualTo(2);

    assertThat(gaps.missed()).isEqualTo(2);
  }

  @Test
  void arrived_again_countsNothing() {
    arrived("a", 1);
    arrived("a", 2);
    assertThat(arrived("a", 2)).isEqualTo(Gaps.REPEATED);
    assertThat(arrived("a", 1)).isEqualTo(Gaps.REPEATED);
    assertThat(arrived("a", 3)).isZero();

    assertThat(gaps.missed()).isZero();
  }

  /** Whoever may write on a topic can use another's name there. */
  @Test
  void arrived_afterAForgedNumber_theTrueOnesCountAgainSoon() {
    arrived("a", 1);
    arrived("a", 1L << 62);
    int ignored = 0;
    for (long number = 2; arrived("a", number) == Gaps.REPEATED; number++) {
      ignored++;
      micros += 1_000_000L;
    }

    assertThat(ignored).isEqualTo(5);
    assertThat(arrived("a", 8)).isZero();
  }

  @Test
  void arrived_oldOnesForLongBesideNewOnes_stayRepetitions() {
    for (long number = 10; number < 40; number++) {
      assertThat(arrived("a", number)).isZero();
      for (long old = 1; old < 6; old++) {
        micros += 200_000L;
        assertThat(arrived("a", old)).isEqualTo(Gaps.REPEATED);
      }
    }
  }

  @Test
  void arrived_ofOtherSendersAndTopics_areToldApart() {
    arrived("a", 1);
    arrived("b", 7);
    gaps.arrived("u2sa/cessna/health/HealthReport", Optional.of(new Origin("a", 40)));
    assertThat(arrived("a", 2)).isZero();
    assertThat(arrived("b", 8)).isZero();

    assertThat(gaps.missed()).isZero();
  }

  @Test
  void arrived_withoutOrigin_countsNothing() {
    assertThat(gaps.arrived(TOPIC, Optional.empty())).isZero();
  }

  @Test
  void missed_sumBeyond64Bits_isTheLargestNumber() {
    for (String sender : new String[] {"a", "b", "c"}) {
      arrived(sender, 1);
      assertThat(arrived(sender, Long.MAX_VALUE)).isEqualTo(Long.MAX_VALUE - 2);
    }

    assertThat(gaps.missed()).isEqualTo(Long.MAX_VALUE);
  }

  @Test
  void arrived_fromManySenders_remembersTheLatestOnly() {
    arrived("first", 1);
    for (int sender = 0; sender < 5_000; sender++) {
      arrived("s" + sender, 1);
    }
    assertThat(arrived("first", 100)).isZero(); // forgotten: heard as if for the first time
    assertThat(arrived("s4999", 3)).isEqualTo(1);
  }

  @Test
  void arrived_fromAsManySendersAsAreRemembered_forgetsTheOldestWithTheNextOne() {
    arrived("oldest", 1);
    arrived("second", 1);
    for (int sender = 3; sender <= 4_096; sender++) {
      arrived("s" + sender, 1);
    }
    assertThat(arrived("oldest", 3)).isEqualTo(1); // and so is heard last

    arrived("one more", 1);

    assertThat(arrived("oldest", 5)).isEqualTo(1);
    assertThat(arrived("second", 9)).isZero();
  }

  private long arrived(String sender, long sequence) {
    return gaps.arrived(TOPIC, Optional.of(new Origin(sender, sequence)));
  }
}
