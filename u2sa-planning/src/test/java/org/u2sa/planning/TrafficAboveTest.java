package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.shape.Sphere;

/** A multirotor over the place of its landing or take-off, and traffic above it. */
class TrafficAboveTest extends VerticalFlight {
  private static final double SEPARATION_M = 20.0;

  private void followUntil(double seconds, double passesAtS, double highM) {
    while (kit.nowS() < seconds && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      step(0.0, crossing(passesAtS, 8.0, highM, SEPARATION_M));
    }
  }

  private Sphere descending(double mps, double fromM, double toM) {
    double highM = Math.max(toM, fromM - mps * kit.nowS());
    Sphere other = crossing(kit.nowS(), 0.0, highM, SEPARATION_M);
    other.motion().velocity(Point.of(0.0, 0.0, highM > toM ? mps : 0.0));
    return other;
  }

  @ParameterizedTest
  @CsvSource({"0.0, 12.0", "0.5, 10.0", "4.0, 12.0", "9.0, 10.0", "24.0, 30.0"})
  void landing_trafficWillPassAbove_isCompletedWithoutAClimb(double fromM, double highM) {
    start(fromM);
    begin(new Landing().x(0.0).y(0.0).z(0.0));
    followUntil(60.0, 20.0, highM);

    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
    assertThat(highestM).isLessThan(fromM + 0.1);
  }

  /** The altitude of traffic is less accurate than that of the vehicle. */
  @Test
  void landing_trafficMeasuredBelowTheGroundAtTheTouchDown_isCompletedWithoutAClimb() {
    start(0.8);
    begin(new Landing().x(0.0).y(0.0).z(0.0));
    followUntil(60.0, 20.0, -3.0);

    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
    assertThat(highestM).isLessThan(0.9);
  }

  @Test
  void landing_trafficWillPassBelow_waitsOrClimbsUntilItHasPassed() {
    start(15.0);
    begin(new Landing().x(0.0).y(0.0).z(0.0));
    followUntil(19.5, 20.0, 6.0);

    assertThat(upM).isGreaterThan(14.0);
    followUntil(80.0, 20.0, 6.0);
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(doubles = {2.0, 12.0})
  void takeOff_trafficWillPassAboveTheGround_waitsThereUntilItHasPassed(double highM) {
    start(0.0);
    begin(new TakeOff().z(-30.0));
    followUntil(19.5, 20.0, highM);

    assertThat(highestM).isLessThan(0.1);
    followUntil(80.0, 20.0, highM);
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
  }

  /** Without TERRAIN; the ground is known from the take-off. */
  @Test
  void takeOff_trafficDescendsTowardsIt_descendsAgain() {
    start(0.0);
    begin(new TakeOff().z(-60.0));
    while (kit.nowS() < 5.0) {
      step(0.0);
    }
    double thenM = upM;
    while (kit.nowS() < 60.0) {
      step(0.0, descending(3.0, 75.0, 12.0));
    }
    assertThat(thenM).isGreaterThan(8.0);
    assertThat(highestM).isLessThan(thenM + 0.5);
    assertThat(upM).isBetween(0.5, thenM - 4.0);
  }

  /** Its velocity is only known when the vehicle is already within its separation. */
  @Test
  void takeOff_trafficWithinItsSeparationBeginsToDescend_descendsAgain() {
    kit.with("REACTION TIME", 1.0);
    start(0.0);
    begin(new TakeOff().z(-60.0));
    while (upM < 17.0) {
      step(0.0);
    }
    double beganS = kit.nowS();
    while (kit.nowS() < beganS + 10.0) {
      double highM = 40.0 - 1.5 * (kit.nowS() - beganS);
      Sphere other = crossing(kit.nowS(), 0.0, highM, SEPARATION_M + 1.0);
      other.motion().velocity(Point.of(0.0, 0.0, 1.5));
      step(0.0, other);
    }
    assertThat(upM).isLessThan(7.0);
  }
}
