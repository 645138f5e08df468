package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

final class MeasuringTimeTest {
  private static final long START = 1_000_000_000L;
  private static final long FRAME = 50_000;

  private final MeasuringTime time = new MeasuringTime();
  private long arrival = START;
  private double elapsedS = 7.0;

  @Test
  void take_linesDelayedByTheNetwork_stepsAreThoseOfTheFlight() {
    line(FRAME, FRAME);
    long before = time.micros();
    line(FRAME, FRAME + 30_000);
    assertThat(time.micros() - before).isEqualTo(FRAME);
  }

  @Test
  void take_firstLineWasLate_timeIsNeverAfterTheArrival() {
    line(FRAME, FRAME + 40_000);
    line(FRAME, FRAME - 40_000); // that one was not
    assertThat(time.micros()).isLessThanOrEqualTo(arrival);
    long before = time.micros();
    line(FRAME, FRAME);
    assertThat(time.micros() - before).isEqualTo(FRAME);
  }

  @Test
  void take_linesPiledUpInAStall_areAsOldAsTheyAre() {
    line(FRAME, FRAME);
    long before = time.micros();
    line(FRAME, 5_000_000);
    assertThat(time.micros()).isEqualTo(before + FRAME);
    for (int i = 0; i < 98; i++) {
      line(FRAME, 100);
    }
    assertThat(arrival - time.micros()).isBetween(0L, 100_000L);
    assertThat(time.micros() - before).isEqualTo(99 * FRAME);
  }

  @Test
  void take_flightGearFrozeForFiveSeconds_isYoungAgainSoon() {
    line(FRAME, FRAME);
    line(FRAME, 5_000_000);
    assertThat(arrival - time.micros()).isGreaterThan(4_000_000);
    for (int i = 0; i < 11; i++) {
      line(FRAME, FRAME);
    }
    assertThat(arrival - time.micros()).isBetween(0L, FRAME);
  }

  @Test
  void take_flightGearLostAFewFrames_isNotSaidToBeOldForEver() {
    line(FRAME, FRAME);
    line(FRAME, 4 * FRAME);
    assertThat(arrival - time.micros()).isEqualTo(3 * FRAME);
    for (int i = 0; i < 30; i++) {
      line(FRAME, FRAME);
    }
    assertThat(arrival - time.micros()).isZero();
  }

  @Test
  void take_networkJitterBelowTheThreshold_neverMovesTheAnchor() {
    line(FRAME, FRAME);
    long before = time.micros();
    for (int i = 1; i <= 100; i++) {
      line(FRAME, i % 2 == 0 ? FRAME + 20_000 : FRAME - 20_000 + (i == 1 ? 40_000 : 0));
    }
    assertThat(time.micros() - before).isEqualTo(100 * FRAME);
  }

  @Test
  void take_paused_isNoNewMeasurementAndTheAnchorMovesAlong() {
    line(FRAME, FRAME);
    for (int i = 0; i < 100; i++) {
      assertThat(line(0, FRAME)).isFalse();
    }
    assertThat(line(FRAME, FRAME)).isTrue();
    assertThat(arrival - time.micros()).isZero();
  }

  @Test
  void take_fourTimesRealSpeed_followsTheRunsClock() {
    for (int i = 0; i < 100; i++) {
      line(4 * FRAME, FRAME);
      assertThat(arrival - time.micros()).isZero();
    }
  }

  @Test
  void take_halfRealSpeed_isNeverOlderThanHalfASecond() {
    for (int i = 0; i < 200; i++) {
      long before = time.micros();
      line(FRAME / 2, FRAME);
      assertThat(time.micros()).isGreaterThan(before);
      assertThat(arrival - time.micros()).isBetween(0L, 500_000L);
    }
  }

  @Test
  void take_flightGearStartedAnew_goesOnWithLaterTimes() {
    line(FRAME, FRAME);
    long before = time.micros();
    elapsedS = 0.1;
    assertThat(line(0, FRAME)).isTrue();
    assertThat(time.micros()).isGreaterThan(before).isEqualTo(arrival);
  }

  private boolean line(long flightMicros, long arrivalMicros) {
    elapsedS += flightMicros / 1e6;
    arrival += arrivalMicros;
    return time.take(elapsedS, arrival);
  }
}
