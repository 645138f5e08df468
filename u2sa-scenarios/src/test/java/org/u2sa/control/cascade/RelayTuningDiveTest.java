package org.u2sa.control.cascade;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.safety.ArmingState;

/** Relay auto-tuning of a six-thruster vehicle's yaw-rate loop. */
class RelayTuningDiveTest {
  private static ArmingState armed(boolean isArmed) {
    return new ArmingState().armed(isArmed);
  }

  @Test
  void tuneYaw_armed_staysBoundedAndWritesGainsThatHold() {
    try (SixThrusterDive dive = new SixThrusterDive(0.0, 0.0)) {
      dive.kit.publish(Channels.ARMING_STATE, armed(true));
      dive.dive(5.0);
      dive.control.setVariable("TUNE", "YAW");
      dive.dive(15.0);

      assertThat(dive.kit.log("Control"))
          .anySatisfy(
              line -> assertThat(line).contains("relay tuning of YAW: ultimate gain", "YAW GAIN"));
      assertThat(dive.worstM(15.0)).isLessThan(0.3);
      assertThat(dive.track.stream().mapToDouble(t -> Math.abs(t.rates().z())).max().orElseThrow())
          .isLessThan(1.0);
    }
  }

  @Test
  void tuneYaw_notArmed_isRefused() {
    try (SixThrusterDive dive = new SixThrusterDive(0.0, 0.0)) {
      dive.dive(1.0);
      dive.control.setVariable("TUNE", "YAW");
      dive.dive(2.0);

      assertThat(dive.kit.log("Control"))
          .anySatisfy(line -> assertThat(line).contains("refused: not armed"));
      assertThat(dive.worstHeadingDeg(0.0, 2.0)).isLessThan(0.5);
    }
  }
}
