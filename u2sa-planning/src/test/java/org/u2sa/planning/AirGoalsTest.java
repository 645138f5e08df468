package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.planning.guidance.Leg;

/** What an aircraft's planner makes of a waypoint's heading, time and threshold. */
class AirGoalsTest extends PlannedVehicle {
  private static final Map<String, Object> AIRCRAFT =
      new TreeMap<>(
          Map.ofEntries(
              Map.entry("LOOK AHEAD", 150.0),
              Map.entry("LOOK AHEAD TIME", 3.0),
              Map.entry("TURN ACCELERATION", 4.2),
              Map.entry("TURN LAG", 0.7),
              Map.entry("VEHICLE WIDTH", 11.0),
              Map.entry("CLEARANCE", 30.0),
              Map.entry("INFLATION", 100.0),
              Map.entry("PLANNING CELL", 25.0),
              Map.entry("PLANNING SPAN", 8000.0),
              Map.entry("PLANNED SPEED", 46.0),
              Map.entry("MIN SPEED", 40.0),
              Map.entry("MAX SPEED", 60.0),
              Map.entry("STUCK AFTER", 20.0)));

  private final TestAircraft aircraft = new TestAircraft(0.0, 0.0, 500.0, 0.0);

  private void start(String planner) {
    aircraft.onEarth = false;
    AIRCRAFT.forEach(kit::with);
    kit.with("PLANNER", planner).start(PathPlanner::new);
  }

  private Waypoint goal(double north, double east) {
    return waypoint("1", north, east).horizontalThreshold(100.0);
  }

  /** Flies until the goal is reported, or for so long; answers the report. */
  private GoalInformation fly(double limitS) {
    while (kit.nowS() < limitS && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      kit.publish(Channels.OBJECTS, new ObjectList()); // an empty sky
      kit.publish(Channels.STATE, aircraft.state());
      aircraft.step(0.1, kit.latest(Channels.NAVIGATION));
      kit.advance(0.1);
    }
    return kit.latest(Channels.GOAL_REPORTS).orElseThrow();
  }

  @ParameterizedTest
  @CsvSource({"AIR, 0", "AIR, 90", "AIR, 180", "AIR, 270", "HYBRID, 90", "HYBRID, 180"})
  void state_waypointWithHeading_arrivesWithIt(String planner, double degrees) {
    start(planner);
    goals(goal(3000.0, 500.0).psi(Math.toRadians(degrees)));
    GoalInformation report = fly(300.0);
    assertThat(report.completed()).isTrue();
    double off = Leg.wrapped(aircraft.heading - Math.toRadians(degrees));
    assertThat(Math.toDegrees(off)).isCloseTo(0.0, within(12.0)); // 10 of ARRIVAL ANGLE, a step
    assertThat(Math.hypot(aircraft.north - 3000.0, aircraft.east - 500.0)).isLessThan(105.0);
  }

  @ParameterizedTest
  @ValueSource(strings = {"AIR", "HYBRID"})
  void state_waypointWithoutHeading_isPassedWellInsideItsThreshold(String planner) {
    start(planner);
    goals(goal(3000.0, 500.0));
    assertThat(fly(300.0).completed()).isTrue();
    double miss = Math.hypot(aircraft.north - 3000.0, aircraft.east - 500.0);
    assertThat(miss).isLessThan(planner.equals("AIR") ? 65.0 : 80.0);
    assertThat(miss).isGreaterThan(20.0); // it need not come nearer than a corner may be cut
  }

  @ParameterizedTest
  @CsvSource({
    "AIR, 4600, 90, 51",
    "AIR, 4600, 115, 40",
    "AIR, 4600, 50, 60",
    "HYBRID, 4600, 90, 51"
  })
  void state_waypointWithTime_flightSpeedThatArrivesThenWithinItsLimits(
      String planner, double northM, double timeS, double wantedMps) {
    start(planner);
    goals(goal(northM, 0.0).time(timeS));
    for (int i = 0; i < 2; i++) {
      kit.publish(Channels.OBJECTS, new ObjectList()); // an empty sky
      kit.publish(Channels.STATE, aircraft.state());
      kit.advance(0.1);
    }
    NavigationPoint point = kit.latest(Channels.NAVIGATION).orElseThrow();
    assertThat(point.speed().orElseThrow()).isCloseTo(wantedMps, within(0.8));
  }

