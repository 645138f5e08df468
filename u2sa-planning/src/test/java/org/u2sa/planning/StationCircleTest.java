package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.shape.Sphere;
import org.u2sa.planning.guidance.Leg;

/** Stations of an aircraft at 46 m/s, 3 km north of it on a local plane. */
class StationCircleTest extends PlannedVehicle {
  private static final double NORTH_M = 3000.0;
  private static final double RADIUS_M = 800.0;

  private final TestAircraft aircraft = new TestAircraft(0.0, 0.0, 500.0, 0.0);
  private final List<double[]> track = new ArrayList<>(); // from the station: north, east
  private final List<Sphere> towers = new ArrayList<>();

  private PathPlanner start(String planner) {
    aircraft.onEarth = false;
    kit.with("LOOK AHEAD", 150.0).with("LOOK AHEAD TIME", 3.0).with("TURN ACCELERATION", 4.2);
    kit.with("LOITER RADIUS", RADIUS_M).with("TURN LAG", 0.7).with("PLANNER", planner);
    kit.with("VEHICLE WIDTH", 11.0).with("CLEARANCE", 30.0).with("INFLATION", 100.0);
    kit.with("PLANNING CELL", 25.0).with("PLANNING SPAN", 8000.0).with("STUCK AFTER", 20.0);
    kit.with("PLANNED SPEED", 46.0).with("MIN SPEED", 40.0).with("MAX SPEED", 60.0);
    return kit.start(PathPlanner::new);
  }

  private static Station station() {
    Station station = new Station();
    station.uid("S").referenceFrame(ReferenceFrame.LOCAL_NED).x(NORTH_M).y(0.0);
    station.horizontalThreshold(50.0);
    return station;
  }

  private void tower(double north, double east) {
    Sphere tower = new Sphere().radius(100.0);
    tower.uid("tower" + towers.size()).objectType("tower").referenceFrame(ReferenceFrame.LOCAL_NED);
    tower.x(NORTH_M + north).y(east).z(-500.0);
    towers.add(tower);
  }

  /** Flies until the goal is reported, or for so long. */
  private boolean fly(double limitS) {
    while (kit.nowS() < limitS && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      step();
    }
    return kit.latest(Channels.GOAL_REPORTS).filter(report -> report.completed()).isPresent();
  }

  private void step() {
    kit.publish(Channels.OBJECTS, new ObjectList().objects(List.copyOf(towers)));
    kit.publish(Channels.STATE, aircraft.state().z(-aircraft.altitude));
    aircraft.step(0.1, kit.latest(Channels.NAVIGATION));
    kit.advance(0.1);
    track.add(new double[] {aircraft.north - NORTH_M, aircraft.east});
  }

  /** Angle flown around the station while near the circle [turns], clockwise positive. */
  private double turns() {
    double turned = 0.0;
    for (int i = 1; i < track.size(); i++) {
      double[] from = track.get(i - 1);
      double[] to = track.get(i);
      if (Math.abs(Math.hypot(to[0], to[1]) - RADIUS_M) < 50.0) {
        turned += Leg.wrapped(Math.atan2(to[1], to[0]) - Math.atan2(from[1], from[0]));
      }
    }
    return turned / (2.0 * Math.PI);
  }

  private List<Double> offs() {
    return track.stream()
        .map(each -> Math.abs(Math.hypot(each[0], each[1]) - RADIUS_M))
        .collect(Collectors.toList());
  }

  @ParameterizedTest
  @ValueSource(doubles = {RADIUS_M, -RADIUS_M})
  void plan_turnsWithRadius_fliesThemInItsDirectionOnTheCircle(double radiusM) {
    start("NONE");
    goals(station().turns(2.0).radius(radiusM));

    assertThat(fly(600.0)).isTrue();
    assertThat(turns()).isCloseTo(Math.signum(radiusM) * 2.0, within(0.1));
    List<Double> last = offs().subList(offs().size() / 2, offs().size());
    assertThat(last).allMatch(off -> off < 10.0);
  }

