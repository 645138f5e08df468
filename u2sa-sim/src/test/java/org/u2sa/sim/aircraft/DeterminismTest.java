package org.u2sa.sim.aircraft;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.u2sa.sim.atmosphere.Wind;

class DeterminismTest {
  private static final RunwayStart RUNWAY = new RunwayStart(8.0, 50.0, 100.0, 0.5);

  @Test
  void step_sameSeed_isTheSameToTheLastBit() {
    assertThat(fly(11L)).isEqualTo(fly(11L));
  }

  @Test
  void step_otherSeed_differs() {
    assertThat(fly(11L)).isNotEqualTo(fly(12L));
  }

  @Test
  void step_manySmallSteps_equalOneLarge() {
    Cessna172 small = Cessna172.onRunway(RUNWAY, Wind.turbulent(0.0, 5.0, 1L), true);
    Cessna172 large = Cessna172.onRunway(RUNWAY, Wind.turbulent(0.0, 5.0, 1L), true);
    ControlInputs inputs = ControlInputs.neutral().withThrottle(0.8);
    for (int i = 0; i < 200; i++) {
      small.step(inputs, 0.05);
    }
    large.step(inputs, 10.0);
    assertThat(small.state()).isEqualTo(large.state());
    assertThat(small.state().timeS()).isEqualTo(10.0);
  }

  @Test
  void step_stepsThatAreNoTicks_loseNoTime() {
    Cessna172 aircraft = Cessna172.onRunway(RUNWAY, Wind.calm(), true);
    for (int i = 0; i < 3_000; i++) {
      aircraft.step(ControlInputs.neutral(), 0.01);
    }
    assertThat(aircraft.state().timeS()).isEqualTo(30.0);
  }

  private static AircraftMotion fly(long seed) {
    Cessna172 aircraft = Cessna172.onRunway(RUNWAY, Wind.turbulent(1.0, 8.0, seed), true);
    Random pilot = new Random(5L);
    for (int i = 0; i < 400; i++) {
      ControlInputs inputs =
          ControlInputs.limited(
              0.1 * pilot.nextGaussian(), -0.1, 0.1 * pilot.nextGaussian(), 1.0, 1.0, 0, 0, 0);
      aircraft.step(inputs, 0.1);
    }
    return aircraft.state();
  }
}
