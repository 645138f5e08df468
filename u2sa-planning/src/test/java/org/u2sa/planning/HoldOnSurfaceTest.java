package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.shape.Circle;

/** Positions that ground vehicles and boats hold while paused and at the end of a mission. */
class HoldOnSurfaceTest extends PlannedVehicle {
  private static final double RADIUS_M = 2.5;

  private List<ObjectDescription> objects = List.of(pole(0, 40));

  private static Circle pole(double north, double east) {
    Circle pole = new Circle().radius(0.2);
    pole.uid("pole " + north + " " + east).referenceFrame(ReferenceFrame.LOCAL_NED);
    pole.x(north).y(east);
    return pole;
  }

  private void startRudderBoat(String planner) {
    kit.with("TURN RADIUS", RADIUS_M);
    start(planner);
  }

  private void start(String planner) {
    kit.with("PLANNER", planner).with("AT END", "HOLD").start(PathPlanner::new);
  }

  private void pausedAt(double north) {
    GoalList goals = new GoalList().goals(List.of(waypoint("1", 50.0, 0.0))).upcoming(List.of());
    kit.publish(Channels.GOALS, goals);
    sees(north - 0.1);
    kit.publish(Channels.GOALS, ((GoalList) goals.copy()).paused(true));
    sees(north);
  }

  private void sees(double north) {
    sees(state(north, 0.0, 0.0));
  }

  private void sees(StateInformation state) {
    kit.advance(0.1);
    kit.publish(Channels.OBJECTS, new ObjectList().objects(objects));
    kit.publish(Channels.STATE, state);
  }

  private double commandedMps() {
    return kit.latest(Channels.NAVIGATION).orElseThrow().speed().orElse(Double.NaN);
  }

  /** It never comes to rest: it would be carried on until it counts as standing. */
  @Test
  void paused_boatThatDriftsWithHoldAtRest_goesBackAtOnce() {
    kit.with("HOLD AT REST", true).with("DRIFTS", true);
    start("GRID");
    GoalList goals = new GoalList().goals(List.of(waypoint("1", 50.0, 0.0))).upcoming(List.of());
    kit.publish(Channels.GOALS, goals.paused(true));
    for (double north = 10.0; north < 12.0; north += 0.1) {
      sees(state(north, 0.0, 0.0).xDot(1.0).yDot(0.0));
    }

    assertThat(point().x()).isLessThan(-1.5);
    assertThat(commandedMps()).isPositive();
  }

  @Test
  void paused_rudderBoatDriftsWithinItsTurningCircle_staysStopped() {
    startRudderBoat("HYBRID");
    pausedAt(10.0);
    for (double north : new double[] {10.5, 12.0, 14.9, 12.0}) {
      sees(north);
      assertThat(commandedMps()).as("at %.1f", north).isEqualTo(0.0);
    }
  }

  @Test
  void paused_rudderBoatWithoutRoutePlanner_staysStoppedToo() {
    startRudderBoat("NONE");
    pausedAt(10.0);
    sees(11.0);

    assertThat(commandedMps()).isEqualTo(0.0);
  }

  @Test
  void paused_rudderBoatDriftsFar_goesBackUntilItWouldHaveToCircle() {
    startRudderBoat("HYBRID");
    pausedAt(10.0);
    sees(15.2);
    assertThat(point().x()).isCloseTo(-5.2, within(1.0e-6));
    assertThat(commandedMps()).isBetween(0.5, 1.0);
    sees(state(12.0, 0.0, Math.PI));
    assertThat(point().x()).as("straight ahead").isCloseTo(2.0, within(1.0e-6));
    sees(state(9.8, 0.0, Math.PI));

    assertThat(commandedMps()).as("passed").isEqualTo(0.0);
  }

  @Test
  void paused_poleOnTheArcBackOfARudderBoat_holdsWhereItIs() {
    startRudderBoat("HYBRID");
    pausedAt(10.0);
    objects = List.of(pole(17.5, 2.5), pole(17.5, -2.5));
    sees(15.2);

    assertThat(point().distance()).isLessThan(0.05);
    sees(14.9);
    assertThat(commandedMps()).isEqualTo(0.0);
  }

