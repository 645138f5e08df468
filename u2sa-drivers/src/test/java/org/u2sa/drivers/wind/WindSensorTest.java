package org.u2sa.drivers.wind;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.WindSensor;
import org.u2sa.device.port.Anemometer;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.sim.device.SensorErrors;
import org.u2sa.sim.device.SimulatedAnemometer;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.ServiceKit;

/** The service of an anemometer. */
class WindSensorTest {
  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void end() {
    kit.close();
  }

  private StateInformation sensed(Anemometer anemometer) {
    kit.start(context -> new WindSensor(context, anemometer));
    kit.advance(1.0);
    return kit.latest(Channels.SENSED_STATE).orElseThrow();
  }

  private static Anemometer exact(Point velocity, Point air) {
    VehicleTruth north =
        new VehicleTruth(
            0.0, Point.ORIGIN, new Attitude(0.0, 0.0, 0.0), velocity, Point.ORIGIN, Point.ORIGIN);
    return new SimulatedAnemometer(
        new SensorErrors(4.0, 0.0, 0.0, 0.0, 0.0),
        0.0,
        new NoiseStreams(1),
        () -> north,
        () -> air);
  }

  @Test
  void step_northboundInAWesterly_movesThroughTheAirForwardAndLeft() {
    StateInformation state = sensed(exact(Point.of(0.0, 3.0, 0.0), Point.of(4.0, 0.0, 0.0)));

    assertThat(state.referenceFrame()).isEqualTo(ReferenceFrame.BODY);
    assertThat(state.sensorName()).isEqualTo("WindSensor");
    assertThat(state.fluidxDot().orElseThrow()).isCloseTo(3.0, within(1e-9));
    assertThat(state.fluidyDot().orElseThrow()).isCloseTo(4.0, within(1e-9));
    assertThat(state.fluidzDot()).isEmpty();
  }

  @Test
  void step_windFromAhead_sigmasAreOfSpeedAndDirection() {
    StateInformation state = sensed(exact(Point.of(0.0, 10.0, 0.0), Point.ORIGIN));

    assertThat(state.fluidxDotSigma().orElseThrow()).isCloseTo(0.3, within(1e-9));
    assertThat(state.fluidyDotSigma().orElseThrow()).isCloseTo(0.35, within(1e-9));
  }

  @Test
  void step_instrumentTurnedToTheLeft_isMadeGoodByMountedYaw() {
    kit.with("MOUNTED YAW", Math.PI / 2.0);
    VehicleTruth west = // the instrument's zero points west on a vehicle that points north
        new VehicleTruth(
            0.0,
            Point.ORIGIN,
            new Attitude(0.0, 0.0, -Math.PI / 2.0),
            Point.of(0.0, 3.0, 0.0),
            Point.ORIGIN,
            Point.ORIGIN);

    StateInformation state =
        sensed(
            new SimulatedAnemometer(
                new SensorErrors(4.0, 0.0, 0.0, 0.0, 0.0),
                0.0,
                new NoiseStreams(1),
                () -> west,
                () -> Point.ORIGIN));

    assertThat(state.fluidxDot().orElseThrow()).isCloseTo(3.0, within(1e-9));
    assertThat(state.fluidyDot().orElseThrow()).isCloseTo(0.0, within(1e-9));
  }
}
