package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Sphere;

/** Climbs and descents of a multirotor that goes to its navigation points, in place. */
class VerticalWayTest extends VerticalFlight {
  static Stream<Arguments> upwards() {
    return Stream.of(
        Arguments.of("in the way of the climb", new TakeOff().z(-25.0)),
        Arguments.of(
            "enclosed by obstacles", waypoint("1", 0.3, 0.0).z(-25.0).verticalThreshold(1.0)),
        Arguments.of("in the way of the climb", new Waypoint().z(-25.0).verticalThreshold(1.0)));
  }

  @ParameterizedTest
  @MethodSource("upwards")
  void climb_belowABridge_endsAtItsClearanceAndIsGivenUp(String reason, Waypoint goal) {
    start(0.0);
    GoalInformation report = pursue(goal, 90.0, slab(12.0, 14.0));

    assertThat(highestM).isBetween(6.0, 12.0 - CLEARANCE_M + 0.01);
    assertThat(report.abandoned()).isTrue();
    assertThat(report.reason().orElseThrow()).endsWith(reason);
    assertThat(logged("an obstacle is in the way of the climb")).isPositive();
  }

  static Stream<Arguments> downwards() {
    return Stream.of(
        Arguments.of("in the way of the descent", new Landing().x(0.0).y(0.0).z(0.0)),
        Arguments.of(
            "enclosed by obstacles", waypoint("1", 0.3, 0.0).z(-5.0).verticalThreshold(1.0)),
        Arguments.of("in the way of the descent", new Waypoint().z(-5.0).verticalThreshold(1.0)));
  }

  @ParameterizedTest
  @MethodSource("downwards")
  void descent_aboveABridge_endsAtItsClearanceAndIsGivenUp(String reason, Waypoint goal) {
    start(35.0);
    GoalInformation report = pursue(goal, 90.0, slab(15.0, 18.0));

    assertThat(lowestM).isBetween(18.0 + CLEARANCE_M - 0.01, 24.0);
    assertThat(report.abandoned()).isTrue();
    assertThat(report.reason().orElseThrow()).endsWith(reason);
    assertThat(logged("an obstacle is in the way of the descent")).isPositive();
  }

  /** A waypoint without vertical threshold is reached below the bridge, and held above it. */
  @Test
  void atEndHold_belowABridge_endsAtItsClearance() {
    kit.with("AT END", "HOLD");
    start(2.0);
    assertThat(
            pursue(new Station().duration(1.0).x(0.0).y(0.0).z(-25.0), 60.0, slab(12.0, 14.0))
                .completed())
        .isTrue();
    goals();
    for (int i = 0; i < 200; i++) {
      step(0.0, slab(12.0, 14.0));
    }
    assertThat(highestM).isLessThan(12.0 - CLEARANCE_M + 0.01);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1.6, 8.0})
  void landing_carOrPoleOnItsPlace_isNotTouchedAndGivenUpWithTheReason(double heightM) {
    start(25.0);
    GoalInformation report = pursue(new Landing().x(0.0).y(0.0).z(0.0), 90.0, slab(0.0, heightM));

    assertThat(lowestM).isGreaterThan(heightM + CLEARANCE_M - 0.01);
    assertThat(report.abandoned()).isTrue();
    assertThat(report.reason().orElseThrow()).contains("in the way of the descent");
  }

  @Test
  void landing_somethingOfUnknownHeightAppearsOnItsPlace_isNotDescendedTo() {
    start(15.0);
    begin(new Landing().x(0.0).y(0.0).z(0.0));
    for (int i = 0; i < 20; i++) {
      step(0.0);
    }
    double thenM = upM;
    Circle seen = new Circle().radius(0.3);
    seen.uid("person").objectType("person").referenceFrame(ReferenceFrame.LOCAL_NED).x(0).y(0);
    while (kit.nowS() < 60.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      step(0.0, seen);
    }
    assertThat(thenM).isLessThan(14.0);
    assertThat(lowestM).isGreaterThan(thenM - 0.5);
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().abandoned()).isTrue();
  }

  /** Its speed is that of routes; lines leave it to control. */
  @Test
  void landing_wayThereIsFreeAgain_keepsToItsRoute() {
    start(15.0);
    begin(new Landing().x(40.0).y(0.0).z(0.0));
    Circle pole = new Circle().radius(0.3);
    pole.uid("pole").referenceFrame(ReferenceFrame.LOCAL_NED).x(25.0).y(0.0);
    step(0.0, pole);
    assertThat(isOnRoute()).isTrue();
    for (int i = 0; i < 10; i++) {
      step(0.0);
    }
    assertThat(isOnRoute()).isTrue();
  }

  private boolean isOnRoute() {
    return kit.latest(Channels.NAVIGATION).orElseThrow().speed().isPresent();
  }

  @Test
  void landing_onAMappedRoof_reachesIt() {
    start(25.0);
    begin(new Landing().x(0.0).y(0.0).z(-12.0));
    while (kit.nowS() < 60.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      step(12.3, slab(0.0, 12.3));
    }
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
    assertThat(upM).isCloseTo(12.3, within(0.01));
  }

  private double nearestTo(Waypoint goal, double fromM, double mps, double highM, double atS) {
    start(fromM);
    begin(goal);
    double nearestM = Double.POSITIVE_INFINITY;
    while (kit.nowS() < 90.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      Sphere traffic = crossing(atS, mps, highM, 5.0);
      nearestM = Math.min(nearestM, Math.hypot(traffic.y(), upM - highM));
      step(0.0, traffic);
    }
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
    return nearestM;
  }

  static Stream<Waypoint> waysUp() {
    return Stream.of(new TakeOff().z(-60.0), new Waypoint().z(-60.0).verticalThreshold(1.0));
  }

  @ParameterizedTest
  @MethodSource("waysUp")
  void climb_aircraftCrossesAbove_waitsUntilItHasPassed(Waypoint goal) {
    assertThat(nearestTo(goal, 0.0, 1.5, 30.0, 14.0)).isGreaterThan(8.5);
    assertThat(logged("traffic is in the way of the climb: waiting")).isEqualTo(1);
  }

  /** Another multirotor comes down to 25 m, and then flies off. */
  @Test
  void takeOff_somethingDescendsAbove_waitsUntilItIsGone() {
    start(0.0);
    begin(new TakeOff().z(-60.0));
    double nearestM = Double.POSITIVE_INFINITY;
    while (kit.nowS() < 90.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      double highM = 60.0 - kit.nowS();
      if (highM < 25.0) {
        step(0.0);
        continue;
      }
      Sphere other = crossing(kit.nowS(), 0.0, highM, 5.0);
      other.motion().velocity(Point.of(0.0, 0.0, 1.0));
      nearestM = Math.min(nearestM, highM - upM);
      step(0.0, other);
    }
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
    assertThat(nearestM).isGreaterThan(8.5);
    assertThat(logged("traffic is in the way of the climb: waiting")).isEqualTo(1);
  }

  @Test
  void landing_someoneWalksOverItsPlace_waitsUntilHeHasPassed() {
    Landing landing = new Landing();
    landing.x(0.0).y(0.0).z(0.0);
    assertThat(nearestTo(landing, 25.0, 1.5, 1.0, 15.0)).isGreaterThan(8.5);
    assertThat(logged("traffic is in the way of the descent: waiting")).isEqualTo(1);
  }
}
