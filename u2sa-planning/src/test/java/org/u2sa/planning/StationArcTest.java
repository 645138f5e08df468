package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.shape.Circle;

/** Stations of vehicles that cannot turn in place and circle to what is behind them. */
class StationArcTest extends PlannedVehicle {
  private static final double THRESHOLD_M = 1.0;

  private void start(Map<String, Object> variables) {
    variables.forEach(kit::with);
    kit.with("AT END", "HOLD").start(PathPlanner::new);
    Station station = new Station();
    station.uid("S").referenceFrame(ReferenceFrame.LOCAL_NED).x(20.0).y(0.0);
    station.horizontalThreshold(THRESHOLD_M);
    goals(station);
  }

  private void seesPole(double poleEast, double north, double east) {
    Circle pole = new Circle().radius(0.3);
    pole.uid("pole").referenceFrame(ReferenceFrame.LOCAL_NED).x(20.6).y(poleEast);
    for (int i = 0; i < 5; i++) {
      kit.advance(0.1);
      kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(pole)));
      kit.publish(Channels.STATE, state(north, east, 0.0));
    }
  }

  private double commandedMps() {
    return kit.latest(Channels.NAVIGATION).orElseThrow().speed().orElse(Double.NaN);
  }

  @Test
  void station_poleOnTheCircleToTheCentreBehind_staysWithinTheThreshold() {
    start(Map.of("PLANNER", "HYBRID", "TURN RADIUS", 1.0));
    seesPole(2.0, 20.6, -0.1); // it would turn right, over 1.9 m to the east

    assertThat(point().distance()).isCloseTo(0.0, within(1.0e-9));
    assertThat(commandedMps()).isEqualTo(0.0);
  }

  @Test
  void station_poleBesideTheOtherCircle_goesToTheCentre() {
    start(Map.of("PLANNER", "HYBRID", "TURN RADIUS", 1.0));
    seesPole(2.0, 20.6, 0.1); // it would turn left

    assertThat(point().x()).isCloseTo(-0.6, within(1.0e-6));
  }

  @Test
  void station_poleBesideTheCircleOfAVehicleThatTurnsInPlace_goesToTheCentre() {
    start(Map.of("PLANNER", "GRID"));
    seesPole(2.0, 20.6, -0.1);

    assertThat(point().x()).isCloseTo(-0.6, within(1.0e-6));
  }

  @Test
  void station_poleOnTheCircleOutsideTheThreshold_isApproachedOnARoute() {
    start(Map.of("PLANNER", "HYBRID", "TURN RADIUS", 1.0, "REVERSES", true));
    seesPole(1.7, 21.5, -0.1);

    assertThat(kit.latest(Channels.PLANS)).isPresent();
  }
}
