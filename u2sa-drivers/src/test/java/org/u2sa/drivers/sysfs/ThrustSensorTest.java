package org.u2sa.drivers.sysfs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.payload.ThrustSensor;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedLoadCell;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.ServiceKit;

/** Thrust of 30 N on a vehicle of 15 kg. */
class ThrustSensorTest {
  private final ServiceKit kit = new ServiceKit().with("MASS", 15.0);

  @AfterEach
  void end() {
    kit.close();
  }

  private StateInformation sensed() {
    SensorErrors exact = new SensorErrors(20.0, 0.0, 0.0, 0.0, 0.0);
    kit.start(
        context ->
            new ThrustSensor(
                context, new SimulatedLoadCell(exact, new NoiseStreams(1), () -> 30.0)));
    kit.advance(0.5);
    return kit.latest(Channels.SENSED_STATE).orElseThrow();
  }

  @Test
  void step_thrustAhead_isAccelerationAheadOnly() {
    kit.with("THRUST SIGMA", 6.0).with("OTHER FORCES SIGMA", 0.3);
    StateInformation state = sensed();

    assertThat(state.referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(state.xDoubleDot().orElseThrow()).isCloseTo(2.0, within(1e-9));
    assertThat(state.number(StateField.X_DOUBLE_DOT_SIGMA).orElseThrow())
        .isCloseTo(0.5, within(1e-9));
    assertThat(state.yDoubleDot()).isEmpty();
    assertThat(state.zDoubleDot()).isEmpty();
  }

  @Test
  void step_thrusterTurnedToTheLeft_isAccelerationThere() {
    kit.with("MOUNTED YAW", Math.toRadians(30.0)).with("MOUNTED X", -0.5);
    StateInformation state = sensed();

    assertThat(state.xDoubleDot().orElseThrow()).isCloseTo(Math.sqrt(3.0), within(1e-9));
    assertThat(state.yDoubleDot().orElseThrow()).isCloseTo(1.0, within(1e-9));
  }
}
