package org.u2sa.control.fixedwing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

/** The first steps of an autopilot that is started low, in flight. */
class AutopilotStartTest {
  private static final double DT_S = 0.02;

  private final AutopilotVariables tuning = TestTuning.standard();
  private final Autopilot autopilot = new Autopilot(tuning);

  @Test
  void step_firstInALowClimb_continuesFromItsPitchWithPower() {
    double pitchRad = Math.toRadians(8.0);
    Surfaces surfaces = start(States.level().height(10.0).climb(3.0).pitch(pitchRad));

    assertThat(autopilot.phase()).isEqualTo(FlightPhase.CLIMB_OUT);
    assertThat(autopilot.pitchDemandRad()).isCloseTo(pitchRad, within(Math.toRadians(0.5)));
    assertThat(surfaces.throttle()).isGreaterThan(0.5);
  }

  @Test
  void step_firstInTheFlare_continuesFromItsPitch() {
    double pitchRad = Math.toRadians(5.0);
    start(States.level().altitude(15.0).height(4.0).climb(-1.0).pitch(pitchRad), -20.0);

    assertThat(autopilot.phase()).isEqualTo(FlightPhase.FLARE);
    assertThat(autopilot.pitchDemandRad()).isCloseTo(pitchRad, within(Math.toRadians(0.5)));
  }

  private Surfaces start(States states) {
    return start(states, 100.0);
  }

  /**
   * @param aboveM height of the target above the aircraft
   */
  private Surfaces start(States states, double aboveM) {
    Surfaces surfaces = null;
    for (int i = 0; i < 2; i++) {
      FlightState state = states.time(i * DT_S).now();
      surfaces =
          autopilot.step(
              state,
              Optional.of(
                  new GuidanceTarget(
                      0.0, 500.0, state.altitudeM() + aboveM, OptionalDouble.empty())));
    }
    return surfaces;
  }
}
