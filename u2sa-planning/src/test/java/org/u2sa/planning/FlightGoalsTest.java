package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;

/** Take-offs and waypoints of aircraft on a local plane. */
class FlightGoalsTest extends FlownGoals {

  @Test
  void takeOff_aeroplane_leadsAlongItsHeadingUntilTheAltitude() {
    plane();
    heading = 0.5;
    pursue(new TakeOff().z(-60.0));

    Point first = step(20.0);
    assertThat(Math.atan2(first.y(), first.x())).isCloseTo(0.5, within(0.01));
    assertThat(first.z()).isCloseTo(-60.0, within(0.1));
    for (int i = 0; i < 600 && reports().isEmpty(); i++) {
      step(20.0);
    }

    assertThat(reports().get(0).completed()).isTrue();
    assertThat(ned.z()).isBetween(-61.0, -56.5);
    assertThat(Math.atan2(ned.y(), ned.x())).isCloseTo(0.5, within(0.02));
  }

  @Test
  void takeOff_multirotor_risesWhereItStands() {
    kit.start(PathPlanner::new);
    pursue(new TakeOff().z(-20.0));
    for (int i = 0; i < 300 && reports().isEmpty(); i++) {
      step(5.0);
    }

    assertThat(reports().get(0).completed()).isTrue();
    assertThat(Math.hypot(ned.x(), ned.y())).isLessThan(0.1);
    assertThat(ned.z()).as("near the altitude").isLessThan(-19.4);
  }

  @Test
  void takeOff_multirotorWithTakeOffAccuracy_isCompletedWithinIt() {
    kit.with("TAKE OFF ACCURACY", 2.0).start(PathPlanner::new);
    pursue(new TakeOff().z(-20.0));
    for (int i = 0; i < 300 && reports().isEmpty(); i++) {
      step(1.0);
    }

    assertThat(ned.z()).isBetween(-18.6, -17.9);
    assertThat(kit.log("PathPlanner"))
        .anyMatch(line -> line.matches(".*in the air, [12]\\.\\d m below its altitude.*"));
  }

  @Test
  void takeOff_aeroplaneThatNoLongerClimbs_isGivenUpAfterAMinute() {
    plane();
    pursue(new TakeOff().z(-60.0));
    double startedS = kit.nowS();
    while (reports().isEmpty() && kit.nowS() < startedS + 200.0) {
      step(20.0);
      ned = Point.of(ned.x(), ned.y(), Math.max(-25.0, ned.z()));
    }

    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(reports().get(0).reason()).contains("given up: no higher than 25 m for a minute");
    assertThat(kit.nowS() - startedS).isBetween(60.0, 75.0);
  }

  @Test
  @Timeout(20)
  void goals_positionFarBeyondTheEarth_areLookedAtWithoutDelay() {
    tower("HYBRID", -100.0, 5.0);
    plane();
    ned = Point.of(0.0, 0.0, -100.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(new Station().z(-100.0).x(9.0e8).y(0.0));
    step(20.0);
    pursue(new Landing().approach(9.0e8).z(0.0).x(500.0).y(0.0));
    step(20.0);
    assertThat(kit.published(Channels.NAVIGATION)).hasSize(2);
  }

  /** As the estimate does while a receiver's first fixes are averaged. */
  @Test
  void takeOff_multirotorWhosePositionMovesNearTheGround_isLedStraightUp() {
    kit.start(PathPlanner::new);
    pursue(new TakeOff().z(-20.0));
    step(5.0);
    ned = Point.of(3.0, -2.0, ned.z());
    while (ned.z() > -1.7) {
      Point to = step(1.0);
      assertThat(Math.hypot(to.x(), to.y())).isLessThan(1e-9);
    }
    for (int i = 0; i < 300 && reports().isEmpty(); i++) {
      step(5.0);
    }
    assertThat(reports().get(0).completed()).isTrue();
    assertThat(Math.hypot(ned.x(), ned.y())).isLessThan(0.1);
  }

  @Test
  void waypoint_insteadOfADescent_isFlownToAfterRisingStraightUp() {
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -1.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    step(0.5);
    pursue(new Waypoint().x(30.0).y(0.0));
    while (ned.z() > -2.9) {
      Point to = step(1.0);
      assertThat(Math.hypot(to.x(), to.y())).isLessThan(1e-9);
    }
  }

  @Test
  void waypoint_afterALanding_isFlownToAfterRisingStraightUp() {
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -5.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    while (kit.nowS() < 60.0 && reports().isEmpty()) {
      step(5.0);
      if (ned.z() > 0.0) {
        ned = Point.of(ned.x(), ned.y(), 0.0); // the ground
        velocity = Point.ORIGIN;
      }
    }
    Point from = ned;
    pursue(new Waypoint().z(-12.0).x(30.0).y(0.0));
    double lowestAwayM = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 400; i++) {
      step(5.0);
      if (Math.hypot(ned.x() - from.x(), ned.y() - from.y()) > 0.3) {
        lowestAwayM = Math.min(lowestAwayM, -ned.z());
      }
    }
    assertThat(lowestAwayM).isBetween(1.9, 12.1);
    assertThat(ned.x()).isCloseTo(30.0, within(1.0));
  }

  /** A car with Ackermann steering has TURN ACCELERATION too, and must not be led into the air. */
  @ParameterizedTest
  @CsvSource({"0, 0", "100, -40"})
  void waypoint_withoutAltitude_isRaisedForAVehicleThatCannotStopOnly(
      double loiterRadiusM, double downM) {
    kit.with("TURN ACCELERATION", 1.0).with("LOITER RADIUS", loiterRadiusM);
    kit.start(PathPlanner::new);
    pursue(new Waypoint().x(30.0).y(0.0));

    assertThat(step(0.0).z()).isCloseTo(downM, within(0.1));
  }
}
