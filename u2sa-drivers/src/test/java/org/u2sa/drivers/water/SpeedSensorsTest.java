package org.u2sa.drivers.water;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.WaterSpeedSensor;
import org.u2sa.device.WheelEncoderSensor;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedEncoder;
import org.u2sa.sim.device.SimulatedVelocityLog;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.ServiceKit;

/** The services that measure speeds along the vehicle's axes. */
class SpeedSensorsTest {
  private final ServiceKit kit = new ServiceKit();
  private double aboveBottomM = 10.0;

  @AfterEach
  void end() {
    kit.close();
  }

  private StateInformation sensed() {
    return kit.latest(Channels.SENSED_STATE).orElseThrow();
  }

  @Test
  void waterSpeed_currentFromTheLeft_isTheDifference() {
    VehicleTruth north =
        new VehicleTruth(
            0.0,
            Point.ORIGIN,
            new Attitude(0.0, 0.0, 0.0),
            Point.of(0.5, 2.0, 0.0),
            Point.ORIGIN,
            Point.ORIGIN);
    SimulatedVelocityLog log =
        new SimulatedVelocityLog(
            new SensorErrors(5.0, 0.0, 0.0, 0.0, 0.0),
            50.0,
            new NoiseStreams(1),
            () -> north,
            () -> Point.of(0.5, 0.0, 0.0),
            () -> aboveBottomM);
    kit.start(context -> new WaterSpeedSensor(context, log));
    kit.advance(1.0);
    assertThat(sensed().referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(sensed().xDot().orElseThrow()).isCloseTo(2.0, within(1e-9));
    assertThat(sensed().yDot().orElseThrow()).as("left").isCloseTo(-0.5, within(1e-9));
    assertThat(sensed().fluidxDot().orElseThrow()).isCloseTo(2.0, within(1e-9));
    assertThat(sensed().fluidyDot().orElseThrow()).isCloseTo(0.0, within(1e-9));
    assertThat(sensed().xDotSigma()).hasValue(0.02);
    assertThat(sensed().fluidyDotSigma()).hasValue(0.05);

    aboveBottomM = 80.0;
    kit.advance(1.0);
    assertThat(sensed().xDot()).as("no bottom in reach").isEmpty();
    assertThat(sensed().fluidxDot()).isPresent();
  }

  @Test
  void encoders_wheelsAtOneAndTwoTurnsASecond_areSpeedAndTurn() {
    SimulatedEncoder encoder =
        new SimulatedEncoder(
            50.0,
            1000.0,
            0.0,
            new NoiseStreams(1),
            () -> 2.0 * Math.PI * kit.nowS(),
            () -> -4.0 * Math.PI * kit.nowS());
    kit.with("COUNTS PER TURN", 1000.0).with("WHEEL DIAMETER", 0.3).with("TRACK", 0.6);
    kit.with("RIGHT REVERSED", true);
    kit.start(context -> new WheelEncoderSensor(context, encoder));
    kit.advance(3.0);
    double turnM = Math.PI * 0.3;
    assertThat(sensed().xDot().orElseThrow()).isCloseTo(1.5 * turnM, within(0.01));
    assertThat(sensed().psiDot().orElseThrow()).as("left").isCloseTo(turnM / 0.6, within(0.02));
    assertThat(sensed().yDot()).hasValue(0.0);
    assertThat(sensed().xDotSigma()).isPresent();
    assertThat(sensed().sensorName()).isEqualTo("WheelEncoderSensor");
    assertThat(kit.published(Channels.SENSED_STATE)).as("10 Hz").hasSizeBetween(27, 31);
  }

  @Test
  void encoders_countFromZeroAgain_makeNoJump() {
    double[] offset = {0.0};
    SimulatedEncoder encoder =
        new SimulatedEncoder(
            50.0,
            1000.0,
            0.0,
            new NoiseStreams(1),
            () -> kit.nowS() + offset[0],
            () -> kit.nowS() + offset[0]);
    kit.with("COUNTS PER TURN", 1000.0).with("WHEEL DIAMETER", 0.3);
    kit.start(context -> new WheelEncoderSensor(context, encoder));
    kit.advance(2.0);
    encoder.plug(false);
    kit.advance(1.0);
    offset[0] = -5.0; // so few that the speed would be plausible
    encoder.plug(true);
    kit.advance(2.0);
    assertThat(kit.published(Channels.SENSED_STATE))
        .hasSizeGreaterThan(30)
        .allMatch(state -> Math.abs(state.xDot().orElseThrow() - 0.15) < 0.02);
  }
}
