package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;

/** A multirotor whose landing is interrupted at its very end. */
class TouchDownTest extends VerticalFlight {
  private static Landing landing() {
    Landing landing = new Landing();
    landing.horizontalThreshold(2.0).uid("1").referenceFrame(ReferenceFrame.LOCAL_NED);
    landing.x(0.0).y(0.0).z(0.0);
    return landing;
  }

  /** Descends to a height, then stands on the ground for a while. */
  private void descendTo(double heightM, double groundM, double standsS) {
    kit.with("AT END", "HOLD");
    start(20.0);
    begin(landing());
    while (kit.nowS() < 60.0 && upM > heightM) {
      step(groundM);
    }
    double untilS = kit.nowS() + standsS;
    while (kit.nowS() < untilS) {
      step(groundM);
    }
    assertThat(kit.latest(Channels.GOAL_REPORTS)).isEmpty();
  }

  private void goOn(double seconds, double groundM) {
    for (int i = 0; i < seconds / STEP_S; i++) {
      step(groundM);
    }
  }

  @ParameterizedTest
  @CsvSource({"0.5, 0.0, 0.0", "0.0, 0.0, 1.0", "2.0, 2.0, 1.6"})
  void hold_touchesDown_staysOnTheGround(double heightM, double groundM, double standsS) {
    descendTo(heightM, groundM, standsS);
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.HOLD));
    goOn(20.0, groundM);

    assertThat(upM).isCloseTo(groundM, within(1e-9));
    assertThat(point().z()).isEqualTo(1.0); // down
  }

  @Test
  void pause_touchesDown_landingIsCompletedAfterwards() {
    descendTo(0.5, 0.0, 0.0);
    kit.publish(
        Channels.GOALS, new GoalList().goals(List.of(landing())).upcoming(List.of()).paused(true));
    goOn(10.0, 0.0);
    highestM = 0.0;
    begin(landing());
    goOn(5.0, 0.0);

    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
    assertThat(highestM).isLessThan(0.1);
  }

  @Test
  void hold_higherInADescent_keepsTheHeight() {
    descendTo(1.5, 0.0, 0.0);
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.HOLD));
    goOn(20.0, 0.0);

    assertThat(upM).isGreaterThan(1.0);
  }
}
