package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.PayloadDrop;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.goal.Waypoint;

/** Aircraft before a hill that TERRAIN shows, on the leg to a goal in the north. */
class HighGroundTest extends PlannedVehicle {
  private static final double STEP_S = 0.1;
  private static final double HILL_NORTH_M = 3000.0; // of the hill that the aeroplane meets
  private static final double HILL_M = 300.0; // its height
  private static final double SMALL = 0.04; // scale of the hill that the multirotor meets

  @TempDir Path folder;
  private Path map;
  private double scale = 1.0;
  private double lowestM = Double.POSITIVE_INFINITY; // above the ground
  private TestVehicle aircraft;

  /** Obeys at once. */
  private static final class Multirotor extends TestVehicle {
    @Override
    void step(double dtS, Optional<NavigationPoint> point) {
      if (point.isEmpty()) {
        return;
      }
      Point ned = new Attitude(0.0, 0.0, heading).nedOf(point.get().point());
      double away = Math.max(1.0, Math.hypot(ned.x(), ned.y()));
      double share = Math.min(3.0, point.get().speed().orElse(3.0)) / away * dtS;
      north += share * ned.x();
      east += share * ned.y();
      altitude -= Math.max(-2.0 * dtS, Math.min(2.0 * dtS, ned.z()));
    }
  }

  @BeforeEach
  void name() {
    map = folder.resolve("ground.asc");
  }

  /** A hill a little east of the leg. */
  private double groundM(double north, double east) {
    double fromHill = Math.hypot(north - scale * HILL_NORTH_M, east - scale * 60.0);
    return scale * HILL_M * Math.exp(-Math.pow(fromHill / (scale * 400.0), 2.0));
  }

  private void writeMap() throws IOException {
    int cells = 200;
    double cellDeg = 0.0008 * scale;
    double west = TestVehicle.ORIGIN.longitudeDeg() - 0.5 * cells * cellDeg;
    double south = TestVehicle.ORIGIN.latitudeDeg() - 0.3 * cells * cellDeg;
    StringBuilder text = new StringBuilder("ncols " + cells + "\nnrows " + cells + "\n");
    text.append("xllcenter " + west + "\nyllcenter " + south + "\ncellsize " + cellDeg + "\n");
    for (int row = cells - 1; row >= 0; row--) {
      for (int column = 0; column < cells; column++) {
        Geodetic place = new Geodetic(west + column * cellDeg, south + row * cellDeg, 0.0);
        Point ned = TestVehicle.ORIGIN.nedOf(place);
        text.append(String.format(Locale.ROOT, "%.2f ", groundM(ned.x(), ned.y())));
      }
      text.append('\n');
    }
    Files.writeString(map, text);
  }

  private void startAeroplane(double altitudeM) throws IOException {
    writeMap();
    kit.with("LOOK AHEAD", 150.0).with("LOOK AHEAD TIME", 3.0).with("TURN ACCELERATION", 4.2);
    kit.with("TURN LAG", 0.7).with("VEHICLE WIDTH", 11.0).with("CLEARANCE", 30.0);
    kit.with("INFLATION", 100.0).with("PLANNING CELL", 25.0).with("PLANNING SPAN", 8000.0);
    kit.with("PLANNED SPEED", 46.0).with("MIN SPEED", 40.0).with("MAX SPEED", 60.0);
    kit.with("VERTICAL CLEARANCE", 50.0).with("EVASION CLIMB", 3.0).with("LOITER RADIUS", 600.0);
    kit.with("PLANNER", "AIR").with("TERRAIN", map.toString()).start(PathPlanner::new);
    aircraft = new TestAircraft(0.0, 0.0, altitudeM, 0.0);
  }

  private void startMultirotor(double altitudeM) throws IOException {
    scale = SMALL;
    writeMap();
    kit.with("PLANNER", "GRID").with("VERTICAL CLEARANCE", 3.0).with("EVASION CLIMB", 2.0);
    kit.with("CLEARANCE", 2.0).with("INFLATION", 4.0).with("PLANNING CELL", 1.0);
    kit.with("PLANNING SPAN", 300.0).with("LOOK AHEAD", 6.0).with("PLANNED SPEED", 3.0);
    kit.with("GIVE UP AFTER", 10.0).with("TERRAIN", map.toString()).start(PathPlanner::new);
    aircraft = new Multirotor();
    aircraft.altitude = altitudeM;
  }

