package org.u2sa.control.ground;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

/** A loaded differential vehicle that learns to push while it turns, and then reverses. */
class ReverseTest {
  private static final double STEP_S = 0.05;

  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  private void go(Point to, boolean backwards, double forwardMps, double seconds) {
    for (int i = 0; i < seconds / STEP_S; i++) {
      kit.publish(
          Channels.STATE,
          new StateInformation()
              .referenceFrame(ReferenceFrame.LOCAL_NED)
              .x(0.0)
              .y(0.0)
              .xDot(forwardMps)
              .yDot(0.0)
              .psi(0.0)
              .psiDot(0.0));
      kit.publish(Channels.NAVIGATION, NavigationPoint.at(to).backwards(backwards));
      kit.advance(STEP_S);
    }
  }

  @Test
  void control_measuredYawRateStaysAtZero_turnsWithTheLimitedPower() {
    kit.with("SPOT TURN BOOST", 2.0);
    kit.start(DifferentialPursuitControl::new);
    go(Point.of(0.0, 5.0, 0.0), false, 0.0, 2.5);

    // 0.22 m * 70 deg/s = 0.27 m/s: 8 % + 92 % * 0.27 / 2, twice
    assertThat(kit.percent("RIGHT MOTOR")).isCloseTo(40.7, within(0.1));

    go(Point.of(0.0, 5.0, 0.0), false, 0.0, 3.0);
    assertThat(kit.percent("RIGHT MOTOR")).as("rests").isZero();
  }

  @Test
  void control_reversesAfterATurnUnderLoad_goesStraight() {
    kit.start(DifferentialPursuitControl::new);
    go(Point.of(0.0, 5.0, 0.0), false, 0.0, 2.5);
    assertThat(kit.percent("RIGHT MOTOR")).as("pushes").isGreaterThan(60.0);
    go(Point.ORIGIN, false, 0.0, 3.0);

    go(Point.of(-8.0, 0.02, 0.0), true, -0.6, 1.0);

    assertThat(kit.percent("LEFT MOTOR")).isBetween(-90.0, -20.0);
    assertThat(kit.percent("RIGHT MOTOR") - kit.percent("LEFT MOTOR")).isBetween(-10.0, 10.0);
  }
}
