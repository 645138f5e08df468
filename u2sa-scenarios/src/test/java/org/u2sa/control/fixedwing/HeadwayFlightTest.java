package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.flight.Catapult;
import org.u2sa.sim.flight.UnmannedAircraft;
import org.u2sa.sim.world.World;

/** The Aerosonde, of 25 m/s and 35 m/s at most, against winds about as fast, by truth. */
class HeadwayFlightTest {
  private static final Point AHEAD = Point.of(0.0, 500.0, 60.0);

  private static SmallAircraftFlight flight(Wind wind, double launchMps) {
    World world = World.at(new Geodetic(9.0, 54.0, 0.0)).with(wind);
    UnmannedAircraft aircraft = SmallAircraftFlightTest.aerosonde(world);
    aircraft.launch(new Catapult(launchMps, Math.toRadians(10.0), 1.5, 2.0));
    return new SmallAircraftFlight(aircraft, Set.of("RUDDER"), SmallAircraftFlight.aerosonde());
  }

  private static List<Double> airspeeds(SmallAircraftFlight flight) {
    return flight.kit.<ControlStatus>published(ControlStatus.CHANNEL).stream()
        .flatMap(status -> status.airspeed().stream().boxed())
        .collect(Collectors.toList());
  }

  private static List<String> raises(SmallAircraftFlight flight) {
    return flight.kit.log("Control").stream()
        .filter(line -> line.contains("airspeed raised to"))
        .collect(Collectors.toList());
  }

  private static Point end(SmallAircraftFlight flight) {
    return flight.track.get(flight.track.size() - 1).position();
  }

  @ParameterizedTest
  @CsvSource({"24.0, 0.0, 1", "26.0, 0.0, 2", "25.0, 0.3, 3"})
  void fly_againstAWindOfItsCruiseSpeed_fliesFasterAndGetsThere(
      double windMps, double fromRad, long seed) {
    try (SmallAircraftFlight flight = flight(Wind.gusty(fromRad, windMps, seed), 8.0)) {
      assertThat(flight.flyTo(AHEAD, 30.0, 300.0)).isTrue();
      assertThat(airspeeds(flight)).allMatch(mps -> mps <= 35.0);
      assertThat(raises(flight)).hasSize(1);
      assertThat(flight.aircraft.isAground()).isFalse();
    }
  }

  /** Back and forth: in the wind's direction, it flies at its usual speed. */
  @Test
  void fly_thereAndBack_isFasterAgainstTheWindOnly() {
    try (SmallAircraftFlight flight = flight(Wind.gusty(0.0, 24.0, 4), 8.0)) {
      assertThat(flight.flyTo(AHEAD, 20.0, 200.0)).isTrue();
      flight.kit.forget();
      for (int i = 0; i < 40; i++) {
        Point here = end(flight);
        flight.flyTo(Point.of(here.x(), here.y() - 80.0, 60.0), 1.0, 1.0); // as a planner leads
      }
      assertThat(end(flight).y()).isLessThan(-300.0);
      List<Double> downwind = airspeeds(flight);
      assertThat(downwind.subList(5, downwind.size())).allMatch(mps -> mps < 28.5);
    }
  }

  /** Its track then leads away from the point, slowly and to neither side. */
  @ParameterizedTest
  @CsvSource({"20.0, 1", "22.0, 2", "22.0, 3", "24.0, 4"})
  void fly_backAcrossAStrongWind_turnsAndGetsThere(double windMps, long seed) {
    try (SmallAircraftFlight flight = flight(Wind.gusty(0.0, windMps, seed), 8.0)) {
      assertThat(flight.flyTo(Point.of(400.0, 0.0, 60.0), 40.0, 200.0)).isTrue();
      assertThat(flight.flyTo(Point.of(-300.0, -50.0, 60.0), 40.0, 200.0)).isTrue();
      assertThat(flight.aircraft.isAground()).isFalse();
    }
  }

  @Test
  void fly_againstAWindFasterThanItsMaxSpeed_pointsIntoItAndIsNotBlownAside() {
    try (SmallAircraftFlight flight = flight(Wind.gusty(0.0, 45.0, 5), 2.0)) {
      assertThat(flight.flyTo(AHEAD, 20.0, 100.0)).isFalse();
      Point end = end(flight);
      assertThat(end.y()).as("driven back").isBetween(-2000.0, -500.0);
      assertThat(Math.abs(end.x())).isLessThan(150.0);
      assertThat(airspeeds(flight).subList(40, 90)).allMatch(mps -> mps == 35.0);
      assertThat(flight.aircraft.isAground()).isFalse();
    }
  }

  @ParameterizedTest
  @CsvSource({"0.0, 0.0, 1", "8.0, 0.0, 2", "8.0, 0.3, 3"})
  void fly_turnsInAWindThatItCanFlyAgainst_keepsItsSpeed(
      double windMps, double fromRad, long seed) {
    try (SmallAircraftFlight flight = flight(Wind.gusty(fromRad, windMps, seed), 22.0)) {
      for (Point place :
          List.of(AHEAD, Point.of(300.0, 0.0, 60.0), Point.of(-300.0, 100.0, 60.0))) {
        flight.flyTo(place, 20.0, 60.0);
      }
      assertThat(airspeeds(flight)).allMatch(mps -> mps < 25.1);
      assertThat(raises(flight)).isEmpty();
    }
  }

  @Test
  void windEstimate_velocityOverGroundLost_keepsTheWind() {
    WindEstimate wind = new WindEstimate();
    States seen = States.level().speed(25.0).ground(-7.0, 25.0);
    for (int i = 0; i < 1000; i++) {
      wind.step(seen.now(), 0.02);
    }
    for (int i = 0; i < 1000; i++) {
      wind.step(seen.heading(i * 0.01).overGroundKnown(false).now(), 0.02);
    }

    assertThat(wind.speedMps()).isCloseTo(7.0, within(0.1));
    assertThat(wind.airspeedMps(0.0, 5.0)).isCloseTo(12.0, within(0.1));
    assertThat(wind.airspeedMps(Math.PI / 2.0, 24.0)).isCloseTo(25.0, within(0.1));
    assertThat(wind.airspeedMps(Math.PI, 5.0)).isCloseTo(0.0, within(0.1));
    assertThat(wind.headwayMps(0.0, 25.0)).isCloseTo(18.0, within(0.1));
    assertThat(wind.headwayMps(0.0, 6.0)).isCloseTo(-1.0, within(0.1));
  }
}
