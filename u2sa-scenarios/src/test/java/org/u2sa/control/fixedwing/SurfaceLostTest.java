package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.u2sa.sim.atmosphere.Wind;

/** Actuator lost in mid-mission, fixed wing: the rest of the mission, scored against truth. */
class SurfaceLostTest {
  private static final double FIELD_M = 4.0;
  private static final double FAILS_AT_S = 150.0;

  private static FlightScore flown(SurfaceMixing left, boolean knows) {
    SimulatedFlight flight =
        new SimulatedFlight(
            TestTuning.standard(),
            Course.ten(),
            Wind.constant(1.0, 4.0).withGusts(0.8, 3),
            SimulatedFlight.Loop.lockstep(),
            FIELD_M);
    flight.left = left;
    flight.failsAtS = FAILS_AT_S;
    flight.knows = knows;
    return flight.fly();
  }

  /** Ailerons lost in cruise, and control hears of it: it flies all legs by the rudder. */
  @Test
  void fly_aileronsLost_rudderRollsAndEveryWaypointIsCaptured() {
    FlightScore score = flown(new SurfaceMixing(0.0, 1.0, 1.0), true);

    assertThat(score.crashed).as("%s", score).isFalse();
    assertThat(score.stalled).as("%s", score).isFalse();
    assertThat(score.worstMissM()).as("%s", score).isLessThan(100.0);
    assertThat(score.crossRmsM()).as("%s", score).isLessThan(20.0);
    assertThat(score.worstBankDeg).as("%s", score).isLessThan(40.0);
    assertThat(score.slowestMps).as("%s", score).isGreaterThan(28.5);
  }

  /** The same, and control does not hear of it: what the announcement is worth. */
  @Tag("long")
  @Test
  void fly_aileronsLostUnheard_doesNotGetAround() {
    assertThat(flown(new SurfaceMixing(0.0, 1.0, 1.0), false).worstMissM()).isGreaterThan(1000.0);
  }

  @Tag("long")
  @Test
  void fly_oneOfTwoAileronsLost_everyWaypointIsCaptured() {
    FlightScore score = flown(new SurfaceMixing(0.5, 1.0, 1.0), true);

    assertThat(score.crashed).as("%s", score).isFalse();
    assertThat(score.worstMissM()).as("%s", score).isLessThan(100.0);
    assertThat(score.crossRmsM()).as("%s", score).isLessThan(5.0);
  }

  @Tag("long")
  @Test
  void fly_rudderLost_everyWaypointIsCaptured() {
    FlightScore score = flown(new SurfaceMixing(1.0, 1.0, 0.0), true);

    assertThat(score.crashed).as("%s", score).isFalse();
    assertThat(score.worstMissM()).as("%s", score).isLessThan(100.0);
  }

  @Test
  void of_weakenedAileron_movesFartherAndTheRudderGivesWhatIsMissing() {
    Surfaces mixed =
        new SurfaceMixing(0.5, 1.0, 1.0).of(new Surfaces(0.8, 0.1, 0.0, 0.5, 1.0, 0.0, 0.0));

    assertThat(mixed.aileron()).isEqualTo(1.0);
    assertThat(mixed.rudder()).isGreaterThan(0.1);
    assertThat(mixed.elevator()).isEqualTo(0.1);
  }
}
