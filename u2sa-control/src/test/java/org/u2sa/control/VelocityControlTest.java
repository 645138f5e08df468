package org.u2sa.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.testkit.ServiceKit;

/** Speeds and their signs from the way to go. */
class VelocityControlTest {
  private static final double NEAR = 1.0e-6;
  private static final double EAST = Math.PI / 2.0;

  private final ServiceKit kit = new ServiceKit().with("BLEND TIME", 0.0);

  @AfterEach
  void end() {
    kit.close();
  }

  private void start() {
    kit.start(VelocityControl::new);
  }

  private static StateInformation heading(double psi) {
    return new StateInformation().x(8.5).y(47.4).z(100.0).psi(psi);
  }

  /** A point from which the vehicle has turned on to another heading. */
  private void go(double psiThen, NavigationPoint point, double psiNow) {
    StateInformation then = heading(psiThen);
    then.timestamp(kit.clock().micros());
    kit.publish(Channels.STATE, then);
    point.timestamp(kit.clock().micros());
    kit.publish(Channels.NAVIGATION, point);
    kit.advance(0.1);
    kit.publish(Channels.STATE, heading(psiNow));
  }

  private void assertPercents(double forward, double left, double climb, double turn) {
    assertThat(kit.percent("FORWARD SPEED")).isCloseTo(forward, within(NEAR));
    assertThat(kit.percent("LEFT SPEED")).isCloseTo(left, within(NEAR));
    assertThat(kit.percent("CLIMB SPEED")).isCloseTo(climb, within(NEAR));
    assertThat(kit.percent("TURN RATE")).isCloseTo(turn, within(NEAR));
  }

  @Test
  void control_pointAhead_goesThereAtItsSpeed() {
    start();
    go(0.3, NavigationPoint.at(Point.of(50.0, 0.0, 0.0)).speed(4.0), 0.3);
    assertPercents(80.0, 0.0, 0.0, 0.0);
  }

  @Test
  void control_pointToTheLeftAndAbove_goesLeftUpAndTurnsLeft() {
    start();
    // BODY: z is down. 3 m to the left and 4 m up: 2 m/s of cruise speed in that direction.
    go(1.0, NavigationPoint.at(Point.of(0.0, 3.0, -4.0)), 1.0);
    assertPercents(0.0, 24.0, 80.0, 100.0);
  }

  @Test
  void control_turnedSinceThePointWasSeen_isLeftOfItNow() {
    start();
    go(0.0, NavigationPoint.at(Point.of(10.0, 0.0, 0.0)), EAST); // it lies in the north
    assertPercents(0.0, 40.0, 0.0, 100.0);
  }

  @Test
  void control_pointNear_slowsDownAndDoesNotTurn() {
    start();
    go(0.0, NavigationPoint.at(Point.of(0.0, -0.5, 0.0)), 0.0);
    assertPercents(0.0, -8.0, 0.0, 0.0); // 0.8/s of 0.5 m: 0.4 of 5 m/s
  }

  /** It has made half of the turn to the right already. */
  @Test
  void control_turnWantedAtThePoint_turnsByTheRest() {
    start();
    go(0.0, NavigationPoint.at(Point.ORIGIN).turn(0.2), 0.1);
    assertThat(kit.percent("TURN RATE")).isLessThan(-1.0);
    kit.advance(0.1);
    go(0.0, NavigationPoint.at(Point.ORIGIN).turn(0.2), 0.3);
    assertThat(kit.percent("TURN RATE")).isGreaterThan(1.0);
    kit.advance(0.1);
    go(0.0, NavigationPoint.at(Point.ORIGIN).turn(0.2), 0.2);
    assertPercents(0.0, 0.0, 0.0, 0.0);
  }

  @Test
  void control_notSideways_onlyForward() {
    kit.with("SIDEWAYS", false);
    start();
    go(0.0, NavigationPoint.at(Point.of(-30.0, 30.0, 0.0)), 0.0);
    assertPercents(0.0, 0.0, 0.0, 100.0);
  }

  @ParameterizedTest
  @CsvSource({"100, 40, 0, 100, 40, 0", "100, 0, 100, 40, 0, 100", "0, -30, -90, 0, -13.33, -100"})
  void control_fasterThanAnAxisCan_goesSlowerInTheSameDirection(
      double forwardM, double leftM, double upM, double forward, double left, double climb) {
    start();
    go(0.0, NavigationPoint.at(Point.of(forwardM, leftM, -upM)).speed(10.0), 0.0);
    assertThat(kit.percent("FORWARD SPEED")).isCloseTo(forward, within(0.1));
    assertThat(kit.percent("LEFT SPEED")).isCloseTo(left, within(0.1));
    assertThat(kit.percent("CLIMB SPEED")).isCloseTo(climb, within(0.1));
  }

  @Test
  void control_noPointOrAStaleOne_stands() {
    start();
    kit.publish(Channels.STATE, heading(0.0));
    assertPercents(0.0, 0.0, 0.0, 0.0);
    kit.advance(0.1);
    go(0.0, NavigationPoint.at(Point.of(50.0, 0.0, 0.0)), 0.0);
    assertPercents(40.0, 0.0, 0.0, 0.0);
    kit.advance(2.0);
    kit.publish(Channels.STATE, heading(0.0));
    assertPercents(0.0, 0.0, 0.0, 0.0);
  }
}
