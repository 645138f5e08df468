package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.sim.aircraft.AircraftMotion;
import org.u2sa.sim.aircraft.Cessna172;
import org.u2sa.sim.aircraft.ControlInputs;
import org.u2sa.sim.aircraft.Trim;
import org.u2sa.sim.atmosphere.Wind;

/** What becomes of a Cessna that nobody commands for a while. */
class TrimmedElevatorTest {
  private static final double ALTITUDE_M = 457.0;
  private static final double CRUISE_MPS = 40.0;
  private static final double TICK_S = 1.0 / Cessna172.TICKS_PER_SECOND;

  @ParameterizedTest
  @ValueSource(doubles = {0.0, 1.0}) // idle, cruise power
  void elevator_uncommandedInCruise_neitherDivesNorStalls(double powerShare) {
    Trim trim = Trim.level(ALTITUDE_M, CRUISE_MPS, 0.0);
    Cessna172 aircraft = Cessna172.inFlight(trim.start(0.0, 0.0, 0.0, 0.0), Wind.calm());
    ControlInputs uncommanded =
        ControlInputs.neutral()
            .withThrottle(powerShare * trim.controls().throttle())
            .withSurfaces(0.0, AircraftActuator.TRIMMED_ELEVATOR_PERCENT / 100.0, 0.0);

    for (int tick = 0; tick < 30 * Cessna172.TICKS_PER_SECOND; tick++) {
      aircraft.step(uncommanded, TICK_S);
      AircraftMotion state = aircraft.state();
      assertThat(state.calibratedAirspeedMps()).isBetween(32.0, 48.0);
      assertThat(state.velocityDownMps()).isLessThan(9.0); // at idle, as the phugoid swings
    }
  }
}
