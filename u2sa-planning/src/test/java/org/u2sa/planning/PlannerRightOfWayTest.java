package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Circle;

/** The planner among other vessels, bound for a place 300 m north. */
class PlannerRightOfWayTest extends PlannedVehicle {
  private static ObjectDescription vessel(
      double north, double east, double northMps, double eastMps) {
    Circle vessel = new Circle().radius(2.0);
    vessel.uid("ferry").referenceFrame(ReferenceFrame.LOCAL_NED).x(north).y(east);
    vessel.motion().velocity(Point.of(northMps, eastMps, 0.0));
    return vessel;
  }

  private void start(String planner) {
    kit.with("RIGHT OF WAY", "COLREGS").with("PASSING DISTANCE", 20.0).with("PLANNER", planner);
    kit.with("PLANNED SPEED", 1.5).with("PLANNED TURN RATE", 15.0).with("PLANNING SPAN", 100.0);
    kit.with("PLANNING CELL", 1.0).start(PathPlanner::new);
    goals(waypoint("1", 300, 0));
  }

  private void pass(double seconds, ObjectDescription... objects) {
    for (int i = 0; i < 2 * seconds; i++) {
      kit.advance(0.5);
      ObjectList list = new ObjectList().objects(List.of(objects));
      list.timestamp(kit.clock().micros());
      kit.publish(Channels.OBJECTS, list);
      kit.publish(Channels.STATE, state(0, 0, 0));
    }
  }

  private double bearingDeg() {
    Point to = kit.latest(Channels.NAVIGATION).orElseThrow().point();
    return Math.toDegrees(Math.atan2(-to.y(), to.x())); // BODY: y is to the left
  }

  @ParameterizedTest
  @ValueSource(strings = {"NONE", "GRID"})
  void state_vesselHeadOn_goesToStarboardAndSaysWhy(String planner) {
    start(planner);
    pass(5.0, vessel(300, 0, -1.5, 0));

    assertThat(bearingDeg()).isCloseTo(35.0, within(6.0));
    assertThat(kit.latest(Channels.NAVIGATION).flatMap(PlannerRightOfWayTest::speed)).contains(1.5);
    assertThat(kit.published(Channels.PLANS))
        .extracting(PlannedPath::planner, path -> path.reason().orElse(""))
        .anySatisfy(
            both -> {
              assertThat(both.toList().get(0)).isEqualTo("RIGHT OF WAY");
              assertThat(both.toList().get(1).toString()).contains("\"ferry\" (rule 14)");
            });
  }

  private static Optional<Double> speed(NavigationPoint point) {
    return point.speed().isPresent() ? Optional.of(point.speed().getAsDouble()) : Optional.empty();
  }

  @Test
  void state_vesselFromPort_holdsItsCourse() {
    start("NONE");
    pass(5.0, vessel(150, -150, 0, 1.5));

    assertThat(bearingDeg()).isCloseTo(0.0, within(1.0));
  }

  @Test
  void state_vesselGoneAgain_returnsToItsWay() {
    start("NONE");
    pass(5.0, vessel(300, 0, -1.5, 0));
    pass(5.0, vessel(-100, 0, -1.5, 0));

    assertThat(bearingDeg()).isCloseTo(0.0, within(1.0));
  }

  @Test
  void state_withoutRightOfWay_ignoresVessels() {
    kit.start(PathPlanner::new);
    goals(waypoint("1", 300, 0));
    pass(5.0, vessel(300, 0, -1.5, 0));

    assertThat(bearingDeg()).isCloseTo(0.0, within(1.0));
  }

  @Test
  void state_surroundingsUnknown_stands() {
    start("NONE");
    pass(2.0, vessel(300, 0, -1.5, 0));
    for (int i = 0; i < 10; i++) {
      kit.advance(0.5);
      kit.publish(Channels.STATE, state(0, 0, 0));
    }

    assertThat(kit.latest(Channels.NAVIGATION).flatMap(PlannerRightOfWayTest::speed)).contains(0.0);
  }
}
