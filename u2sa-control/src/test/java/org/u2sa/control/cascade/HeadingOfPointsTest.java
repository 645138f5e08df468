package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

/** A boat whose actuators push along, across and about its own axes, heading north at rest. */
class HeadingOfPointsTest {
  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  private void start(boolean hasSway) {
    kit.with("SURGE WEIGHT", 1.0).with("SURGE MASS", 100.0);
    kit.with("SWAY WEIGHT", hasSway ? 1.0 : 0.0).with("SWAY MASS", 100.0);
    kit.with("YAW WEIGHT", 1.0).with("YAW INERTIA", 100.0);
    kit.with("FACES THE WAY", true).with("WEATHER VANES", true);
    kit.start(AllocatingControl::new);
    announce("AHEAD", Point.of(1000.0, 0.0, 0.0), Point.ORIGIN);
    announce("ASIDE", Point.of(0.0, 1000.0, 0.0), Point.ORIGIN);
    announce("TURN", Point.ORIGIN, Point.of(0.0, 0.0, 1000.0));
  }

  private void announce(String name, Point force, Point moment) {
    kit.publish(
        Channels.ACTUATORS,
        new ActuatorAnnouncement()
            .actuatorName(name)
            .minimum(-100.0)
            .maximum(100.0)
            .force(force)
            .moment(moment));
  }

  private void lie(double eastMps, NavigationPoint point) {
    kit.advance(0.1);
    StateInformation state =
        new StateInformation()
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(0.0)
            .y(0.0)
            .xDot(0.0)
            .yDot(eastMps)
            .psi(0.0)
            .psiDot(0.0);
    state.timestamp(kit.clock().micros());
    point.timestamp(kit.clock().micros());
    kit.publish(Channels.STATE, state);
    kit.publish(Channels.NAVIGATION, point);
    kit.advance(0.1);
    StateInformation later = state.copy();
    later.timestamp(kit.clock().micros());
    kit.publish(Channels.STATE, later);
  }

  @Test
  void control_turnOfThePoint_turnsThereInsteadOfFacingTheWay() {
    start(true);
    lie(0.0, NavigationPoint.at(Point.of(5.0, 5.0, 0.0)).turn(0.8)); // to the left of the bow

    assertThat(kit.percent("TURN")).isPositive(); // to the right
    assertThat(kit.percent("ASIDE")).isNegative();
    assertThat(kit.percent("AHEAD")).isPositive();
  }

  @Test
  void control_pointWithoutTurn_facesTheWay() {
    start(true);
    lie(0.0, NavigationPoint.at(Point.of(5.0, 5.0, 0.0)));

    assertThat(kit.percent("TURN")).isNegative();
  }

  @Test
  void control_backwards_reversesToAPointAstern() {
    start(false);
    lie(0.0, NavigationPoint.at(Point.of(-5.0, 1.0, 0.0)).backwards(true));

    assertThat(kit.percent("AHEAD")).isNegative();
    assertThat(kit.percent("TURN")).isPositive(); // stern to the left
  }

  @Test
  void control_astern_withoutBackwards_turnsFirst() {
    start(false);
    lie(0.0, NavigationPoint.at(Point.of(-5.0, 1.0, 0.0)));

    assertThat(kit.percent("AHEAD")).isZero();
    assertThat(kit.percent("TURN")).isNegative();
  }

  @Test
  void control_pushedToTheRightOnStation_turnsItsBowIntoThePush() {
    start(true);
    for (int i = 0; i < 20; i++) {
      lie(0.2, NavigationPoint.at(Point.of(0.0, 0.0, 0.0)));
    }

    assertThat(kit.percent("ASIDE")).isNegative();
    assertThat(kit.percent("TURN")).isNegative(); // to the left, whence it is pushed
  }
}
