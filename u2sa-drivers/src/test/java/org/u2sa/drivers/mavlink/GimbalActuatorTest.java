package org.u2sa.drivers.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.payload.GimbalActuator;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.AngleCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.sim.payload.SimulatedGimbal;
import org.u2sa.testkit.ServiceKit;

/** The service of a gimbal, over MAVLink byte for byte and over the simulated one. */
class GimbalActuatorTest {
  private final ServiceKit kit = new ServiceKit();
  private final MemoryLink link = new MemoryLink();
  private final SimulatedMavlinkGimbal gimbal = new SimulatedMavlinkGimbal(link);
  private final MavlinkGimbal device = new MavlinkGimbal(link, GimbalPortTest.FIRST);

  @AfterEach
  void end() {
    kit.close();
  }

  private void start() {
    kit.start(context -> new GimbalActuator(context, device));
  }

  private void command(double panRad, double tiltRad, double seconds) {
    for (int i = 0; i < Math.round(seconds * 20.0); i++) {
      kit.publish(Channels.ACTUATION, AngleCommand.of("PAN", panRad));
      kit.publish(Channels.ACTUATION, AngleCommand.of("TILT", tiltRad));
      kit.advance(0.05);
    }
  }

  private void assertLooks(double panRad, double tiltRad) {
    assertThat(gimbal.looks())
        .as("forward, right, down")
        .containsExactly(
            new double[] {
              Math.cos(tiltRad) * Math.cos(panRad),
              -Math.cos(tiltRad) * Math.sin(panRad),
              -Math.sin(tiltRad)
            },
            within(2e-3));
  }

  @Test
  void begin_gimbal_announcesBothAxesOfItsSubsystem() {
    start();
    List<ActuatorAnnouncement> all = kit.published(Channels.ACTUATORS);

    assertThat(all).extracting(ActuatorAnnouncement::actuatorName).containsExactly("PAN", "TILT");
    assertThat(all).allMatch(each -> each.subsystem().equals("GIMBAL"));
    assertThat(all.get(1).fullAngle().orElseThrow()).isCloseTo(Math.PI / 2.0, within(1e-9));
    assertThat(all.get(1).maximum()).isCloseTo(100.0 / 3.0, within(1e-9));
  }

  @Test
  void step_angles_looksLeftAndDownByThem() {
    start();
    command(0.6, -0.4, 2.0);

    assertLooks(0.6, -0.4);
    assertThat(gimbal.flags()).as("yaw in the vehicle's frame").isEqualTo(32);
    assertThat(gimbal.heartbeats()).isGreaterThanOrEqualTo(2);
  }

  @Test
  void step_commandsEnd_holdsItsAngles() {
    start();
    command(0.6, -0.4, 2.0);
    kit.advance(5.0);

    assertLooks(0.6, -0.4);
  }

  @Test
  void step_commandsEndWithNeutral_returnsAhead() {
    kit.with("WITHOUT COMMANDS", "NEUTRAL");
    start();
    command(0.6, -0.4, 2.0);
    kit.advance(3.0);

    assertLooks(0.0, 0.0);
  }

  @Test
  void emergencyStop_whileItTurns_standsStillAtOnce() {
    start();
    command(1.5, 0.0, 0.5);
    kit.send(
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(true).operator("test").reason("because"));
    kit.advance(0.1);
    double[] then = gimbal.looks();
    command(1.5, 0.0, 2.0);

    assertThat(gimbal.looks()).containsExactly(then, within(1e-6));
    assertThat(Math.asin(-then[1])).as("at 1.5 rad/s").isBetween(0.5, 0.85);
  }

  @Test
  void status_inTheEarthsFrameOrNoRotation_isNoReading() {
    device.read(1);
    link.fromDevice(gimbal.status(64, 0));
    assertThat(device.read(2)).isEmpty();
    link.fromDevice(gimbal.status(16, 0));
    assertThat(device.read(3)).isEmpty();
    link.fromDevice(gimbal.status(32, 8));
    assertThat(device.read(4)).isPresent();
    assertThat(device.trouble()).isEqualTo("the gimbal reports failures 8");
  }

  @Test
  void simulated_farTarget_turnsAtItsRateToItsLimit() {
    SimulatedGimbal simulated = new SimulatedGimbal(GimbalPortTest.DRIVE);
    simulated.point(3.0, -3.0);
    simulated.read(0);
    assertThat(simulated.read(1_000_000).orElseThrow().panRad()).isCloseTo(1.0, within(0.01));
    for (long now = 1_000_000; now <= 6_000_000; now += 50_000) {
      simulated.read(now);
    }
    assertThat(simulated.read(6_050_000).orElseThrow().panRad()).isCloseTo(2.0, within(1e-3));
    assertThat(simulated.read(6_050_000).orElseThrow().tiltRad()).isCloseTo(-1.5, within(1e-3));
  }
}
