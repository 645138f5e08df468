package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.shape.Circle;
import org.u2sa.messages.shape.Polygon;

/** Stations of a vehicle that can stop and looks above and below itself. */
class StationInDepthTest extends PlannedVehicle {
  private static final double DEPTH_M = 5.0;
  private static final double RADIUS_M = 0.3;
  private static final double STEP_S = 0.1;
  private static final double SPEED_MPS = 0.5;

  private double north = 0.0;
  private double east = 0.0;
  private final List<Point> track = new ArrayList<>();

  private void step(ObjectDescription object) {
    kit.advance(STEP_S);
    kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(object)));
    StateInformation state = state(north, east, 0.0).z(DEPTH_M);
    kit.publish(Channels.STATE, state);
    NavigationPoint point = kit.latest(Channels.NAVIGATION).orElseThrow();
    Point to = new Attitude(0.0, 0.0, 0.0).nedOf(point.point());
    double level = Math.hypot(to.x(), to.y());
    double move = Math.min(level, SPEED_MPS * STEP_S);
    if (level > 0.0 && point.speed().orElse(SPEED_MPS) > 0.0) {
      north += move * to.x() / level;
      east += move * to.y() / level;
    }
    track.add(Point.of(north, east, DEPTH_M));
  }

  /** Moves to a station until it is reported; returns the track. */
  private List<Point> reach(double toNorth, double toEast, ObjectDescription object) {
    kit.with("PLANNER", "GRID").with("VERTICAL CLEARANCE", 0.8).with("CLEARANCE", 0.3);
    kit.with("PLANNING CELL", 0.1).with("INFLATION", 0.5).with("VEHICLE WIDTH", 0.5);
    kit.with("AT END", "HOLD").start(PathPlanner::new);
    object.uid("object").referenceFrame(ReferenceFrame.LOCAL_NED);
    Station station = new Station().duration(1.0);
    station.uid("S").referenceFrame(ReferenceFrame.LOCAL_NED).x(toNorth).y(toEast).z(DEPTH_M);
    station.horizontalThreshold(0.5);
    goals(station);
    for (int i = 0; i < 900 && kit.latest(Channels.GOAL_REPORTS).isEmpty(); i++) {
      step(object);
    }
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
    return track;
  }

  @ParameterizedTest
  @CsvSource({"5.5", "7.5", "8.2"})
  void station_pileWithinItsTurningDistance_isGoneAround(double pileNorth) {
    Circle pile = new Circle().radius(RADIUS_M);
    pile.x(pileNorth).y(0.0);

    assertThat(reach(10.0, 0.0, pile))
        .allMatch(at -> Math.hypot(at.x() - pileNorth, at.y()) > RADIUS_M + 0.3);
  }

  @ParameterizedTest
  @CsvSource({"10.0, 12.0", "9.0, 4.0"})
  void station_roundTheCornerOfACorridor_isReachedInside(double toNorth, double toEast) {
    Polygon corridor = new Polygon();
    corridor.points(
        List.of(
            Point.of(-2, -2, 0),
            Point.of(12, -2, 0),
            Point.of(12, 14, 0),
            Point.of(8, 14, 0),
            Point.of(8, 2, 0),
            Point.of(-2, 2, 0)));
    corridor.objectType("corridor").x(5.0).y(0.0);

    assertThat(reach(toNorth, toEast, corridor)).allMatch(at -> at.y() <= 2.0 || at.x() >= 8.0);
  }
}
