package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Landing;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.safety.FenceState;
import org.u2sa.messages.shape.Cylinder;
import org.u2sa.messages.shape.MovingSphere;
import org.u2sa.messages.shape.Polygon;
import org.u2sa.planning.guidance.Leg;

/** A multirotor that hovers, and traffic that comes to where it is. */
class HoverTrafficTest extends PlannedVehicle {
  private static final double STEP_S = 0.25;
  private static final double TURN_RAD = Math.toRadians(11.0); // in a step
  private static final double UP_M = 60.0;
  private static final double SEPARATION_M = 20.0;
  private static final double NEAREST_M = 12.0; // from the middle of the separation, at least
  private static final double COMES_S = 30.0; // when the traffic is at the place
  private static final double END_S = 65.0;
  private static final String SAID = "traffic comes to where it hovers";

  private Point at = Point.of(0.0, 0.0, -UP_M);
  private Point velocity = Point.ORIGIN;
  private Point held = at; // place at which it hovers
  private double nearestM = Double.POSITIVE_INFINITY;
  private double farthestM; // from the place
  private double mostEastM;
  private double headingRad;
  private double stopsS = Double.POSITIVE_INFINITY; // when the traffic stops
  private double goneS = Double.POSITIVE_INFINITY; // when it is seen no more
  private final List<ObjectDescription> objects = new ArrayList<>(); // that stand
  private final List<Double> beside = new ArrayList<>(); // distances from them [m]

  private void start(double clearanceM) {
    start(clearanceM, 2.0);
  }

  private void start(double clearanceM, double climbMps) {
    kit.with("PLANNER", "GRID").with("VERTICAL CLEARANCE", clearanceM);
    kit.with("EVASION CLIMB", climbMps);
    kit.with("TRAFFIC CLEARANCE", 5.0).with("TRAFFIC HORIZON", 20.0).with("CLEARANCE", 3.0);
    kit.with("INFLATION", 6.0).with("PLANNING CELL", 1.0).with("PLANNING SPAN", 200.0);
    kit.with("LOOK AHEAD", 8.0).with("PLANNED SPEED", 8.0).with("REACTION TIME", 0.5);
    kit.with("PLANNED ACCELERATION", 2.0).with("PLANNED BRAKING", 2.0);
    kit.start(PathPlanner::new);
  }

  /** Flies on; the traffic passes the place at {@link #COMES_S}. */
  private void step(Point mps) {
    kit.advance(STEP_S);
    Point other = held.plus(mps.times(Math.min(kit.nowS(), stopsS) - COMES_S));
    MovingSphere drone = new MovingSphere().radius(SEPARATION_M);
    drone.uid("drone").objectType("drone").referenceFrame(ReferenceFrame.LOCAL_NED);
    drone.x(other.x()).y(other.y()).z(other.z());
    drone.motion().velocity(kit.nowS() < stopsS ? mps : Point.ORIGIN);
    List<ObjectDescription> seen = new ArrayList<>(objects);
    if (kit.nowS() < goneS) {
      seen.add(drone);
    }
    kit.publish(Channels.OBJECTS, new ObjectList().objects(seen));
    kit.publish(
        Channels.STATE,
        state(at.x(), at.y(), headingRad)
            .z(at.z())
            .xDot(velocity.x())
            .yDot(velocity.y())
            .zDot(velocity.z())
            .phi(0.0)
            .theta(0.0));
    velocity = newest().map(this::velocity).orElse(Point.ORIGIN);
    at = at.plus(velocity.times(STEP_S));
    nearestM = Math.min(nearestM, at.minus(other).distance());
    farthestM = Math.max(farthestM, at.minus(held).distance());
    mostEastM = Math.max(mostEastM, at.y());
    objects.forEach(
        each -> beside.add(Math.hypot(at.x() - each.center().x(), at.y() - each.center().y())));
  }

  private Optional<NavigationPoint> newest() {
    return kit.latest(Channels.NAVIGATION)
        .filter(point -> point.timestamp().orElse(0L) == kit.clock().micros());
  }

  private Point velocity(NavigationPoint point) {
    Point ned = new Attitude(0.0, 0.0, headingRad).nedOf(point.point());
    double awayM = Math.hypot(ned.x(), ned.y());
    double turnRad = awayM < 1.0 ? 0.0 : Leg.wrapped(Math.atan2(ned.y(), ned.x()) - headingRad);
    headingRad += Math.max(-TURN_RAD, Math.min(TURN_RAD, turnRad));
    double mps = Math.min(point.speed().orElse(3.0), awayM) / Math.max(0.01, awayM);
    return Point.of(mps * ned.x(), mps * ned.y(), Math.max(-2.0, Math.min(2.0, ned.z())));
  }

