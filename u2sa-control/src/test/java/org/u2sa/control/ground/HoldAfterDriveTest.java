package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.goal.GoalList;

class HoldAfterDriveTest {
  private final HoldAfterDrive hold = new HoldAfterDrive();

  private static long micros(double seconds) {
    return Clock.micros(seconds);
  }

  /** The planner may not have heard of the pause, or of the drive's end, yet. */
  @Test
  void holds_restartedInADriveAndPaused_endsASecondAfterThePauseIsKnown() {
    hold.await(true, micros(10.0));
    assertThat(hold.holds(micros(20.0))).isTrue();

    hold.see(new GoalList().paused(true), micros(20.0));
    assertThat(hold.holds(micros(20.9))).isTrue();
    assertThat(hold.holds(micros(21.1))).isFalse();
  }

  @Test
  void holds_pausedBeforeTheDriveEnded_neverBegins() {
    hold.begin();
    hold.see(new GoalList().paused(true), micros(1.0));
    assertThat(hold.holds(micros(2.0))).isFalse();
  }
}