  @Test
  void paused_vehicleThatTurnsInPlaceDrifts_goesBackNoFasterThanItStopsThere() {
    start("GRID");
    pausedAt(10.0);
    sees(10.5);

    assertThat(point().x()).isCloseTo(-0.5, within(1.0e-6));
    assertThat(commandedMps()).isBetween(0.5, Math.sqrt(0.0441 + 0.7) - 0.21 + 1.0e-9);
  }

  @Test
  void paused_poleWhereItWouldGoBack_holdsWhereItIs() {
    start("GRID");
    pausedAt(10.0);
    objects = List.of(pole(10.1, 0.0));
    sees(11.2);
    assertThat(point().distance()).isLessThan(0.05);
    objects = List.of(pole(0.0, 40.0));
    sees(11.3);

    assertThat(point().x()).as("held since").isCloseTo(-0.1, within(1.0e-6));
  }

  @Test
  void paused_passageTooNarrowToTurnIn_holdsWhereItIs() {
    kit.with("VEHICLE FRONT", 0.6).with("VEHICLE REAR", 0.6);
    start("GRID");
    pausedAt(10.0);
    objects = List.of(pole(10.8, 0.6), pole(10.8, -0.6), pole(10.4, 0.6), pole(10.4, -0.6));
    sees(10.5);

    assertThat(point().distance()).isLessThan(0.05);
  }

  @Test
  void paused_vehicleThatReversesInSuchAPassage_goesBackAstern() {
    kit.with("VEHICLE FRONT", 0.6).with("VEHICLE REAR", 0.6);
    kit.with("REVERSES", true).with("REVERSE SPEED", 0.2);
    start("GRID");
    pausedAt(10.0);
    objects = List.of(pole(10.8, 0.6), pole(10.8, -0.6), pole(10.4, 0.6), pole(10.4, -0.6));
    sees(10.5);

    assertThat(point().x()).isCloseTo(-0.5, within(1.0e-6));
    assertThat(kit.latest(Channels.NAVIGATION).orElseThrow().backwards()).isTrue();
    assertThat(commandedMps()).isEqualTo(0.2);
  }

  @Test
  void paused_movingVehicleInSuchAPassage_stopsAhead() {
    kit.with("VEHICLE FRONT", 0.6).with("VEHICLE REAR", 0.6);
    start("GRID");
    pausedAt(10.0);
    objects = List.of(pole(10.8, 0.6), pole(10.8, -0.6), pole(10.4, 0.6), pole(10.4, -0.6));
    sees(state(10.3, 0.0, 0.0).xDot(1.0).yDot(0.0));

    assertThat(point().x()).isCloseTo(0.3, within(1.0e-6));
  }

  @Test
  void paused_worldModelerIsSilent_holdsWhereItIs() {
    start("GRID");
    pausedAt(10.0);
    kit.advance(3.0);
    kit.publish(Channels.STATE, state(11.0, 0.0, 0.0));

    assertThat(point().distance()).isLessThan(1.0e-6);
  }

  @Test
  void atEnd_waypointBesideARudderBoat_isNotCircledTo() {
    startRudderBoat("HYBRID");
    goals(waypoint("1", 20.0, 0.0));
    sees(17.0);
    sees(state(19.5, 0.8, 0.0));
    sees(state(19.8, 0.8, 0.0));
    sees(state(20.1, 0.8, 0.0));
    goals();
    sees(state(20.2, 0.8, 0.0));

    assertThat(kit.published(Channels.GOAL_REPORTS)).as("reached").isNotEmpty();
    assertThat(commandedMps()).isEqualTo(0.0);
  }

  @Test
  void atEnd_waypointAheadOfARudderBoat_isReached() {
    startRudderBoat("HYBRID");
    goals(waypoint("1", 20.0, 0.0));
    sees(17.0);
    sees(18.6);
    goals();
    sees(18.7);

    assertThat(kit.published(Channels.GOAL_REPORTS)).as("reached").isNotEmpty();
    assertThat(point().x()).isCloseTo(1.3, within(1.0e-6));
    assertThat(commandedMps()).isPositive();
  }
}