  private void hover(Point mps) {
    while (kit.nowS() < END_S) {
      step(mps);
    }
  }

  private void lead(Point mps, double seconds) {
    goals(waypoint("1", 500.0, 0.0).z(-UP_M));
    while (kit.nowS() < seconds) {
      step(mps);
    }
    held = at;
    nearestM = Double.POSITIVE_INFINITY;
    farthestM = 0.0;
  }

  private static GoalInformation station() {
    Station station = new Station();
    station.horizontalThreshold(2.0).x(0.0).y(0.0).z(-UP_M);
    return station.uid("st").referenceFrame(ReferenceFrame.LOCAL_NED);
  }

  private void pause() {
    kit.publish(
        Channels.GOALS,
        new GoalList().goals(List.of(waypoint("1", 500.0, 0.0).z(-UP_M))).paused(true));
  }

  private void assertEvadedOnceAndReturned() {
    assertThat(nearestM).isGreaterThan(NEAREST_M);
    assertThat(at.minus(held).distance()).isLessThan(2.5);
    assertThat(logged(SAID)).isEqualTo(1);
  }

  @ParameterizedTest
  @CsvSource({"0, 5, 0", "5, 0, 0", "0, 0, -1.5", "0, 0, 1.5"})
  void station_trafficComes_evadesAndReturns(double north, double east, double down) {
    start(5.0);
    goals(station());
    hover(Point.of(north, east, down));
    assertEvadedOnceAndReturned();
  }

  @ParameterizedTest
  @CsvSource({"0, 5, 30, true", "4, 1, 30.4, true", "0, 5, 30, false", "-3, 3, 29.5, false"})
  void hover_trafficStopsThere_waitsBesideIt(
      double north, double east, double stops, boolean atStation) {
    start(5.0);
    stopsS = stops;
    Point mps = Point.of(north, east, 0.0);
    if (atStation) {
      goals(station());
    } else {
      lead(Point.ORIGIN, 3.0);
      pause();
    }
    hover(mps);
    while (kit.nowS() < 2.0 * END_S) {
      step(mps);
    }
    assertThat(nearestM).isGreaterThan(NEAREST_M);
    assertThat(logged(": waiting") + logged("given up: ")).isGreaterThanOrEqualTo(1);
  }

  /** Any direction and speed, seen for as long as the horizon. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
  void pause_trafficFromAnywhere_keepsAwayAndReturns(long seed) {
    Random random = new Random(seed);
    double course = 2.0 * Math.PI * random.nextDouble();
    double mps = 1.0 + 9.0 * random.nextDouble();
    double down = 2.4 * random.nextDouble() - 1.2;
    start(5.0);
    lead(Point.of(0.0, 0.0, 0.0), 3.0);
    pause();
    hover(Point.of(mps * Math.cos(course), mps * Math.sin(course), down));
    while (kit.nowS() < 110.0) {
      step(Point.of(mps * Math.cos(course), mps * Math.sin(course), down));
    }
    assertThat(nearestM).isGreaterThan(NEAREST_M);
    assertThat(at.minus(held).distance()).isLessThan(2.5);
  }

  /** Spots behind a wall are none. */
  @ParameterizedTest
  @CsvSource({"5, 0, 2", "5, 0, 0", "-5, 0, 0", "5, 1, 0", "8, -1, 0"})
  void pause_trafficComesBetweenWalls_keepsAwayFromThem(
      double north, double east, double climbMps) {
    start(5.0, climbMps);
    for (int i = -20; i <= 20; i++) {
      wallAt(3.0 * i, 14.0);
      wallAt(3.0 * i, -14.0);
    }
    lead(Point.ORIGIN, 0.5);
    pause();
    hover(Point.of(north, east, 0.0));
    assertThat(beside).isNotEmpty().allMatch(awayM -> awayM > 2.0 + 1.0);
  }

