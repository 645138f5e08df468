package org.u2sa.drivers.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.RcChannelsOverride;
import io.dronefleet.mavlink.common.SetAttitudeTarget;
import org.junit.jupiter.api.Test;
import org.u2sa.drivers.link.MemoryLink;

/** Restarts and swaps of the service of an autopilot, in simulated time. */
class MavlinkAutopilotRestartTest extends SimulatedAutopilot {

  @Test
  void swap_commanded_theSuccessorRenewsTheSameCommandAndNobodySaysNeutral() {
    rc();
    command("STEERING", 25.0, 3.0);
    command("THROTTLE", 25.0, 3.0);
    kit.advance(0.2);
    RcChannelsOverride before = last(RcChannelsOverride.class);
    live(swap(), 2.0);

    assertThat(link.isClosed()).isTrue();
    assertThat(heard(RcChannelsOverride.class)).isNotEmpty().containsOnly(before);
  }

  /** The link of a service that takes this one's place; the vehicle hears it as before. */
  private MemoryLink successorsLink() {
    heard.clear();
    return new MemoryLink().with(this::hear);
  }

  private MemoryLink swap() {
    MemoryLink again = successorsLink();
    kit.swap(service, context -> new MavlinkAutopilot(context, again));
    return again;
  }

  private MemoryLink restart() {
    return restart(successorsLink());
  }

  private MemoryLink restart(MemoryLink again) {
    kit.restart(
        service,
        context -> {
          heard.clear(); // what the first one said at its end
          return new MavlinkAutopilot(context, again);
        });
    return again;
  }

  @Test
  void swap_stoppedBeforeTheNextHeartbeat_isNeutralForItsTimeThenGivenBack() {
    rc();
    command("STEERING", 80.0);
    kit.advance(0.2);
    MemoryLink again = swap();
    stop();
    kit.advance(0.95); // more than what is left of the command and of the neutral time
    assertThat(heard(RcChannelsOverride.class)).as("the autopilot is not yet known").isEmpty();
    live(again, 0.6);
    assertThat(steering()).containsExactly(1500);
    live(again, 2.0);

    assertThat(steering()).containsExactly(1500, 0);
    assertThat(steeringCount(1500)).as("a second, each third step").isBetween(14L, 18L);
    assertThat(steeringCount(0)).isEqualTo(3);
  }

  @Test
  void swap_commandsEndMeanwhile_isNeutralThenGivenBack() {
    rc();
    command("STEERING", 80.0);
    kit.advance(0.2);
    MemoryLink again = swap();
    kit.advance(2.5);
    live(again, 2.5);

    assertThat(steering()).containsExactly(1500, 0);
  }

  @Test
  void swap_neverCommanded_isSilent() {
    rc();
    MemoryLink again = swap();
    stop();
    live(again, 2.5);

    assertThat(heard(RcChannelsOverride.class)).isEmpty();
  }

  @Test
  void swap_targetConfigured_saysNoNeutralBeforeTheHeartbeatButStopsAtOnce() {
    kit.with("AUTOPILOT SYSTEM", 7);
    rc();
    command("STEERING", 80.0, 5.0);
    kit.advance(0.2);
    MemoryLink again = swap();
    kit.advance(0.9);
    assertThat(heard(RcChannelsOverride.class)).as("the last command still holds").isEmpty();
    stop();

    assertThat(steering()).containsExactly(1500);
  }

  @Test
  void swap_targetConfiguredAndNoHeartbeat_isNeutralAfterTheTimeout() {
    kit.with("AUTOPILOT SYSTEM", 7);
    rc();
    command("STEERING", 80.0, 20.0);
    kit.advance(0.2);
    MemoryLink again = swap();
    kit.advance(6.0);

    assertThat(steering()).containsExactly(1500, 0);
  }

  @Test
  void restart_stopped_isNeutralForItsTimeThenGivenBack() {
    rc();
    MemoryLink again = restart();
    stop();
    kit.advance(3.0);
    assertThat(heard(RcChannelsOverride.class)).as("the autopilot is not yet known").isEmpty();
    live(again, 3.0);

    assertThat(steering()).containsExactly(1500, 0);
    assertThat(steeringCount(1500)).as("a second, each third step").isBetween(16L, 18L);
    assertThat(steeringCount(0)).isEqualTo(3);
  }

  /** A radio pilot may be flying: neutral would take the throttle away. */
  @Test
  void restart_notStopped_isGivenBackWithoutNeutral() {
    rc();
    MemoryLink again = restart();
    live(again, 3.0);

    assertThat(steering()).containsExactly(0);
    assertThat(steeringCount(0)).isEqualTo(3);
  }

  @Test
  void restart_linkIsAbsent_neutralTimeBeginsOnceItTakesTheFirstMessage() {
    kit.with("AUTOPILOT SYSTEM", 7);
    rc();
    MemoryLink again = successorsLink();
    again.unplug();
    restart(again);
    stop();
    kit.advance(5.0);
    again.plug();
    live(again, 3.0);

    assertThat(steering()).containsExactly(1500, 0);
    assertThat(steeringCount(1500)).as("a second, each third step").isBetween(16L, 18L);
  }

  @Test
  void restart_sensorOnly_commandsNothing() {
    start();
    MemoryLink again = restart();
    live(again, 2.5);

    assertThat(heard(RcChannelsOverride.class)).isEmpty();
  }

  @Test
  void restart_attitudeComesLate_neutralWaitsForIt() {
    kit.with("COMMANDS", "attitude");
    start();
    MemoryLink again = restart();
    stop();
    live(again, 2.0);
    assertThat(heard(SetAttitudeTarget.class)).isEmpty();
    again.fromDevice(vehicle.encode(attitude(0.0, 1.0)));
    live(again, 2.0);

    assertThat(heard(SetAttitudeTarget.class)).hasSizeBetween(16, 18);
  }
}
