package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.sim.atmosphere.Wind;

class ThroughputTest {
  private static final double FLOWN_S = 600.0;

  /** Measured at 3000 to 5000; the bound leaves room for busy machines and cold code. */
  @Test
  void step_turbulentFlightAt20Hz_runsFarFasterThanRealTime() {
    Trim trim = Trim.level(600.0, 50.0, 0.0);
    Cessna172 aircraft =
        Cessna172.inFlight(trim.start(-157.9, 21.3, 0.0, 1.0), Wind.turbulent(1.0, 5.0, 3L));
    long begun = System.nanoTime();
    while (aircraft.state().timeS() < FLOWN_S) {
      AircraftState state = aircraft.state();
      aircraft.step(
          HandPilot.hold(state, trim.controls(), trim.pitchRad(), 0.0, trim.controls().elevator()),
          0.05);
    }
    double wallS = (System.nanoTime() - begun) * 1e-9;
    System.out.printf("Cessna 172: %.0f simulated seconds a second%n", FLOWN_S / wallS);
    assertThat(FLOWN_S / wallS).isGreaterThan(100.0);
    assertThat(aircraft.state().crashed()).isFalse();
  }
}
