package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;

/** Landings of aircraft on a local plane. */
class LandingGoalsTest extends FlownGoals {

  @Test
  void landing_aeroplane_descendsAlongItsLine() {
    plane();
    ned = Point.of(500.0, 800.0, -80.0);
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(0.0).x(0.0).y(0.0));
    double lowestM = 80.0;
    for (int i = 0; i < 4000 && ned.z() < -1.0; i++) {
      step(20.0);
      lowestM = Math.abs(ned.y()) > 20.0 ? Math.min(lowestM, -ned.z()) : lowestM;
    }

    assertThat(ned.z()).isGreaterThan(-1.0);
    assertThat(Math.abs(ned.y())).isLessThan(3.0);
    assertThat(ned.x()).isBetween(-60.0, 20.0);
    assertThat(lowestM).isGreaterThan(25.0); // not below the approach anywhere else
  }

  @Test
  void landing_directionChangedOnTheDescent_isFlownInTheNewOne() {
    plane();
    ned = Point.of(-800.0, 0.0, -40.0);
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(0.0).x(0.0).y(0.0));
    while (kit.nowS() < 200.0 && ned.z() < -25.0) {
      step(20.0);
    }
    assertThat(velocity.x()).isPositive();
    pursue(new Landing().approach(300.0).slope(0.1).psi(Math.PI).z(0.0).x(0.0).y(0.0));
    while (kit.nowS() < 400.0 && ned.z() < -15.0) {
      step(20.0);
    }
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(0.0).x(0.0).y(0.0)); // too low
    while (kit.nowS() < 400.0 && ned.z() < -1.0) {
      step(20.0);
    }

    assertThat(ned.z()).isGreaterThan(-1.0);
    assertThat(velocity.x()).isLessThan(-15.0);
    assertThat(Math.abs(ned.y())).isLessThan(3.0);
  }

  @ParameterizedTest
  @CsvSource({"-25, 200", "-12, 0"})
  void landing_positionMovesOnTheSlope_goesRoundForItOrStaysOnTheRunway(double down, double east) {
    plane();
    ned = Point.of(-800.0, 0.0, -40.0);
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(0.0).x(0.0).y(0.0));
    while (kit.nowS() < 200.0 && ned.z() < down) {
      step(20.0);
    }
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(0.0).x(100.0).y(200.0));
    double lowestMps = 0.0;
    while (kit.nowS() < 600.0 && ned.z() < -1.0) {
      step(20.0);
      lowestMps = ned.z() > -10.0 ? Math.max(lowestMps, Math.abs(velocity.y())) : lowestMps;
    }

    assertThat(ned.z()).isGreaterThan(-1.0);
    assertThat(ned.y()).isCloseTo(east, within(3.0));
    assertThat(lowestMps).as("turns low").isLessThan(1.0);
  }

  /** The ground is below the position: control flies on above it. */
  @Test
  void landing_aeroplaneFliesOnLowBeyondThePosition_isGivenUpAfterThreeApproaches() {
    plane();
    ned = Point.of(-800.0, 0.0, -40.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(0.0).x(0.0).y(0.0));
    double farthestM = 0.0;
    while (kit.nowS() < 900.0 && reports().isEmpty()) {
      boolean isLow = ned.z() > -10.0;
      step(20.0);
      assertThat(isLow && Math.abs(ned.y()) > 20.0).as("turns low").isFalse();
      ned = Point.of(ned.x(), ned.y(), Math.min(ned.z(), -5.0));
      farthestM = Math.max(farthestM, ned.x());
    }

    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow()).contains("flies on beyond the position");
    assertThat(kit.log("PathPlanner").stream().filter(line -> line.contains("trying again")))
        .hasSize(2);
    assertThat(farthestM).isBetween(200.0, 700.0);
  }

  @ParameterizedTest
  @CsvSource({"true, 600, true", "true, 1200, false", "false, 5, true", "false, 20, false"})
  void landing_standsAwayFromThePosition_isCompletedUpToABoundAndStays(
      boolean isAeroplane, double awayM, boolean isCompleted) {
    if (isAeroplane) {
      plane();
    } else {
      kit.with("AT END", "HOLD").start(PathPlanner::new);
    }
    ned = Point.of(0.0, 0.0, -1.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    step(0.5);
    for (int i = 0; i < 120 && reports().isEmpty(); i++) {
      ned = Point.of(awayM, 0.0, 0.0); // blown, or rolled
      velocity = Point.ORIGIN;
      step(0.0);
    }

    assertThat(reports().get(0).completed()).isEqualTo(isCompleted);
    assertThat(kit.log("PathPlanner"))
        .anyMatch(line -> line.contains("stands " + awayM + " m from its position"));
    kit.publish(Channels.GOALS, new GoalList());
    assertThat(step(0.0).z()).isNotNegative();
  }

  @ParameterizedTest
  @CsvSource({"12, 0", "0, -10"})
  void landing_positionMovesBelowADescent_isFlownToAfterRisingStraightUp(
      double north, double down) {
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -8.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    while (ned.z() < -1.0) {
      step(2.0);
    }
    pursue(new Landing().z(down).x(north).y(0.0));
    double lowestAwayM = Double.POSITIVE_INFINITY;
    double highestM = 0.0;
    while (kit.nowS() < 120.0 && reports().isEmpty()) {
      step(5.0);
      boolean isAway = ned.x() > 0.1 && ned.x() < 10.9;
      lowestAwayM = isAway ? Math.min(lowestAwayM, -ned.z()) : lowestAwayM;
      highestM = Math.max(highestM, -ned.z());
      if (ned.z() > down && highestM > -down) {
        ned = Point.of(ned.x(), ned.y(), down); // the ground
        velocity = Point.ORIGIN;
      }
    }

    assertThat(reports().get(0).completed()).isTrue();
    assertThat(lowestAwayM).isGreaterThan(2.9);
    assertThat(highestM).isBetween(3.0 - down, 4.1 - down);
    assertThat(ned.x()).isCloseTo(north, within(1.1));
  }

  @Test
  void landing_multirotor_descendsAboveItsPositionAndIsCompletedOnceItStands() {
    kit.start(PathPlanner::new);
    ned = Point.of(30.0, 0.0, -20.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    for (int i = 0; i < 2000 && reports().isEmpty(); i++) {
      step(5.0);
      assertThat(ned.z() > -19.0 && Math.hypot(ned.x(), ned.y()) > 1.1).isFalse();
      if (ned.z() > 0.0) {
        ned = Point.of(ned.x(), ned.y(), 0.0); // the ground
        velocity = Point.ORIGIN;
      }
    }

    assertThat(reports()).isNotEmpty();
    assertThat(reports().get(0).completed()).isTrue();
    assertThat(Math.hypot(ned.x(), ned.y())).isLessThan(1.1);
  }

  @Test
  void landing_tippedOver_isAbandonedWithTheReason() {
    kit.start(PathPlanner::new);
    roll = 2.9;
    pursue(new Landing().z(0.0).x(0.0).y(0.0));

    for (int i = 0; i < 80 && reports().isEmpty(); i++) {
      step(0.0);
      velocity = Point.ORIGIN; // lies on the ground
      ned = Point.ORIGIN;
    }

    assertThat(reports()).hasSize(1);
    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(kit.log("PathPlanner")).anyMatch(line -> line.contains("has tipped over"));
  }

  @Test
  void landing_multirotorWithHeading_turnsToItWhileItDescends() {
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -12.0);
    heading = 0.5;
    pursue(new Landing().psi(2.0).z(0.0).x(0.0).y(0.0));
    step(5.0);
    double turn = kit.latest(Channels.NAVIGATION).orElseThrow().turn().orElseThrow();
    assertThat(turn).isCloseTo(1.5, within(1e-9));
  }

  @Test
  void landing_groundFarAboveItsPosition_isGivenUpAndStaysOnTheGround() {
    kit.with("AT END", "HOLD").start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -12.0);
    pursue(new Landing().z(8.0).x(0.0).y(0.0));
    while (kit.nowS() < 90.0 && reports().isEmpty()) {
      step(5.0);
      if (ned.z() > 0.0) {
        ned = Point.ORIGIN; // the ground
        velocity = Point.ORIGIN;
      }
    }
    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow()).contains("stands 8.0 m above its position");
    kit.publish(Channels.GOALS, new GoalList());
    assertThat(step(5.0)).isEqualTo(Point.of(0.0, 0.0, 1.0));
  }

  @Test
  void landing_aeroplaneStandsOnHigherGround_isGivenUpWithTheHeight() {
    plane();
    ned = Point.of(-800.0, 0.0, -40.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(new Landing().approach(300.0).slope(0.1).psi(0.0).z(8.0).x(0.0).y(0.0));
    while (kit.nowS() < 200.0 && reports().isEmpty()) {
      step(ned.z() < 0.0 ? 20.0 : 0.0);
      if (ned.z() >= 0.0) {
        ned = Point.of(ned.x(), ned.y(), 0.0); // the ground
        velocity = Point.ORIGIN;
      }
    }
    assertThat(reports().get(0).abandoned()).isTrue();
    assertThat(reports().get(0).reason().orElseThrow()).contains("stands 8.0 m above its position");
  }

  /** The landing's position is above the ground: it would be climbed to. */
  @Test
  void landing_completedAndAtEndHold_staysOnTheGround() {
    kit.with("AT END", "HOLD").start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -20.0);
    pursue(new Landing().z(-1.0).x(0.0).y(0.0));
    while (kit.nowS() < 60.0 && reports().isEmpty()) {
      step(5.0);
      if (ned.z() > 0.0) {
        ned = Point.ORIGIN; // the ground
        velocity = Point.ORIGIN;
      }
    }
    assertThat(reports().get(0).completed()).isTrue();

    Point down = Point.of(0.0, 0.0, 1.0); // its control hovers where there is no point
    kit.publish(Channels.GOALS, new GoalList());
    assertThat(step(5.0)).isEqualTo(down);
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.HOLD));
    assertThat(step(5.0)).isEqualTo(down);
    kit.publish(Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.CONTINUE));
    pursue(new TakeOff().z(-20.0));
    assertThat(step(5.0).z()).isNegative();
  }

  @Test
  @Timeout(20)
  void landing_altitudeUncertain_isSlowFromHigherOn() {
    tooHighM = 5.0; // with a sigma of half of it
    kit.start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -20.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    while (ned.z() < 0.0) {
      step(5.0);
    }
    assertThat(velocity.z()).isLessThan(0.9);
  }

  @Test
  void landing_slowTouchDown_isNotCompletedInTheAir() {
    kit.with("TOUCH DOWN SINK", 0.2).start(PathPlanner::new);
    ned = Point.of(0.0, 0.0, -2.5);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    while (kit.nowS() < 60.0 && reports().isEmpty()) {
      step(0.2);
      if (ned.z() > 0.0) {
        ned = Point.ORIGIN; // the ground
        velocity = Point.ORIGIN;
      }
    }

    assertThat(reports().get(0).completed()).isTrue();
    assertThat(ned.z()).isGreaterThan(-0.1);
  }

  /**
   * As a receiver's altitude may be: the vehicle stands, although its altitude says that it flies.
   */
  @Test
  void landing_altitudeTooHigh_isCompletedOnTheGround() {
    tooHighM = 5.0;
    kit.start(PathPlanner::new);
    ned = Point.of(8.0, 0.0, -2.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    double highestM = 0.0; // when completed
    while (kit.nowS() < 60.0 && reports().isEmpty()) {
      step(0.2); // still by its speed all the time
      highestM = -ned.z();
      if (ned.z() > 0.0) {
        ned = Point.of(ned.x(), ned.y(), 0.0); // the ground
        velocity = Point.ORIGIN;
      }
    }

    assertThat(reports().get(0).completed()).isTrue();
    assertThat(highestM).isLessThan(0.1);
    assertThat(Math.hypot(ned.x(), ned.y())).isLessThan(1.1);
  }

  @Test
  void landing_multirotorLowerThanTheRoof_climbsAboveItFirst() {
    kit.start(PathPlanner::new);
    ned = Point.of(30.0, 0.0, -5.0);
    pursue(new Landing().x(0.0).y(0.0).z(-20.0)); // 20 m up
    double highestM = 0.0;
    for (int i = 0; i < 2000 && reports().isEmpty(); i++) {
      step(4.0);
      highestM = Math.max(highestM, -ned.z());
      boolean isOverTheRoof = Math.hypot(ned.x(), ned.y()) < 5.0;
      assertThat(isOverTheRoof && ned.z() > -19.0).as("below the roof at step %d", i).isFalse();
      if (isOverTheRoof && ned.z() > -20.0) {
        ned = Point.of(ned.x(), ned.y(), -20.0);
        velocity = Point.ORIGIN;
      }
    }

    assertThat(highestM).isBetween(22.0, 25.0);
    assertThat(reports().get(0).completed()).isTrue();
  }

  @Test
  void landing_towerBeforeTheMultirotor_isFlownAround() {
    tower("GRID", 60.0, 10.0);
    kit.start(PathPlanner::new);
    ned = Point.of(120.0, 0.0, -20.0);
    pursue(new Landing().z(0.0).x(0.0).y(0.0));
    for (int i = 0; i < 2000 && ned.z() < -1.0; i++) {
      step(5.0);
    }

    assertThat(nearestM).isGreaterThan(10.0);
    assertThat(ned.z()).isGreaterThan(-1.0);
  }
}
