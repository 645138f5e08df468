package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.goal.Station;
import org.u2sa.messages.shape.Circle;

/** Speed on the straight way to a station, where no route leads. */
class StationSpeedTest extends PlannedVehicle {
  private Circle pole = pole(0, 30);

  private static Circle pole(double north, double east) {
    Circle pole = new Circle().radius(0.2);
    pole.uid("pole").referenceFrame(ReferenceFrame.LOCAL_NED).x(north).y(east);
    return pole;
  }

  private static Station station() {
    Station station = new Station();
    station.uid("S").referenceFrame(ReferenceFrame.LOCAL_NED).x(20.0).y(0.0);
    station.horizontalThreshold(0.5);
    return station;
  }

  private void start(String planner, double plannedMps, GoalInformation station) {
    kit.with("PLANNER", planner).with("PLANNED SPEED", plannedMps).start(PathPlanner::new);
    goals(station);
  }

  private void sees(StateInformation state) {
    kit.advance(0.1);
    kit.publish(Channels.OBJECTS, new ObjectList().objects(List.of(pole)));
    kit.publish(Channels.STATE, state);
  }

  private double commandedMps() {
    return kit.latest(Channels.NAVIGATION).orElseThrow().speed().orElse(Double.NaN);
  }

  /** Speed from which a vehicle stops in a distance at 0.7 m/s² after 0.3 s: v²/2b + v t. */
  private static double stoppableMps(double wayM) {
    return Math.sqrt(0.0441 + 1.4 * wayM) - 0.21;
  }

  @Test
  void station_nearIt_isApproachedAtThePlannedSpeed() {
    start("GRID", 0.8, station());
    sees(state(16.0, 0.0, 0.0));

    assertThat(commandedMps()).isEqualTo(0.8);
  }

  @Test
  void station_tooNearForThePlannedSpeed_isApproachedSoThatTheVehicleStopsThere() {
    start("GRID", 3.0, station());
    sees(state(18.5, 0.0, 0.0));

    assertThat(commandedMps()).isBetween(0.5, stoppableMps(1.5) + 1.0e-9);
  }

  @Test
  void station_ofItsOwnSpeed_isApproachedSoThatTheVehicleStopsThereToo() {
    start("GRID", 1.0, station().speed(2.5));
    sees(state(18.0, 0.0, 0.0));

    assertThat(commandedMps()).isBetween(0.9, stoppableMps(2.0) + 1.0e-9);
  }

  @Test
  void station_vehicleTooFastToStopThere_isCommandedLessThanItCouldStopFrom() {
    start("GRID", 3.0, station());
    sees(state(18.5, 0.0, 0.0));
    double slow = commandedMps();
    sees(state(18.5, 0.0, 0.0).xDot(slow + 0.4).yDot(0.0));

    assertThat(commandedMps()).isCloseTo(slow - 0.4, within(1.0e-6));
  }

  @Test
  void station_goneAroundSomethingTo_isApproachedSoThatTheVehicleStopsThere() {
    start("GRID", 3.0, station());
    pole = pole(20.5, 0.0);
    sees(state(18.5, 0.0, 0.0));

    assertThat(kit.latest(Channels.PLANS)).as("on a route").isPresent();
    assertThat(commandedMps()).isBetween(0.1, stoppableMps(1.5) + 1.0e-9);
  }

  @Test
  void station_poleJustBehindIt_isApproachedMoreSlowly() {
    Station station = station();
    station.horizontalThreshold(2.5);
    start("GRID", 3.0, station);
    sees(state(18.5, 0.0, 0.0));
    double freely = commandedMps();
    assertThat(freely).isBetween(1.0, 3.0);
    pole = pole(20.62, 0.0); // 0.12 m beyond the front of a vehicle at the station
    sees(state(18.5, 0.0, 0.0));

    assertThat(commandedMps()).isBetween(0.5, 0.99 * freely);
  }

  @Test
  void station_poleAheadOfAVehicleThatStillTurnsToIt_isApproachedSoThatItStopsBeforeThePole() {
    start("GRID", 3.0, station());
    pole = pole(19.5, -2.0);
    sees(state(18.0, -2.0, 0.0).xDot(1.5).yDot(0.0));

    assertThat(commandedMps()).isLessThan(stoppableMps(1.0)); // between its front and the pole
  }

  @Test
  void station_withinItsThreshold_keepsItsOwnSpeed() {
    Station station = station();
    station.speed(0.3);
    station.horizontalThreshold(3.0);
    start("NONE", 1.0, station);
    sees(state(18.0, 0.0, 0.0));

    assertThat(commandedMps()).isEqualTo(0.3);
  }

  @Test
  void station_endOfItsStraightWay_isReachedSoThatTheVehicleStopsThere() {
    start("GRID", 1.0, station().approach(5.0).psi(0.0).speed(1.2));
    sees(state(15.0, 0.0, 0.0));
    sees(state(17.0, 0.0, 0.0));
    assertThat(commandedMps()).isEqualTo(1.2);
    sees(state(19.4, 0.0, 0.0));

    assertThat(commandedMps()).isLessThanOrEqualTo(stoppableMps(0.6) + 1.0e-9);
  }

  @Test
  void station_carriedOutOfABerth_isReenteredAtItsSpeed() {
    start("GRID", 1.0, station().approach(5.0).psi(0.0).speed(0.2));
    sees(state(15.0, 0.0, 0.0));
    sees(state(19.8, 0.0, 0.0));
    sees(state(19.0, 0.0, 0.0));

    assertThat(commandedMps()).isEqualTo(0.2);
  }
}
