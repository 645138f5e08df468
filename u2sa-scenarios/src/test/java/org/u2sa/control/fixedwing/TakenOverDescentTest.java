package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.flight.Catapult;
import org.u2sa.sim.flight.UnmannedAircraft;
import org.u2sa.sim.world.World;

/** The Aerosonde by CessnaControl, which takes over in a climb or descent that nobody ordered. */
class TakenOverDescentTest {
  private static final double ALTITUDE_M = 80.0;
  private static final Point FAR = Point.of(0.0, 6_000.0, ALTITUDE_M);
  private static final double STALL_MPS = 14.0;

  private SmallAircraftFlight flight;

  @BeforeEach
  void flyLevel() {
    World world = World.at(new Geodetic(9.0, 54.0, 0.0)).with(Wind.calm());
    UnmannedAircraft aircraft = SmallAircraftFlightTest.aerosonde(world);
    aircraft.launch(new Catapult(22.0, Math.toRadians(10.0), 1.5, 2.0));
    flight = new SmallAircraftFlight(aircraft, Set.of("RUDDER"), SmallAircraftFlight.aerosonde());
    flight.fly(FAR, 60.0);
  }

  @AfterEach
  void close() {
    flight.close();
  }

  /** Elevator, aileron and throttle of the pilot, for how long, and the most height to lose. */
  @ParameterizedTest
  @CsvSource({
    "0, 0, 67, 1.5, 9",
    "0, 0, 67, 2.5, 15",
    "0, 0, 0, 2, 18",
    "-70, 0, 0, 6, 22",
    "0, 20, 0, 2, 30"
  })
  void giveBack_inADescent_pullsUpWithoutAStall(
      double elevator, double aileron, double throttle, double seconds, double mostM) {
    flight.flyByHand(
        FAR,
        seconds,
        Map.of("ELEVATOR", elevator, "AILERON", aileron, "THROTTLE", throttle, "RUDDER", 0.0));
    double beforeM = flight.now().position().z();
    assertThat(flight.now().velocity().z()).isLessThan(-3.0);

    flight.fly(FAR, 12.0);

    assertThat(beforeM - flight.lowestM(12.0)).isLessThan(mostM);
    assertThat(flight.slowestMps(12.0)).isGreaterThan(1.2 * STALL_MPS);
    assertThat(flight.hardestPullMps2(12.0)).isLessThan(10.0);
  }

  @Test
  void giveBack_inASteepClimb_levelsOffWithoutAStall() {
    flight.flyByHand(
        FAR, 2.0, Map.of("ELEVATOR", -90.0, "AILERON", 0.0, "THROTTLE", 100.0, "RUDDER", 0.0));
    assertThat(flight.now().velocity().z()).isGreaterThan(10.0);

    flight.fly(FAR, 12.0);

    assertThat(flight.now().position().z()).isLessThan(ALTITUDE_M + 20.0);
    assertThat(flight.slowestMps(12.0)).isGreaterThan(1.2 * STALL_MPS);
  }

  @Test
  void giveBack_inLevelFlight_changesNothing() {
    double elevator = flight.kit.percent("ELEVATOR");
    double throttle = flight.kit.percent("THROTTLE");
    flight.flyByHand(FAR, 1.0, Map.of("ELEVATOR", elevator, "THROTTLE", throttle));

    flight.fly(FAR, 12.0);

    assertThat(flight.lowestM(12.0)).isGreaterThan(ALTITUDE_M - 0.5);
    assertThat(flight.now().position().z()).isLessThan(ALTITUDE_M + 0.5);
    assertThat(flight.hardestPullMps2(12.0)).isLessThan(0.5);
  }

  /** The elevator's trim is unknown after a restart, so it takes longer. */
  @ParameterizedTest
  @CsvSource({"1, 12", "2, 27"})
  void restart_inADescent_pullsUp(double seconds, double mostM) {
    flight.flyWithoutControl(FAR, seconds);
    double beforeM = flight.now().position().z();

    flight.fly(FAR, 12.0);

    assertThat(beforeM - flight.lowestM(12.0)).isLessThan(mostM);
    assertThat(flight.slowestMps(12.0)).isGreaterThan(1.2 * STALL_MPS);
  }

  /** Without states the surfaces go to neutral. */
  @Test
  void statesReturn_inADescent_pullsUp() {
    flight.flyUnseen(2.5);
    double beforeM = flight.now().position().z();

    flight.fly(FAR, 12.0);

    assertThat(beforeM - flight.lowestM(12.0)).isLessThan(12.0);
  }
}
