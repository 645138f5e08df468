package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.ActuatorCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.service.actuator.CommandRefusal;
import org.u2sa.service.handover.HandOver;
import org.u2sa.testkit.ServiceKit;

/** Two actuators of one service: which commands move them, and what is said of the others. */
@Timeout(120)
class CommandedActuatorsTest {
  @AutoClose private final ServiceKit kit = new ServiceKit();

  /** Writes down what came of each message. */
  private static final class Drive extends EventDrivenService {
    private final CommandedActuators commands;
    private final List<String> results = new ArrayList<>();

    Drive(ServiceContext context) {
      super(context, ServiceRole.ACTUATOR, "Drive");
      commands =
          new CommandedActuators(
              this,
              Set.of("LEFT", "RIGHT"),
              () -> results.add("commanded"),
              () -> results.add("stopped"));
    }

    @Override
    protected void handOver(HandOver state) {
      commands.handOver(state);
    }

    @Override
    protected void takeOver(HandOver state) {
      commands.takeOver(state);
    }
  }

  private Drive start() {
    return kit.start(Drive::new);
  }

  private Drive startUnarmed() {
    kit.with("REQUIRES ARMING", true);
    return start();
  }

  private void command(String actuator, double percentage) {
    kit.publish(Channels.ACTUATION, PercentageCommand.of(actuator, percentage));
  }

  private void arm(boolean armed) {
    kit.publish(
        Channels.ARMING_STATE,
        new ArmingState().armed(armed).reasons(armed ? List.of() : List.of("battery")));
  }

  private void stop(String id) {
    kit.publish(
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(true).stopId(id).operator("Ann").reason("smoke"));
  }

  private void clear(String id) {
    kit.publish(
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(false).lifts(List.of(id)).operator("Bob").reason("all well"));
  }

  @Test
  void announcement_whileAnEmergencyStopIsInForce_saysThatCommandsAreWithheld() {
    Drive drive = start();
    drive.commands.announce(
        List.of(new ActuatorAnnouncement().actuatorName("LEFT").minimum(0.0).maximum(100.0)));
    stop("1");
    drive.commands.step(kit.nowS());
    assertThat(kit.latest(Channels.ACTUATORS).orElseThrow().withheld()).isTrue();

    clear("1");
    drive.commands.step(kit.nowS());
    assertThat(kit.latest(Channels.ACTUATORS).orElseThrow().withheld()).isFalse();
    drive.commands.withheld(true);
    drive.commands.step(kit.nowS());
    assertThat(kit.latest(Channels.ACTUATORS).orElseThrow().withheld()).isTrue();
  }

  private List<String> log(String part) {
    return kit.log("Drive").stream().filter(line -> line.contains(part)).toList();
  }

  private HealthReport health() {
    return kit.latest(Channels.HEALTH).orElseThrow();
  }

  @Test
  void obey_commandsToItsActuatorsAndOthers_countsThoseThatWereMeantForIt() {
    Drive drive = start();
    command("LEFT", 10.0);
    command("RIGHT", 20.0);
    command("RUDDER", 30.0);
    kit.publish(Channels.ACTUATION, new ActuatorCommand().actuatorName("LEFT"));
    kit.advance(1.0);

    assertThat(drive.results).containsExactly("commanded", "commanded");
    assertThat(drive.commands.refused(CommandRefusal.NOT_ADDRESSED)).isOne();
    assertThat(drive.commands.refused(CommandRefusal.NOT_A_PERCENTAGE)).isOne();
    assertThat(drive.commands.refused(CommandRefusal.TOO_OLD)).isZero();
    assertThat(health().commandsObeyed()).hasValue(2);
    assertThat(health().commandsRefused()).hasValue(1);
    assertThat(log("refused ")).singleElement().asString().contains("not a percentage (1 so far)");
  }

  @Test
  void stop_evenTwice_stopsAtOnceAndAClearDoesNot() {
    Drive drive = start();
    arm(true);
    stop("Ann 1");
    stop("Ann 1");
    clear("Ann 1");

    assertThat(drive.results).containsExactly("stopped", "stopped");
  }

  @Test
  void stop_deviceHasNotTakenIt_isNotConfirmedUntilItHas() {
    AtomicBoolean taken = new AtomicBoolean();
    Drive drive = start();
    drive.commands.confirmStopsWhen(taken::get);
    stop("Ann 1");
    drive.commands.step(kit.nowS());
    kit.advance(2.0);
    assertThat(drive.results).containsExactly("stopped");
    assertThat(health().emergencyStops()).hasValue(List.of());

    taken.set(true);
    drive.commands.step(kit.nowS());
    kit.advance(2.0);
    assertThat(health().emergencyStops()).hasValue(List.of("Ann 1"));
  }

  @Test
  void stop_deviceIsLost_isNotConfirmedUntilItIsBack() {
    Drive drive = start();
    drive.commands.announce(
        List.of(
            new ActuatorAnnouncement().actuatorName("LEFT").minimum(-100.0).maximum(100.0),
            new ActuatorAnnouncement().actuatorName("RIGHT").minimum(-100.0).maximum(100.0)));
    drive.commands.available(0.0);
    stop("Ann 1");
    drive.commands.step(kit.nowS());
    kit.advance(2.0);
    assertThat(drive.results).containsExactly("stopped");
    assertThat(health().emergencyStops()).hasValue(List.of());

    drive.commands.available("LEFT", 100.0);
    drive.commands.step(kit.nowS());
    kit.advance(2.0);
    assertThat(health().emergencyStops()).hasValue(List.of("Ann 1"));
  }

