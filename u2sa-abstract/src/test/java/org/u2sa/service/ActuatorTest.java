package org.u2sa.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.testkit.ServiceKit;

@Timeout(120)
class ActuatorTest {
  @AutoClose private final ServiceKit kit = new ServiceKit();
  private Wheel wheel;

  private static class Wheel extends Actuator {
    private final List<String> moves = new ArrayList<>();
    private int failures; // of the device, when it is to go neutral

    Wheel(ServiceContext context) {
      super(context, "LEFT WHEEL");
    }

    @Override
    protected void actuate(double percentage) {
      moves.add(String.valueOf(percentage));
    }

    @Override
    protected void neutral() {
      if (failures > 0) {
        failures--;
        throw new IllegalStateException("the device does not answer");
      }
      moves.add("neutral");
    }

    @Override
    protected ActuatorAnnouncement announcement() {
      return super.announcement().minimum(0.0);
    }

    @Override
    protected void close() {
      moves.add("closed");
    }
  }

  @BeforeEach
  void start() {
    wheel = kit.start(Wheel::new);
    wheel.moves.clear();
  }

  @Test
  void callback_commandToItsName_isCarriedOut() {
    kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT WHEEL", 40.0));

    assertThat(wheel.moves).containsExactly("40.0");
  }

  @Test
  void callback_commandToAnother_isIgnored() {
    kit.publish(Channels.ACTUATION, PercentageCommand.of("RIGHT WHEEL", 40.0));

    assertThat(wheel.moves).isEmpty();
  }

  @Test
  void callback_commandThatExpiredOnItsWay_isRefusedAndLogged() {
    kit.advance(2.0);
    PercentageCommand old = PercentageCommand.of("LEFT WHEEL", 40.0);
    old.timestamp(1_000_000L);

    kit.publish(Channels.ACTUATION, old);

    assertThat(wheel.moves).isEmpty();
    assertThat(kit.log("LEFT WHEEL")).anyMatch(line -> line.contains("refused"));
  }