  @Test
  void state_waypointFartherThanAPathHasPoints_isFlownTowards() {
    start("AIR");
    goals(goal(9.0e6, 0.0));
    kit.publish(Channels.OBJECTS, new ObjectList()); // an empty sky
    kit.publish(Channels.STATE, aircraft.state());
    kit.advance(0.1);
    Point ahead = kit.latest(Channels.NAVIGATION).orElseThrow().point();
    assertThat(ahead.x()).isGreaterThan(100.0);
    assertThat(ahead.y()).isCloseTo(0.0, within(1.0));
    assertThat(kit.latest(Channels.PLANS).orElseThrow().points()).hasSizeLessThan(11_000);
  }

  @Test
  void state_waypointWithTimeAndTailwind_windDoesItsShare() {
    start("AIR");
    goals(goal(4600.0, 0.0).time(80.0)); // 57.5 m/s over ground
    for (int i = 0; i < 2; i++) {
      kit.publish(Channels.OBJECTS, new ObjectList()); // an empty sky
      kit.publish(Channels.STATE, aircraft.state().fluidxDot(38.0)); // of 46 m/s over ground
      kit.advance(0.1);
    }
    double speed = kit.latest(Channels.NAVIGATION).orElseThrow().speed().orElseThrow();
    assertThat(speed).isCloseTo(57.5 - 8.0, within(0.5));
  }

  @Test
  void state_crosswind_routeBeginsAlongTheCourseNotTheNose() {
    start("AIR");
    goals(goal(3000.0, 0.0));
    StateInformation drifting = aircraft.state().psi(Math.toRadians(-20.0));
    kit.publish(Channels.OBJECTS, new ObjectList()); // an empty sky
    kit.publish(Channels.STATE, drifting);
    kit.advance(0.1);
    PlannedPath path = kit.latest(Channels.PLANS).orElseThrow();
    Point second = path.points().get(1);
    assertThat(Math.atan2(second.y(), second.x())).isCloseTo(0.0, within(0.02));
  }

  @Test
  void state_circlesWithoutGettingNearer_givesUpWithThatReason() {
    start("AIR");
    goals(goal(3000.0, 0.0));
    double given = Double.NaN;
    for (double t = 0.0; t < 600.0 && Double.isNaN(given); t += 0.5) {
      double angle = t * 46.0 / 400.0;
      kit.publish(Channels.OBJECTS, new ObjectList());
      kit.publish(
          Channels.STATE,
          new StateInformation()
              .referenceFrame(ReferenceFrame.LOCAL_NED)
              .x(-400.0 + 400.0 * Math.cos(angle))
              .y(400.0 * Math.sin(angle))
              .z(-500.0)
              .psi(angle + Math.PI / 2.0)
              .xDot(-46.0 * Math.sin(angle))
              .yDot(46.0 * Math.cos(angle)));
      kit.advance(0.5);
      given = kit.latest(Channels.GOAL_REPORTS).isPresent() ? t : Double.NaN;
    }
    GoalInformation report = kit.latest(Channels.GOAL_REPORTS).orElseThrow();
    assertThat(report.completed()).isFalse();
    assertThat(report.reason().orElseThrow()).contains("no closer to the goal for");
    assertThat(given).isBetween(250.0, 599.0); // 4 times 3 to 6 km at 46 m/s, and 20 s
  }

