package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalInformation;

/** A vehicle under or above a slab of 10 m radius, with a goal beside it at another altitude. */
class CoveredVehicleTest extends PlannedVehicle {
  private static final double STEP_S = 0.1;
  private static final double CLEARANCE_M = 2.0;
  private static final double SPEED_MPS = 1.0;

  private Point at;

  private void step() {
    kit.advance(STEP_S);
    kit.publish(
        Channels.OBJECTS, new ObjectList().objects(List.of(VerticalFlight.slab(12.0, 14.0))));
    kit.publish(
        Channels.STATE,
        state(at.x(), at.y(), 0.0).z(at.z()).xDot(0.0).yDot(0.0).zDot(0.0).phi(0.0).theta(0.0));
    Point way =
        kit.latest(Channels.NAVIGATION)
            .map(point -> new Attitude(0.0, 0.0, 0.0).nedOf(point.point()))
            .orElse(Point.ORIGIN);
    double aside = Math.max(1.0, Math.hypot(way.x(), way.y()));
    double down = Math.max(-SPEED_MPS, Math.min(SPEED_MPS, way.z()));
    Point velocity = Point.of(SPEED_MPS * way.x() / aside, SPEED_MPS * way.y() / aside, down);
    at = at.plus(velocity.times(STEP_S));
  }

  @ParameterizedTest
  @CsvSource({"7.0, 20.0", "7.0, 13.0", "20.0, 7.0", "20.0, 13.0"})
  void waypoint_besideWhatIsAboveOrBelow_isReachedAfterAWayAtTheVehiclesAltitude(
      double fromM, double toM) {
    kit.with("PLANNER", "GRID").with("VERTICAL CLEARANCE", CLEARANCE_M);
    kit.with("PLANNING CELL", 0.5).with("PLANNING SPAN", 100.0).with("GIVE UP AFTER", 20.0);
    kit.with("PLANNED SPEED", SPEED_MPS);
    kit.start(PathPlanner::new);
    at = Point.of(-2.0, 0.0, -fromM);
    goals(waypoint("beside", 25.0, 0.0).z(-toM).verticalThreshold(0.5));
    double nearestM = Double.POSITIVE_INFINITY; // vertically, within the slab's radius
    while (kit.nowS() < 120.0 && kit.latest(Channels.GOAL_REPORTS).isEmpty()) {
      step();
      if (Math.hypot(at.x(), at.y()) < 10.0) {
        nearestM = Math.min(nearestM, fromM < 12.0 ? 12.0 + at.z() : -at.z() - 14.0);
      }
    }

    assertThat(kit.latest(Channels.GOAL_REPORTS).filter(GoalInformation::completed)).isPresent();
    assertThat(nearestM).isGreaterThan(CLEARANCE_M);
  }
}
