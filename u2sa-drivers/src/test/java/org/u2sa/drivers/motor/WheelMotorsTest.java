package org.u2sa.drivers.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.u2sa.device.WheelMotors;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.command.SpeedCommand;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.testkit.ServiceKit;

/** Two wheels at a RoboClaw that is simulated byte for byte, in simulated time. */
class WheelMotorsTest {
  private static final double NEAR = 0.001;

  private final ServiceKit kit = new ServiceKit().with("COUNTS PER TURN", 1000.0);
  private final MemoryLink link = new MemoryLink();
  private final SimulatedRoboClaw device = new SimulatedRoboClaw(link, kit.clock()::micros);
  private double serialTimeoutS = 0.3;
  private WheelMotors motors;

  @AfterEach
  void end() {
    kit.close();
  }

  private RoboClaw roboClaw(ByteLink line) {
    return new RoboClaw(line, 128, serialTimeoutS);
  }

  private void start() {
    motors = kit.start(context -> new WheelMotors(context, roboClaw(link)));
  }

  /** Commands both wheels at 20 Hz for a span [s]. */
  private void command(double left, double right, double seconds) {
    double untilS = kit.nowS() + seconds - 1.0e-9;
    while (kit.nowS() < untilS) {
      kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT MOTOR", left));
      kit.publish(Channels.ACTUATION, PercentageCommand.of("RIGHT MOTOR", right));
      kit.advance(0.05);
    }
  }

  private StateInformation state() {
    return kit.latest(Channels.SENSED_STATE).orElseThrow();
  }

  private boolean isDriving() {
    return device.duty(0) != 0.0 || device.duty(1) != 0.0;
  }

  @Test
  void step_commands_turnTheWheelsAndTheirSpeedsArePublished() {
    start();
    command(50.0, 25.0, 2.0);
    assertThat(device.duty(0)).isCloseTo(0.5, within(NEAR));
    assertThat(device.duty(1)).isCloseTo(0.25, within(NEAR));
    // 2000 and 1000 counts a second are 2 and 1 turns of 0.25 m: 1.571 and 0.785 m/s
    assertThat(state().xDot().getAsDouble()).isCloseTo(1.178, within(0.01));
    assertThat(state().psiDot().getAsDouble()).as("to the right").isCloseTo(-1.571, within(0.03));
    assertThat(state().sensorName()).isEqualTo("WheelMotors");
    assertThat(kit.latest(Channels.POWER).orElseThrow().voltage()).hasValue(12.4);
    assertThat(kit.published(Channels.SENSED_STATE)).hasSizeBetween(15, 20);
  }

  @Test
  void step_speedCommands_areHeldByTheControllersOwnLoops() {
    kit.with("LEFT MOTOR FULL SPEED", 25.0).with("RIGHT MOTOR FULL SPEED", 25.0);
    kit.with("RIGHT REVERSED", true);
    start();
    for (int i = 0; i < 40; i++) {
      kit.publish(Channels.ACTUATION, SpeedCommand.of("LEFT MOTOR", 4.0 * Math.PI));
      kit.publish(Channels.ACTUATION, SpeedCommand.of("RIGHT MOTOR", 2.0 * Math.PI));
      kit.advance(0.05);
    }
    // 2 turns a second are 2000 counts a second, half of what full duty gives
    assertThat(device.duty(0)).isCloseTo(0.5, within(NEAR));
    assertThat(device.duty(1)).isCloseTo(-0.25, within(NEAR));
    assertThat(state().xDot().getAsDouble()).isCloseTo(1.178, within(0.01));

    command(50.0, 25.0, 0.5); // percentages again
    assertThat(device.duty(0)).isCloseTo(0.5, within(NEAR));
  }

  @Test
  void step_deviceLost_withdrawsTheActuatorsAndBringsThemBack() {
    start();
    command(50.0, 50.0, 1.0);
    assertThat(availableOfBoth()).containsExactly(100.0, 100.0);

    device.fault(SimulatedRoboClaw.Fault.MUTE);
    kit.advance(1.0);
    assertThat(availableOfBoth()).containsExactly(0.0, 0.0);

    device.fault(SimulatedRoboClaw.Fault.NONE);
    kit.advance(1.0);
    assertThat(availableOfBoth()).containsExactly(100.0, 100.0);
  }

