package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.PayloadDrop;
import org.u2sa.messages.goal.Waypoint;

/** Drops of payloads from aircraft on a local plane. */
class PayloadDropGoalsTest extends FlownGoals {

  /** A drop of which the wind blows across, scored by an integration of its own. */
  @ParameterizedTest
  @CsvSource({"0, 0, 20, 40", "5, 0, 20, 40", "-4, 6, 20, 40", "3, -7, 8, 40", "2, 3, 20, 200"})
  void payloadDrop_aeroplaneInWind_fallsOntoThePosition(
      double windNorth, double windEast, double terminalMps, double fromM) {
    plane();
    wind = Point.of(windNorth, windEast, 0.0);
    ned = Point.of(-600.0, 150.0, -fromM); // from 200 m the first pass is too high
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(
        new PayloadDrop()
            .payload("BOTTLE")
            .height(40.0)
            .terminalSpeed(terminalMps)
            .z(0.0)
            .x(0.0)
            .y(0.0));
    for (int i = 0; i < 6000 && !released; i++) {
      step(20.0);
    }
    assertThat(released).isTrue();
    assertThat(-ned.z()).isBetween(35.9, 44.1);

    Point falls = ned.plus(velocity.times(0.1)); // RELEASE DELAY
    Point v = velocity;
    for (double h = 0.001; falls.z() < 0.0; ) {
      Point air = v.minus(wind);
      v =
          v.plus(
              Point.of(0.0, 0.0, 9.80665)
                  .minus(air.times(9.80665 * air.distance() / (terminalMps * terminalMps)))
                  .times(h));
      falls = falls.plus(v.times(h));
    }
    assertThat(Math.hypot(falls.x(), falls.y())).isLessThan(3.0);
    for (int i = 0; i < 100 && reports().isEmpty(); i++) {
      step(20.0);
    }
    assertThat(reports().get(0).completed()).isTrue();
  }

  @ParameterizedTest
  @ValueSource(doubles = {40.0, 2.0})
  void payloadDrop_multirotorAtAnotherHeight_isReleasedAtThatOfTheDrop(double fromM) {
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -fromM);
    pursue(new PayloadDrop().payload("BOTTLE").height(10.0).z(0.0).x(0.0).y(0.0));
    for (int i = 0; i < 1000 && !released; i++) {
      step(5.0);
    }
    assertThat(released).isTrue();
    assertThat(-ned.z()).isBetween(8.0, 12.0);
  }

  private PayloadDrop hoverAndDrop(String payload) {
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -10.0);
    PayloadDrop drop = new PayloadDrop().payload(payload).height(10.0);
    drop.z(0.0).x(0.0).y(0.0);
    pursue(drop);
    return drop;
  }

  private GoalInformation report() {
    int known = reports().size();
    for (int i = 0; i < 1000 && reports().size() == known; i++) {
      step(5.0);
    }
    return reports().get(known);
  }

  @Test
  void payloadDrop_unknownPayload_isGivenUpNamingTheKnownOnes() {
    hoverAndDrop("BOTTEL");

    assertThat(report().abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow())
        .contains("\"BOTTEL\" is not a mechanism that reports its release; there: BOTTLE");
    assertThat(released).isFalse();
  }

  @Test
  void payloadDrop_mechanismThatDoesNotMove_isGivenUp() {
    isStuck = true;
    hoverAndDrop("BOTTLE");

    assertThat(report().abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow()).contains("did not report a release");
    assertThat(released).isTrue();
  }

  @Test
  void payloadDrop_twoAtTheSamePlace_releasesTwice() {
    GoalInformation first = hoverAndDrop("BOTTLE");
    assertThat(report().completed()).isTrue();
    kit.publish(Channels.GOALS, new GoalList().goals(List.of(first.copy().uid("H"))));

    assertThat(report().completed()).isTrue();
    assertThat(drops).isEqualTo(2);
  }

  @Test
  void payloadDrop_aeroplaneThatStaysTooHigh_isGivenUpWithTheReason() {
    plane();
    ned = Point.of(-300.0, 0.0, -90.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(new PayloadDrop().payload("BOTTLE").height(40.0).z(0.0).x(0.0).y(0.0));
    for (int i = 0; i < 10_000 && reports().isEmpty(); i++) {
      step(20.0);
      ned = Point.of(ned.x(), ned.y(), -90.0);
    }
    assertThat(released).isFalse();
    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow()).contains("given up: was 50 m too high");
  }

  /** The z of a drop is that of the ground. */
  private double lowestAfterTheDrop(List<GoalInformation> next) {
    ned = Point.of(-300.0, 0.0, -40.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(new PayloadDrop().payload("BOTTLE").height(40.0).z(0.0).x(0.0).y(0.0));
    while (reports().isEmpty()) {
      step(20.0);
    }
    assertThat(reports().get(0).completed()).isTrue();
    kit.publish(Channels.GOALS, new GoalList().goals(next));
    double lowestM = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 1000; i++) {
      step(20.0);
      lowestM = Math.min(lowestM, -ned.z());
    }
    return lowestM;
  }

  @ParameterizedTest
  @ValueSource(strings = {"LINEAR", "IMMEDIATE"})
  void waypoint_afterADrop_isFlownFromTheAltitudeOfThePass(String profile) {
    kit.with("ALTITUDE PROFILE", profile);
    plane();
    Waypoint next = new Waypoint().horizontalThreshold(20.0);
    next.uid("H").referenceFrame(ReferenceFrame.LOCAL_NED).x(1500.0).y(300.0).z(-40.0);

    assertThat(lowestAfterTheDrop(List.of(next))).isGreaterThan(39.0);
  }

  @Test
  void payloadDrop_lastGoal_isFollowedByCirclesAtTheAltitudeOfThePass() {
    kit.with("AT END", "HOLD");
    plane();

    assertThat(lowestAfterTheDrop(List.of())).isGreaterThan(39.0);
    assertThat(Math.hypot(ned.x(), ned.y())).isLessThan(160.0);
  }

  @Test
  void payloadDrop_plannerSwappedAfterTheRelease_isCompletedAndNotFlownAgain() {
    kit.with("TURN ACCELERATION", 6.0).with("LOOK AHEAD", 50.0);
    PathPlanner first = kit.start(PathPlanner::new);
    ned = Point.of(-300.0, 0.0, -40.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(new PayloadDrop().payload("BOTTLE").height(40.0).z(0.0).x(0.0).y(0.0));
    for (int i = 0; i < 1000 && !released; i++) {
      step(20.0);
    }
    kit.swap(first, PathPlanner::new);
    for (int i = 0; i < 30; i++) {
      step(20.0);
    }
    assertThat(reports()).hasSize(1);
    assertThat(reports().get(0).completed()).isTrue();
  }

  @Test
  void payloadDrop_towerOnTheWay_isFlownAroundBeforeTheRelease() {
    tower("AIR", -500.0, 20.0);
    kit.with("PLANNED SPEED", 20.0).with("MIN SPEED", 15.0).with("MAX SPEED", 25.0);
    plane();
    ned = Point.of(-900.0, 0.0, -40.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(new PayloadDrop().payload("BOTTLE").height(40.0).z(0.0).x(0.0).y(0.0));
    for (int i = 0; i < 2000 && !released; i++) {
      step(20.0);
    }

    assertThat(nearestM).isGreaterThan(20.0);
    assertThat(released).isTrue();
  }
}
