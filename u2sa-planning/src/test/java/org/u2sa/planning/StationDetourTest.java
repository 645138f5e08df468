package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.PathStatus;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.shape.Circle;
import org.u2sa.planning.guidance.Leg;

/** Stations of ground vehicles and boats behind something that stands. */
class StationDetourTest extends PlannedVehicle {
  private static final double RADIUS_M = 1.0;

  private ObjectDescription pole = pole(10, 0);

  private static Circle pole(double north, double east) {
    Circle pole = new Circle().radius(RADIUS_M);
    pole.uid("pole").referenceFrame(ReferenceFrame.LOCAL_NED).x(north).y(east);
    return pole;
  }

  private static Station station() {
    Station station = new Station();
    station.uid("S").referenceFrame(ReferenceFrame.LOCAL_NED).x(20.0).y(0.0);
    station.horizontalThreshold(0.5);
    return station;
  }

  @BeforeEach
  void start() {
    kit.with("PLANNER", "GRID").with("AT END", "HOLD").start(PathPlanner::new);
  }

  private void sees(double north, double east) {
    sees(north, east, 0.0);
  }

  private void sees(double north, double east, double heading) {
    kit.advance(0.1);
    kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(pole)));
    kit.publish(Channels.STATE, state(north, east, heading));
  }

  private double nearestToThePoleM() {
    PlannedPath path = kit.latest(Channels.PLANS).orElseThrow();
    assertThat(path.status()).isEqualTo(PathStatus.FOLLOWED);
    double nearestM = Double.POSITIVE_INFINITY;
    List<Point> points = path.points();
    for (int i = 1; i < points.size(); i++) {
      Point from = points.get(i - 1);
      Point to = points.get(i);
      Leg leg = new Leg(from.x(), from.y(), to.x(), to.y());
      nearestM = Math.min(nearestM, leg.distanceM(pole.x(), pole.y()));
    }
    return nearestM;
  }

  @Test
  void station_poleOnTheWay_isGoneAround() {
    goals(station());
    sees(0, 0);

    assertThat(nearestToThePoleM()).isGreaterThan(RADIUS_M + 0.2);
  }

  @Test
  void station_poleNearIt_isGoneAroundToo() {
    pole = pole(17.5, 0);
    goals(station());
    sees(15.2, 0);

    assertThat(nearestToThePoleM()).isGreaterThan(RADIUS_M + 0.2);
  }

  @Test
  void station_poleBeforeTheStartOfItsStraightWay_isGoneAroundToThatStart() {
    goals(station().approach(5.0).psi(0.0));
    sees(0, 0);

    assertThat(nearestToThePoleM()).isGreaterThan(RADIUS_M + 0.2);
    List<Point> points = kit.latest(Channels.PLANS).orElseThrow().points();
    assertThat(points.get(points.size() - 1).x()).isCloseTo(15.0, within(0.3));
  }

  @Test
  void station_onItsStraightWay_goesOnTowardsIt() {
    pole = pole(20, 2);
    goals(station().approach(5.0).psi(0.0));
    sees(15.0, 0);
    sees(16.0, 0);

    assertThat(point().y()).isCloseTo(0.0, within(0.05));
    assertThat(point().x()).isGreaterThan(0.5);
  }

  @Test
  void station_poleStandsAtIt_theVehicleStaysWhereItIsWithinTheThreshold() {
    pole = pole(20, 0.5);
    Station station = station();
    station.horizontalThreshold(3.0);
    goals(station);
    for (int i = 0; i < 5; i++) {
      sees(18.0, 0.0);
    }

    assertThat(point().distance()).isCloseTo(0.0, within(1.0e-9));
    assertThat(kit.latest(Channels.NAVIGATION).orElseThrow().speed()).hasValue(0.0);
  }

  @Test
  void station_poleStandsAtItAndTheVehicleIsAtTheThreshold_movesInsideIt() {
    pole = pole(20, 0.5);
    Station station = station();
    station.horizontalThreshold(2.5);
    goals(station);
    for (int i = 0; i < 5; i++) {
      sees(17.6, 0.0);
    }

    assertThat(point().x()).isCloseTo(2.4 - 0.7 * 2.5, within(1.0e-6));
  }

  @Test
  void station_nothingStandsAtIt_theVehicleGoesToItsCentre() {
    Station station = station();
    station.horizontalThreshold(2.5);
    goals(station);
    sees(18.0, 0.0);

    assertThat(point().x()).isCloseTo(2.0, within(1.0e-6));
  }

  @Test
  void atEnd_poleStandsWhereItWouldHold_staysWhereItIs() {
    pole = pole(20, 0.5);
    goals(waypoint("1", 20, 0).horizontalThreshold(2.5));
    sees(16.0, 0.0);
    sees(18.0, 0.0);
    sees(18.1, 0.0);
    goals();
    sees(18.1, 0.0);

    assertThat(kit.published(Channels.GOAL_REPORTS)).as("reached").isNotEmpty();
    assertThat(point().distance()).isCloseTo(0.0, within(0.05));
  }

  private NavigationPoint navigation() {
    return kit.latest(Channels.NAVIGATION).orElseThrow();
  }

  @Test
  void station_poleOnItsStraightWay_isWaitedFor() {
    pole = pole(18.6, 0);
    goals(station().approach(5.0).psi(0.0));
    sees(15.0, 0);
    sees(16.5, 0);

    assertThat(point().distance()).isCloseTo(0.0, within(1.0e-9));
    assertThat(navigation().speed()).hasValue(0.0);
    assertThat(logged("waits: something is where it would move")).isEqualTo(1);
  }

  @Test
  void station_enteredSternFirst_isReachedWithoutTurningRound() {
    pole = pole(0, 30);
    goals(station().approach(5.0).backwards(true).psi(Math.PI));
    for (double north : new double[] {15.0, 17.0, 19.0, 19.6}) {
      sees(north, 0, Math.PI);
    }

    assertThat(point().x()).isCloseTo(-0.4, within(1.0e-6));
    assertThat(navigation().backwards()).isTrue();
  }

  @Test
  void station_poleBesideTheBow_isNoPlaceToTurn() {
    kit.publish(
        Channels.CONFIGURATION,
        new ConfigurationChange()
            .variableName("VEHICLE FRONT")
            .value("2.0")
            .serviceName("PathPlanner"));
    pole = pole(20.0, 1.8);
    goals(station().psi(Math.PI / 2.0));
    sees(20.0, 0.0);
    sees(20.0, 0.0);

    assertThat(navigation().turn()).isEmpty();
    assertThat(navigation().speed()).hasValue(0.0);
  }

  @Test
  void station_speed_isThatOfTheWayAround() {
    goals(station().speed(0.7));
    sees(0, 0);

    OptionalDouble speed = kit.latest(Channels.NAVIGATION).orElseThrow().speed();
    assertThat(speed.orElseThrow()).isLessThanOrEqualTo(0.7);
  }
}
