package org.u2sa.drivers.motor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.device.payload.SwitchKind;
import org.u2sa.device.payload.SwitchedActuator;
import org.u2sa.drivers.link.MemoryLink;
import org.u2sa.drivers.sysfs.SysfsOutput;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.sim.payload.SimulatedSwitch;
import org.u2sa.testkit.ServiceKit;

/** Grippers, releases, brakes and lights: what moves them, and above all what does not. */
class SwitchedActuatorTest {
  private final ServiceKit kit = new ServiceKit().with("ACTUATOR NAME", "HOOK");
  private final SimulatedSwitch output = new SimulatedSwitch(50.0, 0.0);

  @AfterEach
  void end() {
    kit.close();
  }

  private SwitchedActuator start(SwitchKind kind) {
    return kit.with("KIND", kind.name()).start(context -> new SwitchedActuator(context, output));
  }

  private void arm(boolean armed) {
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(armed));
    kit.advance(0.02);
  }

  private void stop() {
    kit.send(
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(true).operator("test").reason("because"));
    kit.advance(0.1);
  }

  private void command(double percent, double seconds) {
    for (int i = 0; i < Math.round(seconds * 20.0); i++) {
      kit.publish(Channels.ACTUATION, PercentageCommand.of("HOOK", percent));
      kit.advance(0.05);
    }
  }

  private double level() {
    return output.read(kit.clock().micros()).orElseThrow().percent().orElse(-1.0);
  }

  @ParameterizedTest
  @EnumSource(
      value = SwitchKind.class,
      names = {"GRIPPER", "LIGHT"})
  void step_withoutCommands_isLeftAsItIs(SwitchKind kind) {
    start(kind);
    kit.advance(1.0);
    assertThat(level()).as("not even touched").isEqualTo(-1.0);
    command(90.0, 0.5);
    kit.advance(5.0);
    assertThat(level()).as("the nearest position").isEqualTo(100.0);
    stop();
    command(0.0, 1.0);
    assertThat(level()).isEqualTo(100.0);
  }

  @Test
  void brake_withoutCommandsOrStopped_isEngaged() {
    start(SwitchKind.BRAKE);
    kit.advance(0.1);
    assertThat(level()).isEqualTo(100.0);
    command(0.0, 0.5);
    assertThat(level()).isZero();
    kit.advance(1.0);
    assertThat(level()).isEqualTo(100.0);
    command(0.0, 0.5);
    stop();
    assertThat(level()).isEqualTo(100.0);
  }

  @Test
  void brake_serviceEnds_isEngaged() {
    long endMicros;
    try (ServiceKit own = new ServiceKit().with("KIND", "BRAKE")) {
      own.start(context -> new SwitchedActuator(context, output));
      own.publish(Channels.ACTUATION, PercentageCommand.of("SwitchedActuator", 0.0));
      own.advance(0.1);
      endMicros = own.clock().micros();
      assertThat(output.read(endMicros).orElseThrow().percent()).hasValue(0.0);
    }
    assertThat(output.read(endMicros + 100_000).orElseThrow().percent()).hasValue(100.0);
  }

  @Test
  void release_armedSafeThenHeld_firesForItsTimeAndOnce() {
    kit.with("FIRE TIME", 0.5);
    start(SwitchKind.RELEASE);
    arm(true);
    command(0.0, 0.2);
    command(100.0, 0.8);
    assertThat(level()).as("held too short").isZero();
    command(100.0, 0.4);
    assertThat(level()).isEqualTo(100.0);
    command(100.0, 5.0);
    assertThat(level()).as("locked again").isZero();
  }

  private long refusals() {
    return kit.log("HOOK").stream().filter(line -> line.contains("stays locked")).count();
  }

  /** A planner goes on commanding the release for a while after it has fired. */
  @Test
  void release_commandLastsLongerThanItFires_isNoRefusal() {
    kit.with("FIRE TIME", 0.5).with("SERVICE NAME", "HOOK");
    start(SwitchKind.RELEASE);
    arm(true);
    command(0.0, 0.2);
    command(100.0, 3.0);
    assertThat(refusals()).isZero();

    kit.advance(1.0); // the command expires
    command(100.0, 3.0);
    assertThat(refusals()).as("without the safe position first").isOne();
  }

  @Test
  void release_disarmedWhileItFires_isARefusal() {
    kit.with("FIRE TIME", 60.0).with("SERVICE NAME", "HOOK");
    start(SwitchKind.RELEASE);
    arm(true);
    command(0.0, 0.2);
    command(100.0, 1.5);
    arm(false);
    command(100.0, 0.5);
    assertThat(refusals()).isOne();
  }

  @Test
  void release_notArmed_staysLockedWhateverRequiresArmingSays() {
    kit.with("REQUIRES ARMING", false);
    start(SwitchKind.RELEASE);
    command(0.0, 0.2);
    command(100.0, 5.0);
    assertThat(level()).isZero();
  }

  @Test
  void release_withoutTheSafePositionFirst_staysLocked() {
    start(SwitchKind.RELEASE);
    arm(true);
    command(100.0, 5.0);
    assertThat(level()).isZero();
  }

  @Test
  void release_gapInTheCommands_staysLocked() {
    start(SwitchKind.RELEASE);
    arm(true);
    command(0.0, 0.2);
    command(100.0, 0.8);
    kit.advance(0.7);
    command(100.0, 5.0);
    assertThat(level()).isZero();
  }

  @Test
  void release_stoppedOrDisarmedWhileFiring_locksAtOnceAndStaysSo() {
    kit.with("FIRE TIME", 60.0);
    start(SwitchKind.RELEASE);
    arm(true);
    command(0.0, 0.2);
    command(100.0, 1.5);
    assertThat(level()).isEqualTo(100.0);
    stop();
    assertThat(level()).isZero();
    kit.send(
        Channels.EMERGENCY_STOP, new EmergencyStop().active(false).operator("test").reason("over"));
    arm(true);
    command(100.0, 3.0);
    assertThat(level()).isZero();
  }

  @Test
  void release_safetyManagerSilent_staysLocked() {
    start(SwitchKind.RELEASE);
    arm(true);
    kit.advance(11.0); // ARMING EXPIRY
    command(0.0, 0.2);
    command(100.0, 3.0);
    assertThat(level()).isZero();
  }

  @Test
  void release_outputLost_staysLockedWhenItIsBack() {
    start(SwitchKind.RELEASE);
    arm(true);
    command(0.0, 0.2);
    command(100.0, 0.8);
    output.plug(false);
    command(100.0, 0.5);
    output.plug(true);
    command(100.0, 3.0);
    assertThat(level()).isZero();
  }

  @Test
  void release_anyEvents_neverFiresWithoutSafeThenHoldWhileArmed() {
    start(SwitchKind.RELEASE);
    Random random = new Random(7);
    boolean armed = false;
    boolean isSafeSeen = false;
    double heldS = 0.0;
    int fired = 0;
    for (int i = 0; i < 4_000; i++) {
      if (random.nextInt(300) == 0) {
        armed = !armed;
        isSafeSeen = false;
        arm(armed);
      }
      if (random.nextInt(40) == 0) {
        command(0.0, 0.05);
        isSafeSeen |= armed;
        heldS = 0.0;
      } else {
        command(100.0, 0.05);
        heldS += 0.05;
      }
      if (level() != 0.0) {
        fired++;
        assertThat(armed && isSafeSeen && heldS >= 0.95).as("step " + i).isTrue();
      }
    }
    assertThat(fired).isPositive();
  }

  @Test
  void release_whileItFires_announcesThatItHasMoved() {
    kit.with("FIRE TIME", 0.5);
    start(SwitchKind.RELEASE);
    arm(true);
    command(0.0, 0.5);
    assertThat(kit.latest(Channels.ACTUATORS).orElseThrow().percentage()).hasValue(0.0);
    command(100.0, 1.2);
    assertThat(kit.latest(Channels.ACTUATORS).orElseThrow().percentage()).hasValue(100.0);
    command(100.0, 0.5);
    assertThat(kit.latest(Channels.ACTUATORS).orElseThrow().percentage()).hasValue(0.0);
  }

  @Test
  void begin_announcesPositions() {
    kit.with("POSITIONS", "OFF 0, LOW 20, HIGH 100");
    start(SwitchKind.LIGHT);
    assertThat(kit.latest(Channels.ACTUATORS).orElseThrow().effect())
        .isEqualTo("OFF at 0 %, LOW at 20 %, HIGH at 100 %");
    command(30.0, 0.2);
    assertThat(level()).isEqualTo(20.0);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"OPEN 0", "OPEN 0, SHUT 0", "A 0, A 100", "A, B", "A 0, B 101", "A 0, B x"})
  void begin_positionsThatCannotBe_areRefused(String positions) {
    kit.with("POSITIONS", positions).with("KIND", "GRIPPER");
    assertThatThrownBy(() -> kit.start(context -> new SwitchedActuator(context, output)))
        .hasStackTraceContaining("POSITIONS: \"" + positions + "\": expected two or more names");
  }

  @Test
  void servoSwitch_beforeItsFirstLevel_sendsNoPulse() {
    MemoryLink link = new MemoryLink();
    SimulatedMaestro maestro = new SimulatedMaestro(link);
    ServoSwitch gripper = new ServoSwitch(new Maestro(link, ServoPortTest.WIRING), -0.5, 0.5);
    gripper.read(1);
    assertThat(maestro.pulseUs(3)).isZero();
    gripper.set(100.0);
    gripper.read(2);
    assertThat(maestro.pulseUs(3)).isCloseTo(1800.0, within(0.25));
  }

  @Test
  void sysfs_level_isTheNumberInItsFile(@TempDir Path folder) throws Exception {
    Path brightness = Files.writeString(folder.resolve("brightness"), "7");
    SysfsOutput light = new SysfsOutput(brightness, new SysfsOutput.Range(0.0, 255.0));
    light.read(1);
    assertThat(brightness).as("not touched").hasContent("7");
    light.set(20.0);
    light.read(2);
    assertThat(brightness).hasContent("51");
  }
}
