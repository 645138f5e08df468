package org.u2sa.drivers.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.servo.ServoActuator;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.AngleCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.testkit.ServiceKit;

/** The service of one servo, over a Maestro byte for byte: 600 µs per radian at channel 3. */
class ServoActuatorTest {
  private final ServiceKit kit =
      new ServiceKit().with("ACTUATOR NAME", "ELEVATOR").with("TRAVEL", 0.5);
  private final MemoryLink link = new MemoryLink();
  private final SimulatedMaestro maestro = new SimulatedMaestro(link);

  @AfterEach
  void end() {
    kit.close();
  }

  private void start() {
    kit.start(context -> new ServoActuator(context, new Maestro(link, ServoPortTest.WIRING)));
  }

  private void command(double percent, double seconds) {
    for (int i = 0; i < Math.round(seconds * 20.0); i++) {
      kit.publish(Channels.ACTUATION, PercentageCommand.of("ELEVATOR", percent));
      kit.advance(0.05);
    }
  }

  private double pulseUs() {
    return maestro.pulseUs(3);
  }

  @Test
  void begin_servo_announcesItsTravelAndRate() {
    kit.with("RATE LIMIT", 2.0).with("MINIMUM", 0.0);
    start();
    ActuatorAnnouncement said = kit.latest(Channels.ACTUATORS).orElseThrow();

    assertThat(said.actuatorName()).isEqualTo("ELEVATOR");
    assertThat(said.minimum()).isZero();
    assertThat(said.maximum()).isEqualTo(100.0);
    assertThat(said.rateLimit()).hasValue(400.0);
    assertThat(said.effect()).isEqualTo("turns by 28.6 deg at 100 %");
  }

  @Test
  void step_command_turnsByItsShareOfTheTravelFromTheTrim() {
    kit.with("NEUTRAL ANGLE", 0.1);
    start();
    command(-60.0, 1.0);

    assertThat(pulseUs()).isCloseTo(1500.0 + 600.0 * (0.1 - 0.6 * 0.5), within(0.25));
  }

  @Test
  void step_reversed_turnsBackwards() {
    kit.with("REVERSED", true);
    start();
    command(100.0, 1.0);

    assertThat(pulseUs()).isCloseTo(1200.0, within(0.25));
  }

  @Test
  void step_beyondTheLinkage_staysAtItsEnd() {
    kit.with("MAXIMUM ANGLE", 0.2);
    start();
    command(100.0, 1.0);

    assertThat(pulseUs()).isCloseTo(1620.0, within(0.25));
  }

  @Test
  void step_rateLimit_takesItsTime() {
    kit.with("RATE LIMIT", 0.5);
    start();
    command(100.0, 0.5);

    assertThat(pulseUs()).isBetween(1500.0 + 600.0 * 0.2, 1500.0 + 600.0 * 0.26);
  }

  @Test
  void step_commandsEnd_returnsToNeutral() {
    start();
    command(100.0, 1.0);
    kit.advance(2.0);

    assertThat(pulseUs()).isEqualTo(1500.0);
  }

  @Test
  void emergencyStop_deflected_returnsToNeutral() {
    start();
    command(100.0, 1.0);
    kit.send(
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(true).operator("test").reason("because"));
    command(100.0, 0.5);

    assertThat(pulseUs()).isEqualTo(1500.0);
  }

  @Test
  void step_angle_turnsByIt() {
    start();
    for (int i = 0; i < 20; i++) {
      kit.publish(Channels.ACTUATION, AngleCommand.of("ELEVATOR", 0.2));
      kit.advance(0.05);
    }

    assertThat(pulseUs()).isCloseTo(1620.0, within(0.25));
  }

  @Test
  void emergencyStop_withHold_staysWhereItIs() {
    kit.with("WITHOUT COMMANDS", "HOLD");
    start();
    command(40.0, 1.0);
    kit.send(
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(true).operator("test").reason("because"));
    command(100.0, 1.0);

    assertThat(pulseUs()).isCloseTo(1620.0, within(0.25));
  }
}
