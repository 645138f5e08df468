package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.sim.atmosphere.Wind;

/** A pilot with a multiplexer takes a multirotor over and gives it back. */
class PilotedRotorsTest {
  private static final Point HERE = Point.of(0.0, 0.0, -25.0);
  private static final Point ELSEWHERE = Point.of(30.0, -10.0, -28.0);

  private static ManualState byHand(boolean active) {
    return new ManualState().active(active).operator("pilot").takeovers(1L);
  }

  /** While the pilot holds the hover, the control goes on wanting to be elsewhere. */
  @ParameterizedTest
  @CsvSource({"4, 2", "6, 2", "6, 4", "8, 3"})
  void handBack_controlWantedToBeElsewhere_staysUpright(int rotors, double seconds) {
    try (RotorFlight flight = new RotorFlight(rotors, Wind.calm())) {
      flight.target = HERE;
      flight.fly(20.0);
      flight.isCutOff = true;
      flight.target = ELSEWHERE;
      for (double t = 0.0; t < seconds; t += 0.5) {
        flight.kit.publish(Channels.MANUAL_STATE, byHand(true));
        flight.fly(0.5);
      }
      assertThat(flight.steepestDeg(seconds)).as("by hand").isLessThan(5.0);

      flight.isCutOff = false;
      flight.target = HERE;
      flight.kit.publish(Channels.MANUAL_STATE, byHand(false));
      flight.fly(8.0);
      assertThat(flight.steepestDeg(8.0)).isLessThan(40.0);
      assertThat(flight.lowestM(8.0)).isGreaterThan(24.0);
      assertThat(flight.worstM(1.0)).isLessThan(0.5);
    }
  }

  /** The pilot's radio ends without a word: this control flies, with integrals again. */
  @ParameterizedTest
  @CsvSource({"4", "6"})
  void radioFallsSilent_controlFliesAgain(int rotors) {
    try (RotorFlight flight = new RotorFlight(rotors, Wind.gusty(1.9, 4.0, 7L))) {
      flight.target = HERE;
      flight.fly(10.0);
      flight.kit.publish(Channels.MANUAL_STATE, byHand(true));
      flight.fly(20.0);
      assertThat(flight.worstM(5.0)).isLessThan(0.5);
    }
  }
}