  @Test
  void stop_whileCommanded_forgetsTheCommandThoughItIsCleared() {
    Drive drive = start();
    command("LEFT", 10.0);
    assertThat(drive.commands.isCommanded()).isTrue();
    assertThat(drive.commands.percentage("LEFT")).hasValue(10.0);

    stop("Ann 1");
    assertThat(drive.commands.mayMove()).isFalse();
    assertThat(drive.commands.isCommanded()).isFalse();
    assertThat(drive.commands.percentage("LEFT")).isEmpty();
    clear("Ann 1");

    assertThat(drive.commands.mayMove()).isTrue();
    assertThat(drive.commands.isCommanded()).isFalse();
    assertThat(log("emergency stop by \"Ann\": smoke")).singleElement().asString().contains("WARN");
    assertThat(log("emergency stop cleared by \"Bob\": all well"))
        .singleElement()
        .asString()
        .contains("INFO");
  }

  @Test
  void obey_whileStopped_isRefusedAsStoppedAndForgottenWhenCleared() {
    Drive drive = startUnarmed();
    stop("Ann 1");
    command("LEFT", 10.0);
    assertThat(drive.commands.refused(CommandRefusal.EMERGENCY_STOPPED)).isOne();
    clear("Ann 1");
    command("LEFT", 10.0);
    assertThat(drive.commands.refused(CommandRefusal.NOT_ARMED)).isOne();

    arm(true);

    assertThat(drive.commands.mayMove()).isTrue();
    assertThat(drive.commands.isCommanded()).as("by what it refused before").isFalse();
  }

  @Test
  void arm_thenDisarm_isLoggedOnceEachAndForgetsTheCommand() {
    Drive drive = startUnarmed();
    arm(true);
    arm(true);
    command("LEFT", 10.0);
    assertThat(drive.commands.isCommanded()).isTrue();

    arm(false);
    arm(false);
    arm(true);

    assertThat(drive.commands.isCommanded()).isFalse();
    assertThat(log("disarmed: [battery]")).hasSize(1);
    assertThat(log(" armed")).hasSize(2);
  }

  private void stepAfter(Drive drive, double seconds) {
    kit.advance(seconds);
    drive.commands.step(kit.nowS());
  }

  @Test
  void step_noArmingStateForTheExpiry_stopsOnceUntilArmedAgain() {
    Drive drive = startUnarmed();
    arm(true);
    stepAfter(drive, 10.0);
    assertThat(drive.commands.mayMove()).isTrue();
    drive.results.clear();

    stepAfter(drive, 0.001);
    stepAfter(drive, 1.0);
    assertThat(drive.commands.mayMove()).isFalse();
    assertThat(drive.results).containsExactly("stopped");
    assertThat(log("no arming state for 10.0 s")).hasSize(1);
    command("LEFT", 50.0);
    assertThat(drive.commands.refused(CommandRefusal.NOT_ARMED)).isEqualTo(1);

    arm(true);
    command("LEFT", 50.0);
    assertThat(drive.commands.percentage("LEFT")).hasValue(50.0);
  }

  @Test
  void step_armingStateIsRepeated_neverExpires() {
    Drive drive = startUnarmed();
    for (int i = 0; i < 5; i++) {
      arm(true);
      stepAfter(drive, 9.0);
    }

    assertThat(drive.commands.mayMove()).isTrue();
  }

  @Test
  void step_expiryIsZero_neverExpires() {
    kit.with("ARMING EXPIRY", 0.0);
    Drive drive = startUnarmed();
    arm(true);
    stepAfter(drive, 4000.0);

    assertThat(drive.commands.mayMove()).isTrue();
  }

  @Test
  void step_armingIsNotRequired_neverExpires() {
    Drive drive = start();
    arm(true);
    stepAfter(drive, 60.0);

    assertThat(drive.commands.mayMove()).isTrue();
    assertThat(log("no arming state")).isEmpty();
  }

  @Test
  void disarm_whereArmingIsNotRequired_keepsTheCommand() {
    Drive drive = start();
    arm(true);
    command("LEFT", 10.0);

    arm(false);

    assertThat(drive.commands.percentage("LEFT")).hasValue(10.0);
  }

  @Test
  void clear_thatLeavesAStop_isToldAndTheStopRepeated() {
    Drive drive = start();
    stop("Ann 1");
    kit.forget();

    clear("another");

    assertThat(drive.commands.mayMove()).isFalse();
    assertThat(kit.published(Channels.EMERGENCY_STOP))
        .singleElement()
        .matches(stop -> stop.stopId().orElse("").equals("Ann 1"));
    assertThat(log("clear by \"Bob\" leaves "))
        .singleElement()
        .asString()
        .endsWith("still stopped");
  }

  @Test
  void swap_whileStopped_successorSaysAtOnceWhichStopsHold() {
    Drive drive = start();
    stop("Ann 1");

    Drive successor = kit.swap(drive, Drive::new);
    kit.forget();
    kit.advance(1.0);

    assertThat(successor.commands.mayMove()).isFalse();
    assertThat(health().emergencyStops()).contains(List.of("Ann 1"));
  }

  @Test
  void swap_whileCommanded_successorGoesOnWithTheCommandUntilItExpires() {
    Drive drive = start();
    command("LEFT", 10.0);

    Drive successor = kit.swap(drive, Drive::new);

    assertThat(successor.commands.percentage("LEFT")).hasValue(10.0);
    kit.advance(0.5);
    assertThat(successor.commands.percentage("LEFT")).isEmpty();
    assertThat(successor.commands.isCommanded()).isFalse();
  }
}