  @Test
  void callback_outsideWhatItAnnounced_isRefusedCountedInHealthAndSaidNowAndThen() {
    for (int i = 0; i < 5; i++) {
      kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT WHEEL", -1.0));
    }
    kit.publish(Channels.ACTUATION, PercentageCommand.of("RIGHT WHEEL", -1.0));
    kit.advance(0.5);

    assertThat(wheel.moves).isEmpty();
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().refused()).isEqualTo(5);
    assertThat(kit.log("LEFT WHEEL"))
        .filteredOn(line -> line.contains("out of range"))
        .hasSize(3) // the 1st, 2nd and 4th
        .last()
        .asString()
        .contains("(4 so far)");
  }

  @Test
  void emergencyStop_goesNeutralAtOnceAndObeysNothingUntilCleared() {
    kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT WHEEL", 40.0));
    EmergencyStop stop = new EmergencyStop().active(true).operator("Ann").reason("smoke");
    kit.publish(Channels.EMERGENCY_STOP, stop);
    kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT WHEEL", 50.0));
    assertThat(wheel.moves).containsExactly("40.0", "neutral");
    assertThat(kit.log("LEFT WHEEL")).anyMatch(line -> line.contains("by \"Ann\": smoke"));

    kit.publish(
        Channels.EMERGENCY_STOP,
        new EmergencyStop().active(false).clears(stop.timestamp().orElseThrow()));
    assertThat(wheel.moves).containsExactly("40.0", "neutral");
    kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT WHEEL", 60.0));

    assertThat(wheel.moves).containsExactly("40.0", "neutral", "60.0");
  }

  @Test
  void start_whileAnEmergencyStopHolds_obeysNothing() {
    EmergencyStop stop = new EmergencyStop().active(true);
    kit.publish(Channels.EMERGENCY_STOP, stop);
    kit.with("SERVICE NAME", "LATE WHEEL");

    Wheel late = kit.start(Wheel::new);
    kit.publish(Channels.ACTUATION, PercentageCommand.of("LATE WHEEL", 40.0));

    assertThat(late.moves).containsExactly("neutral");
  }

  @Test
  void requiresArming_armedStateOfAnEarlierRun_doesNotArm() {
    kit.with("SERVICE NAME", "ARMED WHEEL").with("REQUIRES ARMING", true);
    Wheel armed = kit.start(Wheel::new);
    kit.advance(10.0);
    ArmingState retained = new ArmingState().armed(true);
    retained.timestamp(kit.clock().micros() - 6_000_000);

    kit.publish(Channels.ARMING_STATE, retained);
    kit.publish(Channels.ARMING_STATE, (ArmingState) retained.copy());
    kit.publish(Channels.ACTUATION, PercentageCommand.of("ARMED WHEEL", 40.0));

    assertThat(armed.moves).containsExactly("neutral");
    assertThat(kit.log("ARMED WHEEL"))
        .filteredOn(line -> line.contains("ignored an armed state"))
        .hasSize(1);
  }

  @Test
  void requiresArming_delayedArmedStatesWhileArmed_neitherDisarmNorPutOffTheExpiry() {
    kit.with("SERVICE NAME", "ARMED WHEEL").with("REQUIRES ARMING", true);
    Wheel armed = kit.start(Wheel::new);
    kit.advance(10.0);
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));
    kit.publish(Channels.ACTUATION, PercentageCommand.of("ARMED WHEEL", 40.0));

    publishDelayedArmedState();
    assertThat(armed.moves).containsExactly("neutral", "40.0");
    kit.advance(9.0);
    publishDelayedArmedState();
    kit.publish(Channels.ACTUATION, PercentageCommand.of("ARMED WHEEL", 50.0));
    kit.advance(0.1);
    assertThat(armed.moves).endsWith("50.0");

    kit.advance(2.0);
    kit.publish(Channels.ACTUATION, PercentageCommand.of("ARMED WHEEL", 60.0));
    assertThat(armed.moves).endsWith("neutral");
    assertThat(kit.log("ARMED WHEEL"))
        .filteredOn(line -> line.contains("ignored an armed state"))
        .hasSize(1);
  }

  private void publishDelayedArmedState() {
    ArmingState delayed = new ArmingState().armed(true);
    delayed.timestamp(kit.clock().micros() - 6_000_000);
    kit.publish(Channels.ARMING_STATE, delayed);
  }

  @Test
  void emergencyStop_deviceFailsAtFirst_isTriedAgainAndConfirmedOnlyThen() {
    kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT WHEEL", 40.0));
    wheel.failures = 2;
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).stopId("a"));
    assertThat(wheel.moves).containsExactly("40.0");
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::emergencyStops))
        .isNotEqualTo(Optional.of(List.of("a")));

    kit.advance(0.5);

    assertThat(wheel.moves).containsExactly("40.0", "neutral");
    assertThat(kit.latest(Channels.HEALTH).orElseThrow().emergencyStops()).contains(List.of("a"));
  }

  @Test
  void step_noCommandForTheExpiryTime_goesNeutralOnce() {
    kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT WHEEL", 40.0));
    kit.advance(0.45);
    assertThat(wheel.moves).containsExactly("40.0");

    kit.advance(1.0);

    assertThat(wheel.moves).containsExactly("40.0", "neutral");
  }

  @Test
  void step_commandWithItsOwnExpiry_holdsThatLong() {
    PercentageCommand command = PercentageCommand.of("LEFT WHEEL", 40.0);
    command.expiry(2.0);
    kit.publish(Channels.ACTUATION, command);

    kit.advance(1.9);
    assertThat(wheel.moves).containsExactly("40.0");
    kit.advance(0.2);
    assertThat(wheel.moves).containsExactly("40.0", "neutral");
  }

  /** A clock that goes on by a millisecond each time that somebody looks at it. */
  private static final class RestlessClock implements Clock {
    private final Clock clock;
    private long micros;

    RestlessClock(Clock clock) {
      this.clock = clock;
    }

    @Override
    public long micros() {
      micros += 1_000;
      return micros;
    }

    @Override
    public Waiter newWaiter(String name) {
      return clock.newWaiter(name);
    }
  }

  @Test
  void callback_commandThatExpiresWhileItIsTaken_isNeutralAndNoError() {
    RestlessClock restless = new RestlessClock(kit.clock());
    Wheel brief =
        new Wheel(
            ServiceContext.of(
                    ServiceKit.SYSTEM_ID,
                    XmlConfiguration.inMemory("test", Map.of("SERVICE NAME", "BRIEF")))
                .clock(restless)
                .transport(kit.bus())
                .logDirectory(wheel.context().logDirectory())
                .build());
    for (int i = 0; i < 20; i++) {
      PercentageCommand command = PercentageCommand.of("BRIEF", 40.0);
      command.expiry(0.0015); // taken 1 ms after its time, looked at 2 ms after it
      command.timestamp(restless.micros);
      brief
          .recipient
          .registrations()
          .handlerOr(Channels.ACTUATION, brief::callback)
          .accept(command);
    }

    assertThat(brief.moves).isNotEmpty().containsOnly("neutral");
    brief.kill();
  }

  @Test
  void swap_withACommand_goesOnWithItWithoutNeutralAndLetsItExpireInTime() {
    kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT WHEEL", 40.0));
    kit.advance(0.2);

    Wheel successor = kit.swap(wheel, Wheel::new);
    kit.settle();

    assertThat(wheel.moves).containsExactly("40.0", "closed");
    assertThat(successor.moves).containsExactly("40.0");
    kit.advance(0.25);
    assertThat(successor.moves).containsExactly("40.0");
    kit.advance(0.1); // 0.55 s after the command, which holds for 0.5 s
    assertThat(successor.moves).containsExactly("40.0", "neutral");
  }

  @Test
  void swap_commandWithALongExpiry_holdsAsLongAsItSaid() {
    PercentageCommand command = PercentageCommand.of("LEFT WHEEL", 40.0);
    command.expiry(2.0);
    kit.publish(Channels.ACTUATION, command);
    kit.advance(1.0);

    Wheel successor = kit.swap(wheel, Wheel::new);

    kit.advance(0.9);
    assertThat(successor.moves).containsExactly("40.0");
    kit.advance(0.2);
    assertThat(successor.moves).containsExactly("40.0", "neutral");
  }

  @Test
  void swap_forOneThatDoesNotGoThere_isNeutral() {
    kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT WHEEL", 40.0));

    Wheel successor =
        kit.swap(
            wheel,
            context ->
                new Wheel(context) {
                  @Override
                  protected ActuatorAnnouncement announcement() {
                    return super.announcement().maximum(30.0);
                  }
                });

    assertThat(successor.moves).containsExactly("neutral");
  }

  @Test
  void swap_armedAndStoppedBefore_isNoBump() {
    kit.with("SERVICE NAME", "ARMED WHEEL").with("REQUIRES ARMING", true);
    Wheel armed = kit.start(Wheel::new);
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));
    EmergencyStop stop = new EmergencyStop().active(true).stopId("Ann 1");
    kit.publish(Channels.EMERGENCY_STOP, stop);
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(false).lifts(List.of("Ann 1")));
    kit.publish(Channels.ACTUATION, PercentageCommand.of("ARMED WHEEL", 40.0));

    Wheel successor = kit.swap(armed, Wheel::new);
    kit.advance(0.1);

    assertThat(successor.moves).containsExactly("40.0");
  }

  @Test
  void swap_stoppedAndThenManyClearsThatLiftNothing_isStillStopped() {
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).stopId("Ann 1"));
    for (int i = 0; i < 100; i++) {
      kit.publish(
          Channels.EMERGENCY_STOP, new EmergencyStop().active(false).lifts(List.of("no such")));
    }

    Wheel successor = kit.swap(wheel, Wheel::new);
    kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT WHEEL", 40.0));

    assertThat(successor.moves).containsExactly("neutral");
  }

  @Test
  void clear_thatLiftsNothing_hidesTheStopFromNobodyWhoComesLater() {
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(true).stopId("Ann 1"));
    kit.publish(Channels.EMERGENCY_STOP, new EmergencyStop().active(false).clears(-1));
    kit.with("SERVICE NAME", "LATE WHEEL");

    Wheel late = kit.start(Wheel::new);
    kit.publish(Channels.ACTUATION, PercentageCommand.of("LATE WHEEL", 40.0));

    assertThat(late.moves).containsExactly("neutral");
  }

  @Test
  void kill_leavesNeutralBeforeClosing() {
    kit.publish(Channels.ACTUATION, PercentageCommand.of("LEFT WHEEL", 40.0));

    wheel.kill();

    assertThat(wheel.moves).containsExactly("40.0", "neutral", "closed");
  }

  @Test
  void start_announcesItself() {
    assertThat(kit.latest(Channels.ACTUATORS).orElseThrow().actuatorName()).isEqualTo("LEFT WHEEL");
  }
}