  private List<Double> availableOfBoth() {
    List<Double> last = new ArrayList<>();
    for (String name : List.of("LEFT MOTOR", "RIGHT MOTOR")) {
      kit.published(Channels.ACTUATORS).stream()
          .filter(each -> each.actuatorName().equals(name))
          .reduce((first, second) -> second)
          .ifPresent(each -> last.add(each.available().orElse(100.0)));
    }
    return last;
  }

  @Test
  void step_start_toldItsSerialTimeoutBeforeItDrives() {
    serialTimeoutS = 0.4;
    start();
    command(50.0, 50.0, 0.5);
    assertThat(device.serialTimeout()).isEqualTo(4);
  }

  @Test
  void step_reversedWheelAtTheOtherChannel_forwardIsForward() {
    kit.with("LEFT REVERSED", true).with("LEFT IS SECOND", true);
    start();
    command(50.0, 50.0, 1.0);
    assertThat(device.duty(1)).isCloseTo(-0.5, within(NEAR));
    assertThat(device.duty(0)).isCloseTo(0.5, within(NEAR));
    assertThat(state().xDot().getAsDouble()).isCloseTo(1.571, within(0.02));
    assertThat(state().psiDot().getAsDouble()).isCloseTo(0.0, within(0.03));
  }

  @Test
  void step_slewLimit_growsNoFaster() {
    kit.with("SLEW LIMIT", 50.0);
    start();
    command(100.0, 100.0, 1.0);
    assertThat(device.duty(0)).isBetween(0.4, 0.51);
  }

  @Test
  void step_noCommandInTime_bothOff() {
    start();
    command(50.0, 50.0, 1.0);
    kit.advance(0.6);
    assertThat(isDriving()).isFalse();
  }

