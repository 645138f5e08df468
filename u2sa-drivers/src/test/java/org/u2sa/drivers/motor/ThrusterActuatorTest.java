package org.u2sa.drivers.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.device.ThrusterActuator;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.sim.device.SimulatedThruster;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.testkit.ServiceKit;

/** One thruster service, over a VESC byte for byte and over a simulated T200. */
class ThrusterActuatorTest {
  private final ServiceKit kit = new ServiceKit().with("ACTUATOR NAME", "STARBOARD");
  private final MemoryLink link = new MemoryLink();
  private final SimulatedVesc vesc = new SimulatedVesc(link, kit.clock()::micros);
  private final SimulatedThruster t200 =
      new SimulatedThruster(SimulatedThruster.Propeller.t200(), new NoiseStreams(1), "starboard");

  @AfterEach
  void end() {
    kit.close();
  }

  private ThrusterActuator startVesc() {
    return kit.start(context -> new ThrusterActuator(context, new Vesc(link, 7)));
  }

  private void startT200() {
    kit.start(context -> new ThrusterActuator(context, t200));
  }

  private void command(double percent, double seconds) {
    for (int i = 0; i < Math.round(seconds * 20.0); i++) {
      kit.publish(Channels.ACTUATION, PercentageCommand.of("STARBOARD", percent));
      kit.advance(0.05);
    }
  }

  private double thrustN() {
    return t200.thrustN(kit.clock().micros());
  }

