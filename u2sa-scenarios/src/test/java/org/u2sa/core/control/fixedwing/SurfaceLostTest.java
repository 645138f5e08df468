package org.u2sa.core.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;

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

  @Test
  void try_all() {
    for (SurfaceMixing left :
        new SurfaceMixing[] {
          new SurfaceMixing(0.0, 1.0, 1.0),
          new SurfaceMixing(0.5, 1.0, 1.0),
          new SurfaceMixing(1.0, 1.0, 0.0)
        }) {
      for (boolean knows : new boolean[] {true, false}) {
        System.out.println("DBG " + left + " " + knows + ": " + flown(left, knows));
      }
    }
    assertThat(1).isOne();
  }
}