  @Test
  void plan_radiusChangedOnTheCircle_fliesTheNewOne() {
    start("NONE");
    goals(station());
    fly(150.0);
    goals(station().turns(1.0).radius(500.0));

    assertThat(fly(600.0)).isTrue();
    assertThat(Math.hypot(aircraft.north - NORTH_M, aircraft.east)).isCloseTo(500.0, within(20.0));
  }

  /** A boat at 1 m/s whose control steers straight at the point ahead. */
  private static final class StraightBoat extends TestVehicle {
    @Override
    void step(double dtS, Optional<NavigationPoint> point) {
      point.ifPresent(to -> heading += Math.atan2(-to.point().y(), to.point().x()));
      speed = 1.0;
      move(dtS);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {5.0, -8.0})
  void plan_controlThatSteersStraightAtThePoint_doesNotCutTheCircle(double radiusM) {
    StraightBoat boat = new StraightBoat();
    boat.onEarth = false;
    kit.with("LOOK AHEAD", 4.0).with("LOITER RADIUS", 8.0).with("PLANNER", "NONE");
    kit.start(PathPlanner::new);
    Station station = new Station();
    station.uid("S").referenceFrame(ReferenceFrame.LOCAL_NED).x(20.0).y(0.0);
    goals(station.turns(8.0).radius(radiusM).horizontalThreshold(2.0));
    double nearest = Double.POSITIVE_INFINITY;
    while (kit.nowS() < 600.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      kit.publish(Channels.STATE, boat.state().z(0.0));
      boat.step(0.1, kit.latest(Channels.NAVIGATION));
      kit.advance(0.1);
      double away = Math.hypot(boat.north - 20.0, boat.east);
      nearest = kit.nowS() > 60.0 ? Math.min(nearest, away) : nearest;
    }
    assertThat(nearest).isBetween(0.9 * Math.abs(radiusM), 1.1 * Math.abs(radiusM));
  }

  @Test
  void plan_durationZeroWithAltitude_endsWhenItIsReached() {
    start("NONE");
    Station climb = (Station) station().duration(0.0).z(-800.0);
    goals(climb);

    assertThat(fly(600.0)).isTrue();
    assertThat(aircraft.altitude).isBetween(796.0, 801.0);
    assertThat(offs().get(offs().size() - 1)).isLessThan(15.0);
  }

  @Test
  void plan_towardsNext_leavesOnTheCourseToTheNextGoal() {
    start("NONE");
    Waypoint next = waypoint("N", NORTH_M + 2000.0, 3000.0);
    kit.publish(
        Channels.GOALS,
        new GoalList()
            .goals(List.of(station().duration(10.0).towardsNext(true)))
            .upcoming(List.of(next)));

    assertThat(fly(600.0)).isTrue();
    double wanted = Math.atan2(3000.0 - aircraft.east, NORTH_M + 2000.0 - aircraft.north);
    assertThat(Math.toDegrees(Leg.wrapped(aircraft.heading - wanted))).isCloseTo(0.0, within(13.0));
  }

  @Test
  void plan_withoutPlace_circlesWhereItBegan() {
    start("NONE");
    aircraft.north = NORTH_M;
    Station here = new Station();
    here.uid("S").horizontalThreshold(50.0);
    goals(here.duration(300.0));

    assertThat(fly(600.0)).isTrue();
    assertThat(offs().subList(1000, offs().size())).allMatch(off -> off < 15.0);
  }

  @Test
  void takeOver_onTheCircle_turnsGoOn() {
    PathPlanner planner = start("NONE");
    goals(station().turns(2.0).radius(RADIUS_M));
    fly(200.0);
    kit.swap(planner, PathPlanner::new);

    assertThat(fly(600.0)).isTrue();
    assertThat(turns()).isCloseTo(2.0, within(0.1));
  }

  @Test
  void plan_neitherDurationNorTurns_circlesOn() {
    start("NONE");
    goals(station());

    assertThat(fly(600.0)).isFalse();
    assertThat(Math.abs(turns())).isGreaterThan(4.0);
  }