  private String lastError() {
    return kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError).orElse("");
  }

  @Test
  void begin_mountedTurnedAndPlaced_announcesItsForceAndMoment() {
    kit.with("FULL THRUST", 51.5).with("REVERSE THRUST", 40.2).with("MINIMUM", -80.0);
    kit.with("MOUNTED X", -0.5).with("MOUNTED Y", 0.3).with("MOUNTED YAW", Math.PI / 2.0);
    startVesc();
    ActuatorAnnouncement said = kit.latest(Channels.ACTUATORS).orElseThrow();
    assertThat(said.actuatorName()).isEqualTo("STARBOARD");
    assertThat(said.minimum()).isEqualTo(-80.0);
    assertThat(said.maximum()).isEqualTo(100.0);
    assertThat(said.effect().replace("-0.000", "0.000"))
        .isEqualTo("pushes along (0.000, -1.000, 0.000) at (-0.500, -0.300, 0.000) m");
    assertThat(said.force().orElseThrow().distanceTo(Point.of(0.0, -51.5, 0.0))).isLessThan(1e-9);
    assertThat(said.moment().orElseThrow().distanceTo(Point.of(0.0, 0.0, 25.75))).isLessThan(1e-9);
    assertThat(said.reverseForce().orElseThrow().distanceTo(Point.of(0.0, 40.2, 0.0)))
        .isLessThan(1e-9);
    assertThat(said.exponent()).hasValue(2.0);
    assertThat(said.commandTypes()).contains("ForceCommand");
  }

  @Test
  void step_command_reachesTheMotorAndItsBatteryIsPublished() {
    startVesc();
    command(40.0, 1.0);
    assertThat(vesc.duty()).isCloseTo(0.4, within(1e-5));
    assertThat(kit.latest(Channels.POWER).orElseThrow().voltage()).hasValue(16.0);
    command(-40.0, 1.5);
    assertThat(vesc.duty()).isCloseTo(-0.4, within(1e-5));
  }

  @Test
  void step_reversed_turnsTheOtherWay() {
    kit.with("REVERSED", true);
    startVesc();
    command(40.0, 1.0);
    assertThat(vesc.duty()).isCloseTo(-0.4, within(1e-5));
  }

  @Test
  void step_slewLimit_growsNoFaster() {
    kit.with("SLEW LIMIT", 20.0);
    startVesc();
    command(100.0, 1.0);
    assertThat(vesc.duty()).isBetween(0.15, 0.21);
  }

  @Test
  void step_belowItsDeadband_isZero() {
    kit.with("DEADBAND", 10.0);
    startVesc();
    command(9.0, 1.0);
    assertThat(vesc.duty()).isZero();
    command(11.0, 1.0);
    assertThat(vesc.duty()).isCloseTo(0.11, within(1e-5));
  }

  @Test
  void step_noCommandInTime_stands() {
    startVesc();
    command(40.0, 1.0);
    kit.advance(0.6);
    assertThat(vesc.duty()).isZero();
  }

  @Test
  void emergencyStop_running_standsAtOnce() {
    startVesc();
    command(40.0, 1.0);
    kit.publish(
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(true).operator("test").reason("because"));
    assertThat(vesc.duty()).isZero();
    command(40.0, 0.5);
    assertThat(vesc.duty()).isZero();
  }

  @Test
  void kill_running_stands() {
    ThrusterActuator thruster = startVesc();
    command(40.0, 1.0);
    thruster.kill();
    assertThat(vesc.duty()).isZero();
    assertThat(link.isClosed()).isTrue();
  }

  @Test
  void step_pluggedInAgain_growsFromZero() {
    kit.with("SLEW LIMIT", 20.0);
    startVesc();
    command(40.0, 3.0);
    link.unplug();
    command(40.0, 1.5);
    link.plug();
    command(40.0, 0.5);
    assertThat(vesc.duty()).isBetween(0.05, 0.15);
  }

  @Test
  void step_blockedPropeller_isReported() {
    vesc.block();
    startVesc();
    command(15.0, 2.0);
    assertThat(lastError()).as("too little to be sure").isEmpty();
    command(60.0, 3.0);
    assertThat(lastError()).isEqualTo("the thruster does not turn at a command of 60 %");
    assertThat(kit.latest(Channels.ACTUATORS).orElseThrow().available()).hasValue(0.0);
    command(0.0, 12.0);
    assertThat(kit.latest(Channels.ACTUATORS).orElseThrow().available())
        .as("control may try again")
        .hasValue(100.0);
  }

  @Test
  void step_fault_isReported() {
    vesc.fault(4);
    startVesc();
    command(10.0, 2.0);
    assertThat(lastError()).isEqualTo("the VESC reports fault 4");
  }

  @Test
  void step_garbledAnswers_areCountedAndTheMotorObeys() {
    vesc.garble(true);
    startVesc();
    command(30.0, 3.0);
    assertThat(vesc.duty()).isCloseTo(0.3, within(1e-5));
    assertThat(lastError()).contains("the thruster sent invalid data");
    vesc.garble(false);
    command(30.0, 1.0);
    assertThat(kit.published(Channels.POWER)).isNotEmpty();
  }

  @Test
  void swap_running_goesOnWithoutAGap() {
    ThrusterActuator first = startVesc();
    command(40.0, 1.0);
    kit.swap(first, context -> new ThrusterActuator(context, new Vesc(link, 7)));
    assertThat(vesc.duty()).isCloseTo(0.4, within(1e-5));
  }

  @Test
  void simulated_command_pushesLateByTheSquareOfItsSpeed() {
    kit.with("SLEW LIMIT", 100_000.0);
    startT200();
    command(50.0, 0.1);
    assertThat(thrustN()).isBetween(0.5, 0.2 * 51.5);
    command(50.0, 2.0);
    assertThat(thrustN()).isCloseTo(0.25 * 51.5, within(0.05));
    command(-100.0, 3.0);
    assertThat(thrustN()).isCloseTo(-40.2, within(0.05));
  }

  @Test
  void simulated_withinItsDeadband_doesNotPush() {
    startT200();
    command(6.0, 2.0);
    assertThat(thrustN()).isZero();
  }

  @Test
  void simulated_unplugged_standsAfterItsTimeout() {
    startT200();
    command(50.0, 2.0);
    t200.plug(false);
    command(50.0, 0.4);
    assertThat(thrustN()).isGreaterThan(10.0);
    command(50.0, 2.0);
    assertThat(thrustN()).isCloseTo(0.0, within(0.01));
  }

  @Test
  void simulated_weakened_pushesLess_broken_isReported() {
    startT200();
    command(100.0, 2.0);
    t200.weaken(0.5);
    assertThat(thrustN()).isCloseTo(0.5 * 51.5, within(0.05));
    t200.weaken(0.0);
    command(100.0, 4.0);
    assertThat(thrustN()).isZero();
    assertThat(lastError()).isEqualTo("the thruster does not turn at a command of 100 %");
  }
}
