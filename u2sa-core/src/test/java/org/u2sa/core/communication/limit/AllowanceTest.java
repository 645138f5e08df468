package org.u2sa.core.communication.limit;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class AllowanceTest {
  private static final long SECOND = 1_000_000L;

  /** How many units of one go at that moment. */
  private static int taken(Allowance allowance, long nowMicros) {
    int taken = 0;
    while (allowance.isOpen(nowMicros)) {
      allowance.take(1.0);
      taken++;
    }
    return taken;
  }

  @Test
  void isOpen_atOnce_aQuarterOfASecondsWorth() {
    assertThat(taken(new Allowance(100.0, SECOND), SECOND)).isEqualTo(25);
  }

  @Test
  void isOpen_slowAllowance_oneGoesAtOnce() {
    Allowance allowance = new Allowance(0.5, SECOND);
    assertThat(taken(allowance, SECOND)).isEqualTo(1);
    assertThat(allowance.isOpen(SECOND)).as("nothing is left").isFalse();
    assertThat(taken(allowance, 3 * SECOND)).as("two seconds later").isEqualTo(1);
  }

  @Test
  void isOpen_asTimeGoesBy_soMuchASecondAndNoMoreThanTheBurst() {
    Allowance allowance = new Allowance(100.0, 0L);
    assertThat(taken(allowance, 0L)).isEqualTo(25);
    assertThat(taken(allowance, SECOND / 10)).isEqualTo(10);
    assertThat(taken(allowance, SECOND / 10)).isZero();
    assertThat(taken(allowance, 100 * SECOND)).isEqualTo(25);
  }

  @Test
  void take_moreThanIsLeft_isOverdrawnOnceAndPaidOff() {
    Allowance allowance = new Allowance(100.0, 0L);
    allowance.take(125.0);
    assertThat(allowance.isOpen(SECOND)).isFalse();
    assertThat(allowance.isOpen(SECOND + 10_000)).isTrue();
  }
}
