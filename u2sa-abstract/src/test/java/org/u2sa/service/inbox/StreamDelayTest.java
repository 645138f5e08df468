package org.u2sa.service.inbox;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.safety.OperatorHeartbeat;

class StreamDelayTest {
  private static final double START_S = 1.7e9;

  private StreamDelay delay = new StreamDelay();
  private double aheadS; // of the sender's clock

  /** A message that was sent and arrives at these times after the start [s]. */
  private boolean isLate(double sentS, double arrivesS) {
    OperatorHeartbeat heartbeat = new OperatorHeartbeat().operator("Ann");
    heartbeat.timestamp(Clock.micros(START_S + sentS + aheadS));
    return delay.isLate(heartbeat, Clock.micros(START_S + arrivesS), 5.0);
  }

  private void steady(double fromS, double toS) {
    for (double t = fromS; t <= toS; t += 1.0) {
      assertThat(isLate(t, t + 0.1)).as("%.0f s", t).isFalse();
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0, -3_600.0, 1e6})
  void isLate_senderWithAnyClock_onlyWhatWasHeldUp(double clockAheadS) {
    aheadS = clockAheadS;
    steady(0.0, 20.0);

    assertThat(isLate(20.0, 29.0)).as("the last once more").isTrue();
    assertThat(isLate(21.0, 40.0)).as("kept by a broker").isTrue();
    assertThat(isLate(37.0, 40.0)).as("3 s late").isFalse();
    steady(41.0, 60.0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {3.0, 10.0})
  void isLate_lastOnesAgainForLong_stayLate(double steadyAfterS) {
    delay = new StreamDelay(steadyAfterS);
    steady(0.0, 10.0);
    for (double t = 16.0; t < 60.0; t += 0.5) {
      assertThat(isLate(10.0, t)).as("%.1f s", t).isTrue();
    }
  }

  @Test
  void isLate_clockSetBackOrComputerSlept_isAcceptedAfterTenSeconds() {
    steady(0.0, 10.0);
    aheadS = -600.0;
    int late = 0;
    while (isLate(20.0 + late, 20.1 + late)) {
      late++;
    }

    assertThat(late).isBetween(9, 11);
    steady(40.0, 50.0);
  }

  @Test
  void isLate_heartbeatsAfterAClockWasSetBack_areAcceptedAfterThreeSeconds() {
    delay = new StreamDelay(3.0);
    steady(0.0, 10.0);
    aheadS = -6.0;
    for (int i = 0; i < 3; i++) {
      assertThat(isLate(11.0 + i, 11.1 + i)).isTrue();
    }
    assertThat(isLate(14.0, 14.1)).isFalse();
    steady(15.0, 25.0);
  }

  /** Two programs of one operator; the one whose clock is right ends. */
  @Test
  void isLate_anotherProgramWithAClockThatIsBehind_countsWhenTheFirstEnds() {
    delay = new StreamDelay(1.9);
    int late = 0;
    for (double t = 0.0; t < 10.0; t += 1.0) {
      aheadS = 0.0;
      assertThat(isLate(t, t + 0.1)).isFalse();
      aheadS = -60.0;
      late += isLate(t + 0.5, t + 0.6) ? 1 : 0;
    }
    assertThat(late).isEqualTo(2);

    assertThat(isLate(10.5, 10.6)).isFalse();
    steady(11.5, 20.0);
  }

  @Test
  void isLate_burstsOfEqualAge_stayLate() {
    delay = new StreamDelay(1.9);
    for (double t = 0.0; t < 60.0; t += 10.0) {
      steady(t, t + 3.0);
      assertThat(isLate(t - 4.0, t + 4.0)).isTrue();
      assertThat(isLate(t - 4.0, t + 4.1)).isTrue();
    }
  }

  /** Copies of sticks by another way must not steer. */
  @Test
  void isLate_steadyLateMessagesOfADriver_areNotAcceptedBesideThoseInTime() {
    for (double t = 0.0; t < 60.0; t += 1.0) {
      assertThat(isLate(t, t + 0.1)).isFalse();
      assertThat(isLate(t - 8.0, t + 0.6)).isTrue();
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {100.0, 10.0, 2.0})
  void isLate_backlogThatDrains_staysLate(double timesFaster) {
    delay = new StreamDelay(3.0);
    steady(0.0, 10.0);
    for (double sent = 11.0; sent < 50.0; sent += 1.0) {
      double arrives = 60.0 + (sent - 11.0) / timesFaster;
      assertThat(isLate(sent, arrives)).as("%.0f s", sent).isEqualTo(arrives - sent > 5.1);
    }
  }

  @Test
  void isLate_clocksThatDriftApart_isNeverLate() {
    for (double t = 0.0; t < 500_000.0; t += 10.0) {
      assertThat(isLate(t * (1.0 - 5e-5), t)).isFalse();
    }
  }

  @Test
  void isLate_withoutTimestampOrLimit_isFalse() {
    steady(0.0, 5.0);
    OperatorHeartbeat untimed = new OperatorHeartbeat().operator("Ann");

    assertThat(delay.isLate(untimed, Clock.micros(START_S + 100.0), 5.0)).isFalse();
    untimed.timestamp(Clock.micros(START_S));
    assertThat(delay.isLate(untimed, Clock.micros(START_S + 100.0), 0.0)).isFalse();
  }
}