  @Test
  void step_onlyOneWheelIsCommanded_bothStayOff() {
    start();
    for (int i = 0; i < 10; i++) {
      kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT MOTOR", 80.0));
      kit.advance(0.05);
    }
    assertThat(isDriving()).isFalse();
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().exceptions()).isZero();
  }

  @Test
  void callback_emergencyStop_isOffBeforeTimePassesAndStaysOff() {
    start();
    command(50.0, 50.0, 1.0);
    kit.publish(
        Channels.EMERGENCY_STOP,
        new EmergencyStop().operator("the test").reason("test").active(true));
    assertThat(isDriving()).isFalse();
    command(50.0, 50.0, 0.5);
    assertThat(isDriving()).isFalse();
  }

  /** The same line for two services, of which the first one leaves it to the second. */
  private static final class Shared implements ByteLink {
    private final ByteLink line;
    private boolean closed;

    Shared(ByteLink line) {
      this.line = line;
    }

    @Override
    public boolean isConnected() {
      return line.isConnected();
    }

    @Override
    public int connections() {
      return line.connections();
    }

    @Override
    public String trouble() {
      return line.trouble();
    }

    @Override
    public int read(byte[] buffer) {
      return line.read(buffer);
    }

    @Override
    public boolean write(byte[] bytes) {
      return line.write(bytes);
    }

    @Override
    public void close() {
      closed = true;
    }
  }

  @Test
  void swap_driving_theWheelsTurnOnWithoutABumpUntilTheCommandExpires() {
    kit.with("SLEW LIMIT", 100.0);
    Shared shared = new Shared(link);
    motors = kit.start(context -> new WheelMotors(context, roboClaw(shared)));
    command(50.0, 40.0, 1.0);
    assertThat(device.duty(0)).isCloseTo(0.5, within(NEAR));

    WheelMotors successor = kit.swap(motors, context -> new WheelMotors(context, roboClaw(link)));

    assertThat(shared.closed).isTrue();
    for (int i = 0; i < 40; i++) { // the last commands are 0.05 s old and hold for 0.5 s
      kit.advance(0.01);
      assertThat(device.duty(0)).as("after %d steps", i).isCloseTo(0.5, within(NEAR));
      assertThat(device.duty(1)).as("after %d steps", i).isCloseTo(0.4, within(NEAR));
    }
    kit.advance(0.2);
    assertThat(isDriving()).isFalse();
    assertThat(successor.isRunning()).isTrue();
  }

  @Test
  void swap_stopped_staysOff() {
    Shared shared = new Shared(link);
    motors = kit.start(context -> new WheelMotors(context, roboClaw(shared)));
    command(50.0, 50.0, 1.0);
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).operator("test"));

    kit.swap(motors, context -> new WheelMotors(context, roboClaw(link)));
    command(50.0, 50.0, 0.5);

    assertThat(isDriving()).isFalse();
  }

  @Test
  void kill_driving_leavesTheMotorsOffAndTheLinkClosed() {
    start();
    command(50.0, 50.0, 1.0);
    motors.kill();
    assertThat(isDriving()).isFalse();
    assertThat(link.isClosed()).isTrue();
  }

  @ParameterizedTest
  @EnumSource(
      value = SimulatedRoboClaw.Fault.class,
      names = {"NONE"},
      mode = EnumSource.Mode.EXCLUDE)
  void step_faultyAnswers_areOffAndSaidAndItGoesOnWithinTwoSeconds(SimulatedRoboClaw.Fault fault) {
    start();
    command(50.0, 50.0, 1.0);
    device.fault(fault);
    command(50.0, 50.0, 1.0);
    assertThat(isDriving()).isFalse();
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError))
        .hasValueSatisfying(error -> assertThat(error).contains("the motor controller"));
    kit.forget();
    device.fault(SimulatedRoboClaw.Fault.NONE);
    command(50.0, 50.0, 2.0);
    assertThat(device.duty(0)).isCloseTo(0.5, within(NEAR));
    assertThat(state().xDot().getAsDouble()).isCloseTo(1.571, within(0.02));
    assertThat(kit.published(Channels.SENSED_STATE))
        .as("no jump")
        .allSatisfy(state -> assertThat(state.xDot().getAsDouble()).isBetween(-0.01, 1.6));
  }

  @Test
  void step_unplugged_stopsByItsOwnTimeoutAndGoesOnWithinTwoSecondsOfReturn() {
    start();
    command(50.0, 50.0, 1.0);
    link.unplug();
    command(50.0, 50.0, 0.4);
    assertThat(isDriving()).as("its own time-out is 0.3 s").isFalse();
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError))
        .hasValue("the motor controller is lost: unplugged");
    kit.advance(3.0);
    kit.forget();
    device.reboot();
    link.plug();
    command(50.0, 50.0, 2.0);
    assertThat(device.duty(1)).isCloseTo(0.5, within(NEAR));
    assertThat(device.serialTimeout()).as("told again").isEqualTo(3);
    assertThat(kit.published(Channels.SENSED_STATE))
        .isNotEmpty()
        .allSatisfy(state -> assertThat(state.xDot().getAsDouble()).isBetween(-0.01, 1.6));
  }

  @Test
  void step_commandsEndWhileItIsUnplugged_comesBackOff() {
    start();
    command(50.0, 50.0, 1.0);
    link.unplug();
    kit.advance(1.0);
    link.plug();
    for (int i = 0; i < 200; i++) {
      kit.advance(0.01);
      assertThat(isDriving()).isFalse();
    }
  }

  @Test
  void step_randomBytes_noExceptionAndNothingMoves() {
    device.fault(SimulatedRoboClaw.Fault.MUTE);
    start();
    Random random = new Random(4);
    for (int i = 0; i < 300; i++) {
      byte[] noise = new byte[random.nextInt(40)];
      random.nextBytes(noise);
      link.fromDevice(noise);
      command(70.0, 70.0, 0.01);
      assertThat(isDriving()).isFalse();
    }
    kit.advance(0.5);
    HealthReport health = kit.latest(Channels.HEALTH).orElseThrow();
    assertThat(health.exceptions()).isZero();
    assertThat(health.lastError()).isPresent();
  }

  @Test
  void constructor_bothWheelsOfOneName_isRefused() {
    kit.with("RIGHT ACTUATOR", "LEFT MOTOR");
    assertThatThrownBy(this::start)
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("both \"LEFT MOTOR\"");
  }

  @Test
  void begin_nobodyThere_runsAndSaysSo() {
    link.unplug();
    start();
    command(50.0, 50.0, 2.5);
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError))
        .hasValue("the motor controller is lost: unplugged");
    assertThat(kit.published(Channels.SENSED_STATE)).isEmpty();
  }
}
