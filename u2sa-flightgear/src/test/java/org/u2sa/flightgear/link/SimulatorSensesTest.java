package org.u2sa.flightgear.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.AircraftState;
import org.u2sa.messages.StateField;
import org.u2sa.testkit.ServiceKit;

/** What the Simulator lets out of the truth. */
class SimulatorSensesTest {
  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  private AircraftState sensed(boolean motion) {
    Path mission = Path.of("../missions/cessna/mission.xml").toAbsolutePath();
    kit.with("MISSION", mission.toString()).with("SENSES MOTION", motion).start(Simulator::new);
    kit.advance(1.0);
    return (AircraftState) kit.latest(Channels.SENSED_STATE).orElseThrow();
  }

  @Test
  void step_sensesNoMotion_saysNothingToNavigateBy() {
    AircraftState sensed = sensed(false);

    for (StateField field : StateField.values()) {
      assertThat(sensed.number(field)).as(field.fieldName()).isEmpty();
    }
    assertThat(sensed.calibratedAirspeed()).isEmpty();
    assertThat(sensed.weightOnWheels()).isTrue();
    assertThat(sensed.heightAboveGround()).isPresent();
    assertThat(sensed.engineRpm()).isPresent();
    assertThat(kit.latest(Simulator.TRUTH).orElseThrow().x()).as("for scoring").isPresent();
  }

  @Test
  void step_sensesMotion_saysAll() {
    assertThat(sensed(true).x()).isPresent();
  }
}
