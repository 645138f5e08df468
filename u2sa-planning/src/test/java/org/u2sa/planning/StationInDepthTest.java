package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.shape.Circle;

/** A station of a vehicle that can stop and looks above and below itself, and a pile before it. */
class StationInDepthTest extends PlannedVehicle {
  private static final double DEPTH_M = 5.0;
  private static final double RADIUS_M = 0.3;
  private static final double STEP_S = 0.1;
  private static final double SPEED_MPS = 0.5;

  private double north = 0.0;
  private double east = 0.0;

  private void step(Circle pile) {
    kit.advance(STEP_S);
    kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(pile)));
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
  }

  @ParameterizedTest
  @CsvSource({"5.5", "7.5", "8.2"})
  void station_pileWithinItsTurningDistance_isGoneAround(double pileNorth) {
    kit.with("PLANNER", "GRID").with("VERTICAL CLEARANCE", 0.8).with("CLEARANCE", 0.3);
    kit.with("PLANNING CELL", 0.1).with("INFLATION", 0.5).with("VEHICLE WIDTH", 0.5);
    kit.with("AT END", "HOLD").start(PathPlanner::new);
    Circle pile = new Circle().radius(RADIUS_M);
    pile.uid("pile").referenceFrame(ReferenceFrame.LOCAL_NED).x(pileNorth).y(0.0);
    Station station = new Station().duration(1.0);
    station.uid("S").referenceFrame(ReferenceFrame.LOCAL_NED).x(10.0).y(0.0).z(DEPTH_M);
    station.horizontalThreshold(0.5);
    goals(station);

    double nearestM = Double.POSITIVE_INFINITY;
    for (int i = 0; i < 600 && kit.latest(Channels.GOAL_REPORTS).isEmpty(); i++) {
      step(pile);
      nearestM = Math.min(nearestM, Math.hypot(north - pileNorth, east));
    }
    assertThat(kit.latest(Channels.GOAL_REPORTS).orElseThrow().completed()).isTrue();
    assertThat(nearestM).isGreaterThan(RADIUS_M + 0.3);
  }
}
