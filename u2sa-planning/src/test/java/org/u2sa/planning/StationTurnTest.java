package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.shape.Circle;

/** A boat 2.4 m long, 4 m before a station at which it has to be turned by 90 degrees. */
class StationTurnTest extends PlannedVehicle {
  private static final double RADIUS_M = 0.2;

  @BeforeEach
  void start() {
    kit.with("VEHICLE FRONT", 1.2).with("VEHICLE REAR", 1.2).with("VEHICLE WIDTH", 0.7);
    kit.with("PLANNER", "GRID").with("CLEARANCE", 0.3).with("PLANNING CELL", 0.1);
    kit.with("AT END", "HOLD").start(PathPlanner::new);
    Station station = new Station();
    station.uid("S").referenceFrame(ReferenceFrame.LOCAL_NED).x(20.0).y(0.0);
    goals(station.psi(Math.toRadians(90.0)).horizontalThreshold(0.5));
  }

  private NavigationPoint towards(double north, ObjectDescription... objects) {
    return towards(north, 0.0, objects);
  }

  private NavigationPoint towards(double north, double heading, ObjectDescription... objects) {
    kit.advance(0.1);
    kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(objects)));
    kit.publish(Channels.STATE, state(north, 0.0, heading));
    return kit.latest(Channels.NAVIGATION).orElseThrow();
  }

  private static Circle barrel(double north, double east) {
    Circle barrel = new Circle().radius(RADIUS_M);
    barrel.uid("barrel").referenceFrame(ReferenceFrame.LOCAL_NED).x(north).y(east);
    return barrel;
  }

  @Test
  void station_freeWay_isTurnedToOnTheWay() {
    double turn = towards(16.0).turn().orElseThrow();

    assertThat(Math.toDegrees(turn)).isCloseTo(90.0, within(1e-6));
  }

  /** Distance of a barrel to the boat, at most while it turns anywhere on its way [m]. */
  private static double nearestM(double from, double heading, Circle barrel) {
    double nearestM = Double.POSITIVE_INFINITY;
    for (double at = from; at <= 20.0; at += 0.1) {
      for (double turn = heading; turn <= 0.5 * Math.PI; turn += 0.05) {
        double north = barrel.x() - at;
        double ahead = north * Math.cos(turn) + barrel.y() * Math.sin(turn);
        double right = barrel.y() * Math.cos(turn) - north * Math.sin(turn);
        double alongM = Math.max(0.0, Math.abs(ahead) - 1.2);
        double asideM = Math.max(0.0, Math.abs(right) - 0.35);
        nearestM = Math.min(nearestM, Math.hypot(alongM, asideM) - RADIUS_M);
      }
    }
    return nearestM;
  }

  /** The bow or the stern would swing into it. */
  @ParameterizedTest
  @CsvSource({
    "16.0, 0.0",
    "17.0, 0.0",
    "18.0, 0.0",
    "19.0, 0.0",
    "17.0, 0.4",
    "18.5, 0.8",
    "17.0, 1.2"
  })
  void station_barrelBesideTheWay_isNotTurnedInto(double from, double heading) {
    int turns = 0;
    for (double north = from - 2.0; north <= 22.0; north += 0.25) {
      for (double east = -2.5; east <= 2.5; east += 0.25) {
        Circle barrel = barrel(north, east);
        if (towards(from, heading, barrel).turn().isPresent()) {
          turns++;
          assertThat(nearestM(from, heading, barrel)).as("%s %s", north, east).isPositive();
        }
      }
    }
    assertThat(turns).isPositive();
  }

  @Test
  void station_barrelFartherFromTheWayThanTheBow_isTurnedToOnTheWay() {
    assertThat(towards(16.0, barrel(17.5, 2.0)).turn()).isPresent();
  }
}