  private <G extends Waypoint> G at(G goal, double north, double altitudeM) {
    Geodetic place = TestVehicle.ORIGIN.fromNed(Point.of(north, 0.0, 0.0));
    goal.uid("1").referenceFrame(ReferenceFrame.GLOBAL);
    goal.x(place.longitudeDeg()).y(place.latitudeDeg()).z(altitudeM);
    return goal;
  }

  private Waypoint levelTo(double thresholdM, double north) {
    Geodetic place = TestVehicle.ORIGIN.fromNed(Point.of(north, 0.0, 0.0));
    Waypoint goal = new Waypoint().horizontalThreshold(thresholdM);
    goal.uid("1").referenceFrame(ReferenceFrame.GLOBAL);
    return goal.x(place.longitudeDeg()).y(place.latitudeDeg());
  }

  private GoalInformation fly(double limitS) {
    return fly("1", limitS);
  }

  private GoalInformation fly(String goal, double limitS) {
    while (kit.nowS() < limitS && !isReported(goal)) {
      step();
    }
    return kit.latest(Channels.GOAL_REPORTS).orElseThrow();
  }

  private void step() {
    kit.publish(Channels.OBJECTS, new ObjectList()); // an empty sky
    kit.publish(Channels.STATE, aircraft.state());
    aircraft.step(STEP_S, kit.latest(Channels.NAVIGATION));
    lowestM = Math.min(lowestM, aircraft.altitude - groundM(aircraft.north, aircraft.east));
    kit.advance(STEP_S);
  }

  private boolean isReported(String goal) {
    return kit.latest(Channels.GOAL_REPORTS)
        .filter(report -> report.uid().equals(goal))
        .isPresent();
  }