  /**
   * The tower stands where the aircraft would turn onto the line of its approach, or where that
   * begins: then it joins the line at another place.
   */
  @ParameterizedTest
  @ValueSource(doubles = -370.0)
  void landing_towerBesideOrAtTheEntry_isNotTouchedOnTheWayToTheLine(double towerEast) {
    double towerNorth = -2790.0;
    Sphere tower = new Sphere().radius(150.0);
    tower.uid("tower").objectType("tower").referenceFrame(ReferenceFrame.LOCAL_NED);
    tower.x(towerNorth).y(towerEast).z(-500.0);
    start("AIR");
    Waypoint landing = new Landing().approach(1000.0).slope(0.5);
    landing.uid("1").referenceFrame(ReferenceFrame.LOCAL_NED);
    goals(landing.x(0.0).y(0.0).z(0.0).psi(0.0).horizontalThreshold(30.0));
    aircraft.north = 2000.0;
    aircraft.east = 800.0;
    aircraft.heading = Math.PI;
    double nearestM = Double.POSITIVE_INFINITY;
    boolean descends = false;
    while (kit.nowS() < 600.0 && !descends) {
      kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(tower)));
      kit.publish(Channels.STATE, aircraft.state());
      aircraft.step(0.1, kit.latest(Channels.NAVIGATION));
      kit.advance(0.1);
      nearestM =
          Math.min(nearestM, Math.hypot(aircraft.north - towerNorth, aircraft.east - towerEast));
      boolean goesNorth = Math.cos(aircraft.heading) > 0.0;
      descends = goesNorth && Math.abs(aircraft.east) < 300.0 && aircraft.north > -1000.0;
    }

    assertThat(descends).isTrue();
    assertThat(nearestM).isGreaterThan(150.0);
    assertThat(Math.abs(aircraft.east)).isLessThan(50.0);
    assertThat(Math.abs(Math.toDegrees(Leg.wrapped(aircraft.heading)))).isLessThan(10.0);
  }

  @Tag("long")
  @ParameterizedTest
  @ValueSource(doubles = 0.0)
  void landing_towerAtTheEntry_isNotTouchedOnTheWayToTheLine(double towerEast) {
    landing_towerBesideOrAtTheEntry_isNotTouchedOnTheWayToTheLine(towerEast);
  }

  /** A cylinder stands under the level line, but higher than the slope above its place. */
  private static Cylinder onTheFinal() {
    Cylinder tower = new Cylinder().radius(20.0).height(80.0);
    tower.uid("tower").objectType("tower").referenceFrame(ReferenceFrame.LOCAL_NED);
    tower.x(-500.0).y(0.0).z(-40.0);
    return tower;
  }

  private double nearestOnTheWayDownM(Landing landing, Cylinder tower) {
    kit.with("VERTICAL CLEARANCE", 30.0).with("LOITER RADIUS", 800.0);
    start("AIR");
    landing.uid("1").referenceFrame(ReferenceFrame.LOCAL_NED);
    goals(landing.x(0.0).y(0.0).z(0.0).horizontalThreshold(30.0));
    aircraft.north = -5000.0;
    aircraft.altitude = 60.0;
    double nearestM = Double.POSITIVE_INFINITY;
    boolean isDown = false;
    while (kit.nowS() < 600.0 && !isDown && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(tower)));
      kit.publish(
          Channels.STATE,
          aircraft.state().z(-aircraft.altitude).fluidxDot(50.0)); // wind from the north
      aircraft.step(0.1, kit.latest(Channels.NAVIGATION));
      kit.advance(0.1);
      if (aircraft.altitude < tower.height()) {
        nearestM =
            Math.min(nearestM, Math.hypot(aircraft.north - tower.x(), aircraft.east - tower.y()));
      }
      isDown = Math.hypot(aircraft.north, aircraft.east) < 100.0 && aircraft.altitude < 15.0;
    }
    return isDown ? nearestM : Double.NaN;
  }

  @Test
  void landing_towerOnTheSlopeAndDirectionFree_landsInAnotherDirection() {
    double nearestM =
        nearestOnTheWayDownM(new Landing().approach(1000.0).slope(0.06), onTheFinal());

    assertThat(nearestM).isGreaterThan(20.0 + 5.5);
    assertThat(logged("an obstacle blocks the descent; landing in another direction")).isPositive();
  }

  @Test
  void landing_towerOnTheSlopeOfTheOnlyDirection_isGivenUp() {
    Landing landing = new Landing().approach(1000.0).slope(0.06);
    landing.psi(0.0);

    assertThat(nearestOnTheWayDownM(landing, onTheFinal())).isNaN();
    GoalInformation report = kit.latest(Channels.GOAL_REPORTS).orElseThrow();
    assertThat(report.completed()).isFalse();
    assertThat(report.reason().orElseThrow()).contains("an obstacle blocks the descent");
  }

  @Test
  void landing_lowTowerBelowTheSlope_isFlownOver() {
    Landing landing = new Landing().approach(1000.0).slope(0.06);
    landing.psi(0.0);
    Cylinder low = onTheFinal().height(8.0);
    low.z(-4.0);

    assertThat(nearestOnTheWayDownM(landing, low)).isNotNaN();
    assertThat(logged("an obstacle")).isZero();
  }

  /** Traffic crosses the line of the approach as the aircraft comes there, level or descending. */
  @ParameterizedTest
  @ValueSource(doubles = {-2000.0, -600.0})
  void landing_trafficCrossesTheApproach_breaksOffAndComesAgain(double crossesAtNorth) {
    kit.with("TRAFFIC CLEARANCE", 60.0).with("TRAFFIC HORIZON", 25.0);
    kit.with("LOITER RADIUS", 800.0).with("VERTICAL CLEARANCE", 300.0);
    start("AIR");
    Waypoint landing = new Landing().approach(1000.0).slope(0.05);
    landing.uid("1").referenceFrame(ReferenceFrame.LOCAL_NED);
    goals(landing.x(0.0).y(0.0).z(0.0).psi(0.0).horizontalThreshold(30.0));
    aircraft.north = -6000.0;
    aircraft.altitude = 50.0;
    double meetsS = (crossesAtNorth - aircraft.north) / 46.0;
    double nearestM = Double.POSITIVE_INFINITY;
    double touchesS = Double.NaN;
    while (kit.nowS() < 900.0 && Double.isNaN(touchesS)) {
      double east = 40.0 * (kit.nowS() - meetsS);
      MovingSphere traffic =
          new MovingSphere()
              .timeStep(30.0)
              .trajectory(List.of(Point.of(crossesAtNorth, east + 1200.0, -40.0)));
      traffic
          .radius(10.0)
          .uid("traffic")
          .objectType("aircraft")
          .referenceFrame(ReferenceFrame.LOCAL_NED);
      traffic.x(crossesAtNorth).y(east).z(-40.0);
      kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(traffic)));
      kit.publish(Channels.STATE, aircraft.state().z(-aircraft.altitude));
      aircraft.step(0.1, kit.latest(Channels.NAVIGATION));
      kit.advance(0.1);
      nearestM =
          Math.min(nearestM, Math.hypot(aircraft.north - crossesAtNorth, aircraft.east - east));
      boolean isDown = Math.abs(aircraft.north) < 100.0 && aircraft.altitude < 15.0;
      touchesS = isDown ? kit.nowS() : touchesS;
    }

    assertThat(logged("the approach is obstructed: trying again")).isPositive();
    assertThat(nearestM).isGreaterThan(70.0);
    assertThat(touchesS).isNotNaN();
    assertThat(Math.abs(aircraft.east)).isLessThan(20.0);
  }

  /** It comes from beyond the position, along the line: far behind the start of the descent. */
  @Test
  void landing_outAndBackAlongTheLine_fliesItsFirstApproach() {
    kit.with("LOITER RADIUS", 800.0);
    start("AIR");
    Waypoint landing = new Landing().approach(1000.0).slope(0.05);
    landing.uid("1").referenceFrame(ReferenceFrame.LOCAL_NED);
    goals(landing.x(0.0).y(0.0).z(0.0).psi(0.0).horizontalThreshold(30.0));
    aircraft.north = 1500.0;
    aircraft.altitude = 55.0;
    boolean isDown = false;
    while (kit.nowS() < 600.0 && !isDown && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      kit.publish(Channels.OBJECTS, new ObjectList());
      kit.publish(Channels.STATE, aircraft.state().z(-aircraft.altitude));
      aircraft.step(0.1, kit.latest(Channels.NAVIGATION));
      kit.advance(0.1);
      isDown = Math.abs(aircraft.north) < 100.0 && aircraft.altitude < 15.0;
    }

    assertThat(logged("trying again")).isZero();
    assertThat(isDown).isTrue();
  }

  /** Traffic ahead on the line goes away after a while: one circle later the approach is free. */
  @Test
  void landing_brokenOffOnTheLine_leavesTheLineBeforeItJoinsAgain() {
    kit.with("TRAFFIC CLEARANCE", 60.0).with("TRAFFIC HORIZON", 25.0);
    kit.with("LOITER RADIUS", 800.0).with("VERTICAL CLEARANCE", 300.0);
    start("AIR");
    Waypoint landing = new Landing().approach(1000.0).slope(0.05);
    landing.uid("1").referenceFrame(ReferenceFrame.LOCAL_NED);
    goals(landing.x(0.0).y(0.0).z(0.0).psi(0.0).horizontalThreshold(30.0));
    aircraft.north = -6000.0;
    aircraft.altitude = 50.0;
    boolean isDown = false;
    while (kit.nowS() < 600.0 && !isDown && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      double north = -1500.0 + 10.0 * (kit.nowS() - 76.0); // as it comes to the line
      MovingSphere traffic =
          new MovingSphere()
              .timeStep(30.0)
              .trajectory(List.of(Point.of(north + 300.0, 0.0, -50.0)));
      traffic
          .radius(10.0)
          .uid("traffic")
          .objectType("aircraft")
          .referenceFrame(ReferenceFrame.LOCAL_NED);
      traffic.x(north).y(0.0).z(-50.0);
      boolean isThere = kit.nowS() < 110.0;
      kit.publish(
          Channels.OBJECTS,
          isThere ? new ObjectList().objects(List.of(traffic)) : new ObjectList());
      kit.publish(Channels.STATE, aircraft.state().z(-aircraft.altitude));
      aircraft.step(0.1, kit.latest(Channels.NAVIGATION));
      kit.advance(0.1);
      isDown = Math.abs(aircraft.north) < 100.0 && aircraft.altitude < 15.0;
    }

    assertThat(logged("the approach is obstructed: trying again")).isEqualTo(1);
    assertThat(isDown).isTrue();
    assertThat(Math.abs(aircraft.east)).isLessThan(20.0);
  }
}
