package org.u2sa.recorder;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.safety.EmergencyStop;

class RecordedChannelsTest {
  private static final int NUMBERS = 0xFFFF;

  private final RecordedChannels channels = new RecordedChannels();

  private RecordedChannels.Track actuator(int number) {
    return channels.of(
        "cessna",
        Channels.ACTUATORS,
        new ActuatorAnnouncement().actuatorName("a" + number).minimum(0.0).maximum(1.0));
  }

  @Test
  void of_sourcesWithoutEnd_leaveRoomForTheStandardOnes() {
    assertThatThrownBy(
            () -> {
              for (int i = 0; i < NUMBERS; i++) {
                actuator(i);
              }
            })
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("61439 channels of arbitrary names");

    assertThat(actuator(7)).as("one that is known").isSameAs(actuator(7));
    assertThat(channels.of("cessna", Channels.EMERGENCY_STOP, new EmergencyStop().active(true)))
        .isNotNull();
    assertThat(channels.of("cessna", Channels.STATE, new StateInformation())).isNotNull();
  }
}
