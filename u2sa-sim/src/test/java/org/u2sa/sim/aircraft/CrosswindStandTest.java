package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.sim.atmosphere.Wind;

/**
 * An aircraft parked across a strong wind stays on its wheels: air along the span lifts nothing.
 */
class CrosswindStandTest {
  private static final double HELD_S = 120.0;

  @ParameterizedTest(name = "{0} m/s from {1} deg, seed {2}")
  @CsvSource({"12, 90, 2", "12, 270, 2", "16, 90, 1", "16, 60, 3", "16, 120, 4"})
  void step_parkedAcrossGusts_standsOnAllWheels(double windMps, double fromDeg, long seed) {
    Cessna172 aircraft =
        Cessna172.onRunway(
            new RunwayStart(8.0, 50.0, 0.0, 0.0),
            Wind.gusty(Math.toRadians(fromDeg), windMps, seed),
            true);
    ControlInputs braked = new ControlInputs(0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0);
    for (double t = 0.0; t < HELD_S; t += 0.5) {
      aircraft.step(braked, 0.5);
      AircraftMotion state = aircraft.state();
      assertThat(state.crashed()).as("at %.1f s", t).isFalse();
      assertThat(Math.toDegrees(state.rollRad())).isBetween(-6.0, 6.0);
      assertThat(Math.toDegrees(state.pitchRad())).isBetween(-2.0, 6.0);
    }
  }
}