  @Test
  void plan_towersOnTheCircle_fliesAroundThemAndItsTurns() {
    start("AIR");
    tower(0.0, RADIUS_M - 20.0);
    tower(60.0, -RADIUS_M - 50.0);
    goals(station().turns(2.0));

    assertThat(fly(900.0)).isTrue();
    assertThat(Math.abs(turns())).isGreaterThan(0.8); // the rest was flown beside the circle
    assertKeepsAwayFromTowers();
  }

  private void pause() {
    kit.publish(
        Channels.GOALS, new GoalList().goals(List.of(station())).paused(true).upcoming(List.of()));
  }

  private void assertKeepsAwayFromTowers() {
    for (Sphere tower : towers) {
      assertThat(track)
          .allMatch(at -> Math.hypot(at[0] - tower.x() + NORTH_M, at[1] - tower.y()) > 110.0);
    }
  }

  /** The tower stands on the circle about the vehicle's position. */
  @ParameterizedTest
  @ValueSource(doubles = {0.0, 90.0, 180.0, 270.0})
  void pause_towerOnTheCircle_circlesBesideThePosition(double bearingDeg) {
    start("AIR");
    double bearing = Math.toRadians(bearingDeg);
    tower(RADIUS_M * Math.cos(bearing) - NORTH_M, RADIUS_M * Math.sin(bearing));
    pause();

    assertThat(fly(400.0)).isFalse();
    assertKeepsAwayFromTowers();
    assertThat(track).allMatch(at -> Math.hypot(at[0] + NORTH_M, at[1]) < 2.2 * RADIUS_M);
  }

  @Test
  void pause_towersOnAllCircles_fliesAroundThem() {
    start("AIR");
    tower(RADIUS_M - NORTH_M, 0.0);
    tower(-NORTH_M, 2.0 * RADIUS_M);
    tower(-NORTH_M, -2.0 * RADIUS_M);
    pause();

    assertThat(fly(600.0)).isFalse();
    assertKeepsAwayFromTowers();
    assertThat(track).allMatch(at -> Math.hypot(at[0] + NORTH_M, at[1]) < 3.5 * RADIUS_M);
  }

  @Test
  void atEnd_towerOnTheCircleAboutTheLastGoal_fliesAroundIt() {
    kit.with("AT END", "HOLD");
    start("AIR");
    tower(0.0, RADIUS_M - 20.0);
    tower(60.0, -RADIUS_M - 50.0);
    goals(waypoint("W", NORTH_M, 0.0).horizontalThreshold(50.0));
    assertThat(fly(200.0)).isTrue();
    goals();
    while (kit.nowS() < 700.0) {
      step();
    }
    assertKeepsAwayFromTowers();
    assertThat(offs().subList(2000, offs().size())).allMatch(off -> off < 1.5 * RADIUS_M);
    assertThat(Math.abs(turns())).isGreaterThan(1.0);
  }

  @Test
  void takeOver_holding_circlesOnAboutTheSamePlace() {
    PathPlanner planner = start("AIR");
    aircraft.north = NORTH_M;
    pause();
    fly(103.0);
    kit.swap(planner, PathPlanner::new);
    fly(300.0);

    assertThat(offs().subList(1000, offs().size())).allMatch(off -> off < 15.0);
  }

  /** The part between the towers is too short to join the circle on it. */
  @ParameterizedTest
  @CsvSource({"800, 45", "800, 60", "-800, 45", "-800, 60"})
  void plan_twoTowersOnTheCircle_itIsFlownOrGivenUp(double radiusM, double apartDeg) {
    start("AIR");
    tower(0.0, RADIUS_M);
    double bearing = Math.toRadians(90.0 - apartDeg);
    tower(RADIUS_M * Math.cos(bearing), RADIUS_M * Math.sin(bearing));
    goals(station().turns(1.0).radius(radiusM));

    fly(1500.0);
    assertThat(kit.latest(Channels.GOAL_REPORTS)).isPresent();
  }
}
