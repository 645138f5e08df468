package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.TakeOff;
import org.u2sa.messages.goal.Waypoint;

/** Landings and take-offs whose planner is replaced or restarted meanwhile. */
class InterruptedLandingTest extends FlownGoals {
  private PathPlanner planner;

  private void start(boolean isAeroplane) {
    if (isAeroplane) {
      kit.with("TURN ACCELERATION", 6.0).with("LOOK AHEAD", 50.0).with("LOITER RADIUS", 100.0);
    }
    planner = kit.start(PathPlanner::new);
  }

  private void interrupt(boolean isSwap) {
    if (isSwap) {
      planner = kit.swap(planner, PathPlanner::new);
    } else {
      kit.advance(2.0); // hung for a while
      ned = ned.plus(velocity.times(2.0));
      planner = kit.restart(planner, PathPlanner::new);
    }
  }

  private static Waypoint landing() {
    return new Landing().approach(300.0).slope(0.1).z(0.0).x(0.0).y(0.0);
  }

  /** Flies until it is at an altitude; the greatest angle off the runway meanwhile [rad]. */
  private double flyTo(double down) {
    double offRad = 0.0;
    for (int i = 0; i < 4000 && ned.z() < down; i++) {
      step(20.0);
      offRad = Math.max(offRad, Math.abs(Math.atan2(velocity.y(), velocity.x())));
    }
    return offRad;
  }

  @ParameterizedTest
  @CsvSource({"true, -25", "true, -12", "true, -3", "false, -25", "false, -12", "false, -9.5"})
  void landing_plannerReplacedOnTheDescent_landsOnItsLine(boolean isSwap, double down) {
    start(true);
    ned = Point.of(-900.0, 0.0, -30.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(landing().psi(0.0));
    flyTo(down);
    interrupt(isSwap);

    assertThat(flyTo(-1.0)).isLessThan(0.02);
    assertThat(ned.z()).isGreaterThan(-1.0);
    assertThat(ned.x()).isBetween(-60.0, 20.0);
    assertThat(ned.y()).isCloseTo(0.0, within(1.0));
  }

  /** The wind would now give another direction. */
  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void landing_windHasTurnedAndPlannerReplaced_keepsItsDirection(boolean isSwap) {
    start(true);
    wind = Point.of(-4.0, 0.0, 0.0);
    ned = Point.of(-900.0, 0.0, -30.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(landing());
    flyTo(-12.0);
    wind = Point.of(0.0, 4.0, 0.0);
    interrupt(isSwap);

    assertThat(flyTo(-1.0)).isLessThan(0.02);
    assertThat(ned.x()).isBetween(-60.0, 20.0);
  }

  /** As after a restart that took long, or by hand meanwhile. */
  @Test
  void landing_restartedAwayFromItsLine_approachesAgain() {
    start(true);
    ned = Point.of(-900.0, 0.0, -30.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(landing().psi(0.0));
    flyTo(-12.0);
    ned = Point.of(400.0, 500.0, -40.0);
    interrupt(false);
    double lowestAsideM = 40.0;
    while (kit.nowS() < 400.0 && ned.z() < -1.0) {
      step(20.0);
      lowestAsideM = Math.abs(ned.y()) > 20.0 ? Math.min(lowestAsideM, -ned.z()) : lowestAsideM;
    }

    assertThat(ned.z()).isGreaterThan(-1.0);
    assertThat(ned.y()).isCloseTo(0.0, within(3.0));
    assertThat(lowestAsideM).isGreaterThan(25.0);
  }

  /** The approach is broken off beyond the position, where control did not touch down. */
  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void landing_plannerReplacedWhileItClimbsAway_climbsOnStraightAhead(boolean isSwap) {
    start(true);
    ned = Point.of(-900.0, 0.0, -30.0);
    velocity = Point.of(20.0, 0.0, 0.0);
    pursue(landing().psi(0.0));
    boolean isBroken = false;
    double acrossMps = 0.0;
    while (kit.nowS() < 200.0 && (!isBroken || -ned.z() < 12.0)) {
      step(20.0);
      ned = Point.of(ned.x(), ned.y(), Math.min(ned.z(), -5.0));
      acrossMps = Math.max(acrossMps, Math.abs(velocity.y()));
      if (!isBroken && kit.log("PathPlanner").stream().anyMatch(line -> line.contains("again"))) {
        isBroken = true;
        interrupt(isSwap);
      }
    }

    assertThat(-ned.z()).isGreaterThan(12.0);
    assertThat(acrossMps).isLessThan(0.5);
  }

  /** A gust has put it down a little aside. */
  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void landing_multirotorOnTheGroundAsideAndPlannerReplaced_staysDown(boolean isSwap) {
    start(false);
    ned = Point.of(0.0, 0.0, -8.0);
    pursue(landing());
    while (ned.z() < 0.0) {
      step(2.0);
    }
    ned = Point.of(4.0, 0.0, 0.0);
    velocity = Point.ORIGIN;
    step(0.0);
    velocity = Point.ORIGIN;
    interrupt(isSwap);
    for (int i = 0; i < 100 && reports().isEmpty(); i++) {
      assertThat(step(0.0).z()).isPositive();
      ned = Point.of(4.0, 0.0, 0.0);
      velocity = Point.ORIGIN;
    }

    assertThat(reports().get(0).completed()).isTrue();
  }

  @Test
  void takeOff_plannerSwappedOnTheFirstMetres_risesStraightUpOn() {
    start(false);
    pursue(new TakeOff().z(-10.0));
    for (int i = 0; i < 40; i++) {
      step(0.0);
      ned = Point.of(0.3, 0.0, -0.5); // it drifts, and is about to lift off
    }
    interrupt(true);

    assertThat(step(5.0).x()).isCloseTo(0.0, within(1e-9));
  }
}
