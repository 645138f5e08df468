package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;

/** A planner that avoids obstacles and does not know its surroundings. */
class PlannerBlindTest extends PlannedVehicle {
  private PathPlanner planner;

  private void start(String routes) {
    kit.with("PLANNER", routes).with("WORLD STALE AFTER", 2.0);
    planner = kit.start(PathPlanner::new);
    goals(waypoint("1", 50, 0));
  }

  private void startAircraft() {
    kit.with("MIN SPEED", 36.0).with("LOITER RADIUS", 800.0).with("TURN ACCELERATION", 4.6);
    start("AIR");
  }

  private void empty(String... awaited) {
    kit.publish(Channels.OBJECTS, new ObjectList().awaited(List.of(awaited)));
  }

  /**
   * Number of navigation points with a speed above zero, published in the given number of 0.1 s
   * steps.
   */
  private int pointsIn(int steps) {
    kit.forget();
    for (int i = 0; i < steps; i++) {
      kit.advance(0.1);
      kit.publish(Channels.STATE, state(0, 0, 0).xDot(1.0).yDot(0.0));
    }
    return (int)
        kit.published(Channels.NAVIGATION).stream()
            .filter(point -> point.speed().orElse(1.0) > 0.0)
            .count();
  }

  @ParameterizedTest
  @ValueSource(strings = {"GRID", "THETA", "HYBRID", "AIR"})
  void state_worldNeverCame_standsAndSaysSoOnce(String planner) {
    start(planner);

    assertThat(pointsIn(20)).isZero();
    assertThat(kit.published(Channels.NAVIGATION)).as("it may not have taken off").isEmpty();
    assertThat(logged("stands: neither objects nor a grid yet")).isEqualTo(1);
  }

  @Test
  void state_plannerNone_needsNoWorld() {
    start("NONE");
    assertThat(pointsIn(20)).isEqualTo(20);
  }

  @Test
  void state_worldFallsSilent_standsUntilItComesAgain() {
    start("GRID");
    empty();
    assertThat(pointsIn(40)).as("2 s of 4").isEqualTo(20);
    assertThat(kit.latest(Channels.NAVIGATION).orElseThrow().speed()).as("brakes").hasValue(0.0);
    assertThat(logged("stands: no data from the World Modeler for more than 2.0 s")).isEqualTo(1);

    empty();
    assertThat(pointsIn(10)).isEqualTo(10);
    assertThat(logged("surroundings known again: continues")).isEqualTo(1);
  }

  /** A list that is too long is not published, while the grid is. */
  @Test
  void state_onlyTheGridComes_standsWithoutObjects() {
    start("GRID");
    empty();
    assertThat(pointsIn(10)).isEqualTo(10);
    int moving = 0;
    for (int i = 0; i < 4; i++) {
      kit.publish(Channels.GRID, grid());
      moving += pointsIn(10);
    }
    assertThat(moving).as("2 s after the last objects").isEqualTo(10);
  }

  @Test
  void state_gridAlone_suffices() {
    start("GRID");
    for (int i = 0; i < 4; i++) {
      kit.publish(Channels.GRID, grid());
      assertThat(pointsIn(10)).isEqualTo(10);
    }
  }

  private static OccupancyGrid grid() {
    return new OccupancyGrid()
        .anchor(ReferenceFrame.LOCAL_NED, Point.ORIGIN)
        .corner(-5.0, -5.0)
        .resolution(0.5)
        .cells(20, new byte[400]);
  }

  @Test
  void state_emptyWorldThatKeepsComing_goesOn() {
    start("GRID");
    for (int i = 0; i < 10; i++) {
      empty();
      assertThat(pointsIn(10)).isEqualTo(10);
    }
  }

  @Test
  void state_onlyAnOldRetainedWorld_stands() {
    kit.advance(60.0);
    start("GRID");
    ObjectList old = new ObjectList();
    old.timestamp(0L);
    kit.publish(Channels.OBJECTS, old);

    assertThat(pointsIn(10)).isZero();
  }

  @Test
  void state_worldLacksASensor_standsAndNamesItUntilItMeasuresAgain() {
    start("GRID");
    empty("LidarSensor");
    assertThat(pointsIn(10)).isZero();
    assertThat(logged("stands: the World Modeler receives no data from LidarSensor")).isEqualTo(1);

    empty();
    assertThat(pointsIn(10)).isEqualTo(10);
  }

  @Test
  void state_aircraftLosesItsWorld_circlesInsteadOfGoingOn() {
    startAircraft();
    empty();
    pointsIn(20);
    assertThat(pointsIn(10)).isEqualTo(10);
    assertThat(point().y()).as("abeam, not towards the goal ahead").isNotZero();
    assertThat(logged("stands: no data from the World Modeler")).isEqualTo(1);
  }

  /** It circles for its goal's sake and for the lost world's: two circles. */
  @Test
  void swap_aircraftThatHoldsBlindAtItsStation_circlesOn() {
    startAircraft();
    Station station = new Station();
    station.uid("S").referenceFrame(ReferenceFrame.LOCAL_NED).x(800.0).y(0.0);
    goals(station.horizontalThreshold(50.0));
    empty();
    pointsIn(30);
    Point before = point();
    kit.swap(planner, PathPlanner::new);

    assertThat(pointsIn(1)).isEqualTo(1);
    assertThat(point()).isEqualTo(before);
  }

  @ParameterizedTest
  @CsvSource({"GRID, RETURN, 0", "GRID, LAND, 10", "AIR, RETURN, 10", "AIR, LAND, 10"})
  void state_blindInAFailsafe_landsAndFliesHomeAllTheSame(
      String planner, FailsafeAction action, int points) {
    if (planner.equals("AIR")) {
      startAircraft();
    } else {
      start(planner);
    }
    kit.publish(
        Channels.FAILSAFE, new FailsafeState().action(action).causes(List.of("low battery")));
    assertThat(pointsIn(10)).isEqualTo(points);
  }
}
