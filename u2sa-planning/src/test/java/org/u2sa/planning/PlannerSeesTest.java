package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.ObjectGoal;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.PolyLine;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.planning.guidance.Leg;

/** The planner with objects around the vehicle. */
class PlannerSeesTest extends PlannedVehicle {
  private static Circle disc(String uid, double north, double east, double radius) {
    return new Circle()
        .radius(radius)
        .uid(uid)
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(north)
        .y(east);
  }

  private ObjectDescription[] around = {}; // published before each state, as the World Modeler does

  private void see(ObjectDescription... objects) {
    around = objects;
    kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(objects)));
  }

  private void start(String planner) {
    kit.with("PLANNER", planner).start(PathPlanner::new);
    goals(waypoint("1", 10, 0));
  }

  private PlannedPath path() {
    return kit.latest(Channels.PLANS).orElseThrow();
  }

  private void drive(int steps, double north, double east, double heading) {
    for (int i = 0; i < steps; i++) {
      kit.advance(0.1);
      see(around);
      kit.publish(Channels.STATE, state(north, east, heading));
    }
  }

  @Test
  void state_discOnTheLine_plansAroundItAndSaysSo() {
    start("GRID");
    see(disc("rock", 5, 0, 1.0));
    drive(1, 0, 0, 0);

    assertThat(path().planner()).isEqualTo("GRID");
    assertThat(path().goal()).isEqualTo("1");
    assertThat(path().status()).isEqualTo(PathStatus.FOLLOWED);
    assertThat(path().cost().orElseThrow()).isBetween(10.0, 14.0);
    List<Point> points = path().points();
    for (int i = 1; i < points.size(); i++) {
      Leg leg =
          new Leg(
              points.get(i - 1).x(), points.get(i - 1).y(), points.get(i).x(), points.get(i).y());
      assertThat(leg.distanceM(5.0, 0.0)).isGreaterThan(1.5);
    }
  }

  private static PolyLine wall(String uid, double fromEast, double toEast) {
    PolyLine wall = new PolyLine();
    wall.points(List.of(Point.of(5, fromEast, 0), Point.of(5, toEast, 0))).width(0.0);
    wall.uid(uid).referenceFrame(ReferenceFrame.LOCAL_NED).x(5).y(fromEast);
    return wall;
  }

  /** What the way costs of a vehicle 0.92 m wide to behind a wall with a gap of 1.25 m. */
  private double costThroughAGap(double narrowestPassageM, double wallReachesM) {
    driveToAGap(narrowestPassageM, wallReachesM);
    return path().cost().orElseThrow();
  }

  private void driveToAGap(double narrowestPassageM, double wallReachesM) {
    kit.with("PLANNER", "GRID").with("CLEARANCE", 0.03).with("INFLATION COST", 0.0);
    kit.with("VEHICLE FRONT", 0.4).with("VEHICLE REAR", 0.2).with("VEHICLE WIDTH", 0.92);
    kit.with("NARROWEST PASSAGE", narrowestPassageM).start(PathPlanner::new);
    goals(waypoint("1", 10, 0));
    see(wall("west", -wallReachesM, -0.625), wall("east", 0.625, wallReachesM));
    drive(10, 0, 0, 0);
  }

  @ParameterizedTest
  @CsvSource({
    "around it, 0.0, 8.0, 15.0, 50.0",
    "through it as there is no other way, 0.0, 25.0, 9.9, 10.5",
    "through it as it is no narrower than the passage, 1.0, 8.0, 9.9, 10.5"
  })
  void state_gapTooNarrowToTurnIn_goes(
      String which, double narrowestM, double reachesM, double leastCost, double mostCost) {
    assertThat(costThroughAGap(narrowestM, reachesM)).as(which).isBetween(leastCost, mostCost);
  }

  @Test
  void state_gapThatOnlyFineCellsShow_isFoundOnNarrowCells() {
    kit.with("PLANNING CELL", 0.25).with("NARROW CELL", 0.05);

    assertThat(costThroughAGap(0.0, 25.0)).isBetween(9.9, 10.5);
  }

  @Test
  void state_gapThatOnlyFineCellsShowAndNoNarrowCells_findsNoWay() {
    kit.with("PLANNING CELL", 0.25);
    driveToAGap(0.0, 25.0);

    assertThat(path().cost()).isEmpty();
  }

  @Test
  void state_plannerNone_goesStraightThroughAndPlansNothing() {
    kit.with("LOOK AHEAD", 2.0).start(PathPlanner::new);
    goals(waypoint("1", 10, 0));
    see(disc("rock", 5, 0, 1.0));
    drive(1, 0, 0, 0);

    assertThat(point().y()).isCloseTo(0.0, within(1.0e-9));
    assertThat(kit.published(Channels.PLANS)).isEmpty();
  }

  @Test
  void state_newDiscOnTheRoute_plansAnew() {
    start("GRID");
    drive(1, 0, 0, 0);
    double before = path().cost().orElseThrow();
    see(disc("rock", 5, 0, 1.0));
    drive(1, 0, 0, 0);

    assertThat(path().cost().orElseThrow()).isGreaterThan(before + 0.2);
  }

  @Test
  void state_discOnTheGoal_isGivenUpWithThatReason() {
    kit.with("GIVE UP AFTER", 2.0);
    start("GRID");
    see(disc("rock", 10, 0, 4.0));
    drive(30, 0, 0, 0);

    GoalInformation report = kit.latest(Channels.GOAL_REPORTS).orElseThrow();
    assertThat(report.abandoned()).isTrue();
    assertThat(report.reason().orElseThrow()).contains("the goal is occupied by an obstacle");
    assertThat(path().status()).isEqualTo(PathStatus.GIVEN_UP);
  }

  /** A rock on the goal, believed in that much, until the planner has waited for 3 s. */
  private PathStatus rockOfConfidence(double confidence, double overlookAfterS) {
    kit.with("PLANNER", "GRID").with("GIVE UP AFTER", 20.0);
    kit.with("OVERLOOK AFTER", overlookAfterS).start(PathPlanner::new);
    goals(waypoint("1", 10, 0));
    Circle rock = disc("rock", 10, 0, 4.0);
    rock.confidence(confidence);
    see(rock);
    drive(30, 0, 0, 0);
    return path().status();
  }

  @Test
  void state_noWayButThroughAGuess_goesThroughItAfterAWhile() {
    assertThat(rockOfConfidence(0.5, 2.0)).isEqualTo(PathStatus.FOLLOWED);
    assertThat(path().cost().orElseThrow()).isBetween(9.0, 11.0);
  }

  @ParameterizedTest
  @CsvSource({"waits first, 0.5, 4.0", "was seen, 0.6, 2.0", "is not to be overlooked, 0.5, 0.0"})
  void state_noWayButThroughAGuess_waits(String why, double confidence, double overlookAfterS) {
    assertThat(rockOfConfidence(confidence, overlookAfterS)).as(why).isEqualTo(PathStatus.WAITING);
  }

  @Test
  void state_noWayForLong_looksToTheSide() {
    rockOfConfidence(0.9, 1.0);
    assertThat(Math.atan2(point().y(), point().x()))
        .isCloseTo(Math.toRadians(-60.0), within(Math.toRadians(1.0))); // BODY: to the right
  }

  @Test
  void missionOver_goalWasGivenUp_holdsWhereItIsInsteadOfGoingThroughWhatStandsInTheWay() {
    kit.with("PLANNER", "GRID").with("GIVE UP AFTER", 2.0).with("AT END", "HOLD");
    kit.start(PathPlanner::new);
    goals(waypoint("1", 10, 0));
    see(disc("rock", 10, 0, 4.0));
    drive(30, 0, 0, 0);
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().abandoned()).isTrue();

    goals();
    drive(1, 0, 0, 0);
    assertThat(Math.hypot(point().x(), point().y())).isLessThan(0.01);
  }

  private void startReversing(int recoveries) {
    kit.with("STUCK AFTER", 1.0).with("RECOVERIES", recoveries).with("REVERSES", true);
    start("GRID");
  }

  private String reason() {
    return kit.latest(Channels.GOAL_REPORTS).orElseThrow().reason().orElseThrow();
  }

  @Test
  void state_vehicleDoesNotMove_freesItselfThenGivesUp() {
    startReversing(2);
    see(disc("rock", 30, 30, 1.0));
    drive(60, 0, 0, 0);

    assertThat(logged("stuck: freeing itself, attempt 2 of 2")).isEqualTo(1);
    assertThat(kit.published(Channels.NAVIGATION)).anyMatch(NavigationPoint::backwards);
    assertThat(reason()).contains("stuck after 2 attempts");
  }

  @Test
  void state_walkerComesOnForLong_keepsTheGoalAsLongAsHeIsThere() {
    startReversing(2);
    Circle walker = disc("walker", 2.5, 0, 0.3);
    walker.motion().velocity(Point.of(-0.3, 0.0, 0.0));
    for (int second = 0; second < 60; second++) {
      see((Circle) walker.copy());
      drive(10, 0, 0, 0);
    }
    assertThat(kit.published(Channels.GOAL_REPORTS)).isEmpty();

    see(disc("rock", 30, 30, 1.0));
    drive(60, 0, 0, 0);
    assertThat(reason()).contains("stuck after 2 attempts");
  }

  @Test
  void state_freesItselfAgainAndAgain_givesUpSinceItGetsNoNearer() {
    startReversing(100);
    see(disc("rock", 30, 30, 1.0));
    drive(420, 0, 0, 0);
    assertThat(kit.published(Channels.GOAL_REPORTS)).isEmpty();
    drive(60, 0, 0, 0); // four times 10 m at 1 m/s, and five times STUCK AFTER

    assertThat(reason()).contains("no closer to the goal for 4");
  }

  /** A bay that opens to the north: a way into it backwards takes HYBRID many nodes. */
  @Test
  void state_wayIsHardToFind_standsAndSaysSoUntilItIsFound() {
    kit.with("PLANNER", "HYBRID").with("TURN RADIUS", 0.9).with("REVERSES", true);
    kit.with("VEHICLE FRONT", 0.43).with("VEHICLE REAR", 0.1).with("VEHICLE WIDTH", 0.3);
    driveToABay(1000);

    assertThat(path().status()).isEqualTo(PathStatus.WAITING);
    assertThat(path().reason()).hasValue("searching for a route to the goal");
    assertThat(kit.latest(Channels.NAVIGATION).orElseThrow().speed()).hasValue(0.0);
    drive(190, 0, 0, Math.PI / 2.0);
    assertThat(kit.published(Channels.NAVIGATION)).hasSize(191);
    assertThat(kit.published(Channels.PLANS)).anyMatch(plan -> !plan.points().isEmpty());
  }

  /**
   * It cannot wait for its way, nor may one state's search keep it from its next navigation point.
   */
  @Test
  void state_wayInFlightIsHardToFind_goesOnWhileItIsSoughtInParts() {
    kit.with("PLANNER", "HYBRID").with("TURN RADIUS", 0.9).with("MIN SPEED", 0.5);
    driveToABay(100);

    assertThat(kit.published(Channels.PLANS)).allMatch(plan -> plan.points().isEmpty());
    assertThat(kit.latest(Channels.NAVIGATION).orElseThrow().speed().orElseThrow())
        .isGreaterThanOrEqualTo(0.5);
    drive(190, 0, 0, Math.PI / 2.0);
    assertThat(kit.published(Channels.PLANS)).anyMatch(plan -> !plan.points().isEmpty());
  }

  private void driveToABay(int effort) {
    kit.with("CLEARANCE", 0.15).with("PLANNING SPAN", 20.0).with("PLANNING EFFORT", effort);
    kit.start(PathPlanner::new);
    goals(waypoint("1", -4.4, 0).horizontalThreshold(0.2).psi(0.0));
    see(bay("left", 0.8), bay("right", -0.8));
    drive(1, 0, 0, Math.PI / 2.0);
  }

  /** A wall of 1.6 m along the bay. */
  private static ObjectDescription bay(String uid, double east) {
    List<Point> corners =
        List.of(
            Point.of(-5.2, east - 0.1, 0.0),
            Point.of(-5.2, east + 0.1, 0.0),
            Point.of(-3.4, east + 0.1, 0.0),
            Point.of(-3.4, east - 0.1, 0.0));
    return new Polygon()
        .points(corners)
        .uid(uid)
        .referenceFrame(ReferenceFrame.LOCAL_NED)
        .x(-4.3)
        .y(east);
  }

  @Test
  void state_trafficCannotBeAvoided_brakesAndSaysSo() {
    start("GRID");
    Circle car = disc("car", 1.5, 0, 0.9);
    car.motion().velocity(Point.of(-3.0, 0.0, 0.0));
    see(car);
    kit.advance(0.1);
    kit.publish(Channels.STATE, state(0, 0, 0).xDot(1.0).yDot(0.0));

    NavigationPoint point = kit.latest(Channels.NAVIGATION).orElseThrow();
    assertThat(path().status()).isEqualTo(PathStatus.BRAKING);
    assertThat(path().reason().orElseThrow()).contains("collision");
    assertThat(logged("collision imminent")).isEqualTo(1);
    assertThat(point.speed()).hasValue(0.0);
  }

  @Test
  void state_trafficCrossesLater_isNotFollowedIntoIt() {
    start("GRID");
    Circle car = disc("car", 3.0, -3.0, 0.5);
    car.motion().velocity(Point.of(0.0, 1.0, 0.0)); // is where the vehicle would be in 3 s
    see(car);
    kit.advance(0.1);
    kit.publish(Channels.STATE, state(0, 0, 0).xDot(1.0).yDot(0.0));

    NavigationPoint point = kit.latest(Channels.NAVIGATION).orElseThrow();
    boolean slower = point.speed().orElseThrow() < 0.9;
    boolean aside = Math.abs(point.point().y()) > 0.1;
    assertThat(slower || aside).isTrue();
  }

  @ParameterizedTest
  @ValueSource(strings = {"GRID", "THETA", "HYBRID"})
  void state_waypointWithTime_setsTheSpeedThatArrivesThen(String planner) {
    kit.with("PLANNER", planner).with("MAX SPEED", 3.0).start(PathPlanner::new);
    goals(waypoint("1", 10, 0).time(5.1));
    drive(1, 0, 0, 0);
    kit.advance(0.001);
    see();
    kit.publish(Channels.STATE, state(0, 0, 0));

    double speed = kit.latest(Channels.NAVIGATION).orElseThrow().speed().orElseThrow();
    assertThat(speed).isCloseTo(2.0, within(0.05)); // 10 m in 5 s
  }

  @Test
  void state_waypointWithTimeInALaterMission_countsFromThatMissionsBeginning() {
    kit.with("PLANNER", "GRID").with("MAX SPEED", 3.0).start(PathPlanner::new);
    goals(waypoint("0", 1, 0));
    kit.advance(60.0);
    kit.publish(Channels.GOALS, new GoalList());
    goals(waypoint("1", 10, 0).time(5.1));
    assertThat(speedAfter(0.1)).as("a new list of goals").isCloseTo(2.0, within(0.05));

    kit.advance(60.0); // not armed yet, say
    kit.publish(
        Channels.GOALS, new GoalList().goals(List.of(waypoint("1", 10, 0).time(8.0))).elapsed(2.9));
    assertThat(speedAfter(0.1)).as("by the mission's clock").isCloseTo(2.0, within(0.05));
  }

  private double speedAfter(double seconds) {
    kit.advance(seconds);
    see();
    kit.publish(Channels.STATE, state(0, 0, 0));
    return kit.latest(Channels.NAVIGATION).orElseThrow().speed().orElseThrow();
  }

  @ParameterizedTest
  @ValueSource(strings = {"GRID", "THETA"})
  void state_atWaypointWithHeading_turnsBeforeItIsReached(String planner) {
    kit.with("PLANNER", planner).start(PathPlanner::new);
    goals(waypoint("1", 10, 0).psi(Math.PI / 2.0));
    drive(1, 5, 0, 0);
    drive(1, 10, 0, 0);
    assertThat(kit.published(Channels.GOAL_REPORTS)).isEmpty();
    // Where it is: a small turn towards a point ahead would be driven as an arc.
    assertThat(point().distance()).isLessThan(1.0e-9);
    double turn = kit.latest(Channels.NAVIGATION).orElseThrow().turn().orElseThrow();
    assertThat(turn).isCloseTo(Math.PI / 2.0, within(1.0e-9));

    drive(1, 10, 0, Math.PI / 2.0 - 0.05);
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
  }

  @ParameterizedTest
  @CsvSource({"GRID, 0", "HYBRID, 1"})
  void state_atWaypointWithHeadingButDoesNotTurn_isGivenUp(String planner, double turnRadius) {
    kit.with("PLANNER", planner).with("TURN RADIUS", turnRadius).with("STUCK AFTER", 1.0);
    kit.start(PathPlanner::new);
    goals(waypoint("1", 10, 0).psi(Math.PI / 2.0));
    drive(1, 5, 0, 0);
    drive(400, 10, 0, 0);

    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().abandoned()).isTrue();
  }

  @Test
  void state_hybridAndWaypointWithHeading_routeArrivesInIt() {
    kit.with("PLANNER", "HYBRID").with("TURN RADIUS", 1.0).start(PathPlanner::new);
    goals(waypoint("1", 10, 0).psi(Math.PI / 2.0));
    drive(1, 0, 0, 0);

    List<Point> points = path().points();
    Point last = points.get(points.size() - 1);
    Point before = points.get(points.size() - 2);
    double bearing = Math.atan2(last.y() - before.y(), last.x() - before.x());
    assertThat(bearing).isCloseTo(Math.PI / 2.0, within(Math.toRadians(15.0)));
  }

  @Test
  void state_corridor_staysInside() {
    Polygon corridor = new Polygon();
    corridor.points(
        List.of(
            Point.of(-2, -2, 0),
            Point.of(12, -2, 0),
            Point.of(12, 8, 0),
            Point.of(8, 8, 0),
            Point.of(8, 2, 0),
            Point.of(-2, 2, 0)));
    corridor.uid("C").objectType("corridor").referenceFrame(ReferenceFrame.LOCAL_NED).x(5).y(0);
    kit.with("PLANNER", "GRID").start(PathPlanner::new);
    goals(waypoint("1", 10, 6));
    see(corridor);
    drive(1, 0, 0, 0);

    assertThat(path().points()).allMatch(p -> p.y() <= 2.0 || p.x() >= 8.0);
    assertThat(path().points().size()).isGreaterThan(2);
  }

  @Test
  void objects_noStateEstimator_leadToTheObjectAndPointTheGimbal() {
    kit.with("PLANNER", "GRID").start(PathPlanner::new);
    kit.publish(
        Channels.GOALS,
        new GoalList()
            .goals(
                List.of(
                    new ObjectGoal()
                        .uid("1")
                        .objectType("buoy")
                        .within(1.5)
                        .speed(0.4)
                        .pointed(List.of("GIMBAL"))))
            .upcoming(List.<GoalInformation>of()));
    kit.advance(0.1);
    see(buoy(6.0, 2.0));

    NavigationPoint gimbal = first("GIMBAL");
    NavigationPoint vehicle = first("VEHICLE");
    assertThat(gimbal.point().x()).isCloseTo(6.0, within(1.0e-6));
    assertThat(gimbal.point().y()).isCloseTo(2.0, within(1.0e-6)); // BODY: to the left
    assertThat(vehicle.point().x()).isPositive();
    assertThat(vehicle.speed()).hasValue(0.4);

    kit.advance(0.1);
    see(buoy(1.2, 0.0));
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
  }

  private NavigationPoint first(String subsystem) {
    return kit.published(Channels.NAVIGATION).stream()
        .filter(point -> point.subsystem().equals(subsystem))
        .findFirst()
        .orElseThrow();
  }

  private static Circle buoy(double ahead, double left) {
    return new Circle()
        .radius(0.2)
        .uid("B")
        .objectType("buoy")
        .referenceFrame(ReferenceFrame.BODY)
        .x(ahead)
        .y(left);
  }

  @Test
  void swap_onARoute_goesOnWithinTheSameStep() {
    PathPlanner first = kit.with("PLANNER", "GRID").start(PathPlanner::new);
    goals(waypoint("1", 10, 0));
    see(disc("rock", 5, 0, 1.0));
    drive(3, 0, 0, 0);
    kit.swap(first, PathPlanner::new);
    drive(1, 0, 0, 0);

    NavigationPoint point = kit.latest(Channels.NAVIGATION).orElseThrow();
    assertThat(point.timestamp()).hasValue(kit.clock().micros());
  }
}