  @ParameterizedTest
  @CsvSource({"150, 150", "400, 120", "120, 160"})
  void waypoint_aeroplaneBeforeAHill_fliesAroundIt(double fromM, double toM) throws IOException {
    startAeroplane(fromM);
    goals(at(new Waypoint().horizontalThreshold(100.0), 6000.0, toM));

    assertThat(fly(250.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(50.0);
  }

  /** As on the way home after a failsafe RETURN. */
  @Test
  void waypoint_aeroplaneWithoutAltitudeBeforeAHill_fliesAroundItAtItsOwn() throws IOException {
    startAeroplane(150.0);
    goals(levelTo(100.0, 6000.0));

    assertThat(fly(250.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(50.0);
    assertThat(aircraft.altitude).isCloseTo(150.0, within(1.0));
  }

  /** As on the way home from below it. */
  @Test
  void waypoint_aeroplaneWithoutAltitudeOnTheHill_climbsToItsClearance() throws IOException {
    startAeroplane(150.0);
    goals(levelTo(100.0, HILL_NORTH_M));

    assertThat(fly(400.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(49.0);
    assertThat(aircraft.altitude).isGreaterThan(340.0);
  }

  @Test
  void waypoint_multirotorWithoutAltitudeBeforeAHill_fliesAroundItAtItsOwn() throws IOException {
    startMultirotor(6.0);
    goals(levelTo(2.0, 240.0));

    assertThat(fly(150.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(3.0);
    assertThat(aircraft.altitude).isCloseTo(6.0, within(0.5));
  }

  /** It climbs as fast as EVASION CLIMB on the way to the hill. */
  @Test
  void waypoint_climbOverTheHill_isFlownStraight() throws IOException {
    startAeroplane(300.0);
    goals(at(new Waypoint().horizontalThreshold(100.0), 6000.0, 450.0));

    assertThat(fly(135.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(50.0);
  }

  @Test
  void waypoint_inTheHill_isGivenUpAtOnce() throws IOException {
    startAeroplane(150.0);
    goals(at(new Waypoint().horizontalThreshold(100.0), HILL_NORTH_M, 150.0));

    assertThat(fly(1.0).abandoned()).isTrue();
    assertThat(logged("the ground at the goal is 14")).isPositive();
  }

  @Test
  void station_circleThroughTheHill_isGivenUpAtOnce() throws IOException {
    startAeroplane(150.0);
    goals(at(new Station().turns(1.0).horizontalThreshold(50.0), HILL_NORTH_M - 600.0, 150.0));

    assertThat(fly(1.0).abandoned()).isTrue();
    assertThat(logged("the ground is too high along 80 degrees of the circle")).isPositive();
  }

  private void hold(double untilS) {
    while (kit.nowS() < untilS) {
      step();
    }
  }

  @ParameterizedTest
  @CsvSource({"2000", "2150", "2300"})
  void pause_beforeTheHill_circlesWhereThereIsNone(double north) throws IOException {
    startAeroplane(150.0);
    aircraft = new TestAircraft(north, 0.0, 150.0, 0.0);
    Waypoint goal = at(new Waypoint().horizontalThreshold(100.0), 6000.0, 150.0);
    kit.publish(
        Channels.GOALS, new GoalList().goals(List.of(goal)).paused(true).upcoming(List.of()));
    hold(200.0);

    assertThat(lowestM).isGreaterThan(40.0);
  }

  /** As in a descent to a field above the take-off point. */
  @Test
  void pause_lowAboveTheGround_climbsToItsClearance() throws IOException {
    startAeroplane(150.0);
    aircraft = new TestAircraft(0.0, -3000.0, 12.0, 0.0);
    Waypoint goal = at(new Waypoint().horizontalThreshold(100.0), 6000.0, 150.0);
    kit.publish(
        Channels.GOALS, new GoalList().goals(List.of(goal)).paused(true).upcoming(List.of()));
    hold(100.0);

    assertThat(lowestM).isGreaterThan(11.0);
    assertThat(aircraft.altitude).isGreaterThan(50.0);
  }

  @Test
  void atEnd_goalBesideTheHill_circlesAboveIt() throws IOException {
    kit.with("AT END", "HOLD");
    startAeroplane(150.0);
    aircraft = new TestAircraft(HILL_NORTH_M - 700.0, -2500.0, 150.0, 0.5 * Math.PI);
    goals(at(new Waypoint().horizontalThreshold(100.0), HILL_NORTH_M - 700.0, 150.0));
    assertThat(fly(100.0).completed()).isTrue();
    goals();
    hold(400.0);

    assertThat(lowestM).isGreaterThan(40.0);
    assertThat(aircraft.altitude).isCloseTo(350.0, within(2.0));
  }

  @Test
  void station_circleBesideTheHill_isFlown() throws IOException {
    startAeroplane(150.0);
    goals(at(new Station().turns(0.5).horizontalThreshold(50.0), HILL_NORTH_M - 1200.0, 150.0));

    assertThat(fly(200.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(40.0);
  }

  /** Each pass is too high, and the way straight on leads into the hill. */
  @ParameterizedTest
  @CsvSource({"1600", "2000", "2300"})
  void payloadDrop_passesBeforeTheHill_areRepeatedFromWhereThereIsRoom(double north)
      throws IOException {
    startAeroplane(150.0);
    aircraft =
        new TestAircraft(0.0, 0.0, 150.0, 0.0) {
          @Override
          void step(double dtS, Optional<NavigationPoint> point) {
            super.step(dtS, point);
            altitude = 150.0;
          }
        };
    ActuatorAnnouncement release = new ActuatorAnnouncement().minimum(0.0).maximum(100.0);
    kit.publish(Channels.ACTUATORS, release.actuatorName("BOTTLE").percentage(0.0));
    goals(at(new PayloadDrop().payload("BOTTLE").height(120.0).horizontalThreshold(9.0), north, 5));

    assertThat(fly(600.0).reason().orElseThrow()).isEqualTo("given up: was 25 m too high");
    assertThat(lowestM).isGreaterThan(40.0);
  }

  @ParameterizedTest
  @CsvSource({"6, 6", "9, 6"})
  void waypoint_multirotorBeforeAHill_fliesAroundIt(double fromM, double toM) throws IOException {
    startMultirotor(fromM);
    goals(at(new Waypoint().horizontalThreshold(2.0), 240.0, toM));

    assertThat(fly(150.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(3.0);
  }

  @Test
  void station_multirotorBeforeAHill_fliesAroundIt() throws IOException {
    startMultirotor(6.0);
    goals(at(new Station().duration(1.0).horizontalThreshold(2.0), 240.0, 6.0));

    assertThat(fly(150.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(3.0);
  }

  /** The line from one to the other leads through the hill. */
  @Test
  void station_multirotorLeavesAnotherBeforeTheHill_keepsToItsRoute() throws IOException {
    startMultirotor(4.0);
    goals(at(new Station().duration(1.0).horizontalThreshold(2.0), 60.0, 4.0));
    fly(60.0);
    Waypoint beyond = at(new Station().duration(1.0).horizontalThreshold(2.0), 240.0, 6.0);
    beyond.uid("2");
    goals(beyond);

    assertThat(fly("2", 250.0).completed()).isTrue();
    assertThat(lowestM).isGreaterThan(3.0);
  }
}