  private void wallAt(double north, double east) {
    Cylinder part = new Cylinder().radius(2.0).height(200.0);
    part.uid("part" + objects.size()).objectType("wall").referenceFrame(ReferenceFrame.LOCAL_NED);
    part.x(north).y(east).z(-UP_M);
    objects.add(part);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.0, 1.5, 4.0})
  void landing_waitsAboveACar_evadesTrafficAlsoAboveIt(double higherM) {
    kit.with("GIVE UP AFTER", 100.0);
    start(5.0);
    objects.add(VerticalFlight.slab(0.0, 3.0));
    at = Point.of(0.0, 0.0, -15.0);
    held = Point.of(0.0, 0.0, -8.0 - higherM);
    Landing landing = new Landing();
    landing.horizontalThreshold(2.0).x(0.0).y(0.0).z(0.0);
    goals(landing.uid("l").referenceFrame(ReferenceFrame.LOCAL_NED));
    hover(Point.of(0.0, 5.0, 0.0));
    assertThat(nearestM).isGreaterThan(NEAREST_M);
    assertThat(Math.hypot(at.x(), at.y())).isLessThan(4.0);
  }

  @ParameterizedTest
  @ValueSource(strings = {"STOP", "HOLD"})
  void paused_trafficComes_evadesAndReturns(String atEnd) {
    kit.with("AT END", atEnd);
    start(5.0);
    lead(Point.of(0.0, 5.0, 0.0), 3.0);
    pause();
    hover(Point.of(0.0, 5.0, 0.0));
    assertEvadedOnceAndReturned();
  }

  @ParameterizedTest
  @ValueSource(strings = {"STOP", "HOLD"})
  void failsafeHold_trafficComes_evadesAndReturns(String atEnd) {
    kit.with("AT END", atEnd);
    start(5.0);
    lead(Point.of(0.0, 5.0, 0.0), 3.0);
    kit.publish(
        Channels.FAILSAFE, new FailsafeState().action(FailsafeAction.HOLD).causes(List.of("test")));
    hover(Point.of(0.0, 5.0, 0.0));
    assertEvadedOnceAndReturned();
  }

  @Test
  void missionOver_trafficComes_evadesAndReturns() {
    start(5.0);
    lead(Point.of(5.0, 0.0, 0.0), 3.0);
    goals();
    hover(Point.of(5.0, 0.0, 0.0));
    assertEvadedOnceAndReturned();
  }

  @Test
  void paused_trafficPassesFarAway_getsNoPoints() {
    kit.with("AT END", "STOP");
    start(5.0);
    lead(Point.of(0.0, 5.0, 0.0), 3.0);
    held = at.plus(Point.of(80.0, 0.0, 0.0));
    pause();
    hover(Point.of(0.0, 5.0, 0.0));
    assertThat(newest()).isEmpty();
    assertThat(logged(SAID)).isEqualTo(0);
  }

  @Test
  void paused_fenceOnOneSide_evadesInsideIt() {
    kit.with("AT END", "STOP");
    start(5.0);
    Polygon area = new Polygon();
    area.points(
        List.of(
            Point.of(-300.0, -300.0, 0.0),
            Point.of(300.0, -300.0, 0.0),
            Point.of(300.0, 6.0, 0.0),
            Point.of(-300.0, 6.0, 0.0)));
    area.x(0.0).y(0.0).z(0.0);
    area.uid("fence").objectType("fence").referenceFrame(ReferenceFrame.LOCAL_NED);
    kit.publish(Channels.FENCE, new FenceState().keepIn(List.of(area)).keepOut(List.of()));
    lead(Point.of(5.0, 0.0, 0.0), 3.0);
    pause();
    hover(Point.of(5.0, 0.0, 0.0));
    assertThat(nearestM).isGreaterThan(NEAREST_M);
    assertThat(mostEastM).isLessThan(6.0);
  }

  /** At its goal it would be in the way of the traffic, and beyond it even more. */
  @ParameterizedTest
  @CsvSource({"-6, 10", "-6, 12", "-6, 14", "-5, 8", "-8, 16", "6, 12"})
  void waypoint_nearAndTrafficComes_staysAwayAndIsReachedAfterwards(double eastMps, double fromS) {
    kit.with("AT END", "HOLD");
    start(5.0, 0.0);
    at = Point.of(-12.0, Math.copySign(9.0, eastMps), -UP_M);
    Point mps = Point.of(0.0, eastMps, 0.0);
    while (kit.nowS() < fromS) {
      step(mps);
    }
    velocity = Point.of(5.0, -Math.copySign(4.0, eastMps), 0.0);
    goals(waypoint("home", 0.0, 0.0).z(-UP_M).horizontalThreshold(1.0));
    hover(mps);

    assertThat(nearestM).isGreaterThan(SEPARATION_M);
    assertThat(kit.published(Channels.GOAL_REPORTS)).isNotEmpty();
    assertThat(kit.published(Channels.GOAL_REPORTS).get(0).completed()).isTrue();
  }

  private static Polygon round(double north, double east, double radiusM) {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      double angle = Math.PI * i / 6.0;
      corners.add(
          Point.of(north + radiusM * Math.cos(angle), east + radiusM * Math.sin(angle), 0.0));
    }
    Polygon area = new Polygon();
    area.points(corners).x(north).y(east).z(0.0);
    area.uid("out " + east).objectType("fence").referenceFrame(ReferenceFrame.LOCAL_NED);
    return area;
  }

  /** Hovers; returns the least distance from the areas, negative inside [m]. */
  private double leastOutsideM(List<Polygon> areas, double radiusM, Point mps) {
    double leastM = Double.POSITIVE_INFINITY;
    while (kit.nowS() < END_S) {
      step(mps);
      for (Polygon area : areas) {
        double awayM = Math.hypot(at.x() - area.center().x(), at.y() - area.center().y());
        leastM = Math.min(leastM, awayM - radiusM);
      }
    }
    return leastM;
  }

  /** From the speed of an evasion it can only stop beyond them. */
  @ParameterizedTest
  @CsvSource({"6, 18, 6", "6, 18, 9", "4, 12, 6", "10, 25, 8"})
  void paused_smallKeepOutAreasBeside_doesNotFlyThroughThem(
      double radiusM, double eastM, double mps) {
    kit.with("AT END", "STOP");
    start(5.0, 0.0);
    lead(Point.of(mps, 0.0, 0.0), 3.0);
    pause();
    List<Polygon> keepOut = List.of(round(at.x(), -eastM, radiusM), round(at.x(), eastM, radiusM));
    kit.publish(Channels.FENCE, new FenceState().keepIn(List.of()).keepOut(keepOut));

    assertThat(leastOutsideM(keepOut, radiusM, Point.of(mps, 0.0, 0.0))).isGreaterThan(0.0);
    assertThat(farthestM).as("it evades").isGreaterThan(5.0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {24.0, 26.0, 28.0, 29.0, 30.0, 31.0, 32.0})
  void paused_trafficVanishesDuringAnEvasion_returnsOutsideKeepOutAreas(double vanishesS) {
    kit.with("AT END", "STOP");
    start(5.0, 0.0);
    Point mps = Point.of(5.0, 2.0, 0.0);
    lead(mps, 3.0);
    pause();
    List<Polygon> keepOut =
        List.of(round(at.x(), -14.0, 5.0), round(at.x(), 14.0, 5.0), round(at.x() + 16, 0, 6.0));
    kit.publish(Channels.FENCE, new FenceState().keepIn(List.of()).keepOut(keepOut));
    goneS = vanishesS;

    assertThat(leastOutsideM(keepOut, 5.0, mps)).isGreaterThan(0.0);
    assertThat(at.minus(held).distance()).isLessThan(2.5);
    assertThat(logged("Exception")).isZero();
  }

  @Test
  void paused_alreadyInsideAKeepOutArea_doesNotFlyDeeper() {
    kit.with("AT END", "STOP");
    start(5.0, 0.0);
    lead(Point.of(6.0, 0.0, 0.0), 3.0);
    pause();
    List<Polygon> keepOut = List.of(round(at.x(), 11.0, 12.0));
    kit.publish(Channels.FENCE, new FenceState().keepIn(List.of()).keepOut(keepOut));

    assertThat(leastOutsideM(keepOut, 12.0, Point.of(6.0, 0.0, 0.0))).isGreaterThan(-2.5);
    assertThat(nearestM).isGreaterThan(NEAREST_M);
  }

  /** As a ground vehicle: heights do not matter. */
  @Test
  void paused_withoutVerticalClearance_stays() {
    kit.with("AT END", "STOP");
    start(0.0);
    lead(Point.of(0.0, 5.0, 0.0), 3.0);
    pause();
    hover(Point.of(0.0, 5.0, 0.0));
    assertThat(farthestM).isLessThan(1.0);
    assertThat(newest()).isEmpty();
  }

  /** Without a take-off it may have started in the air, but it was never led. */
  @Test
  void paused_neverLeftTheGround_stays() {
    start(5.0);
    pause();
    hover(Point.of(0.0, 5.0, 0.0));
    assertThat(farthestM).isLessThan(0.5);
  }
}
