package org.u2sa.service.inbox;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.time.LockstepClock;
import org.u2sa.messages.contract.ConfigurationChange;
import org.u2sa.messages.contract.ConfigurationRequest;
import org.u2sa.messages.contract.DiscoveryRequest;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.safety.ArmCommand;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.messages.safety.EmergencyStop;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.service.inbox.ServiceInbox.Outcome;

/** Who finds room in a service's inbox when others fill it. */
class ServiceInboxTest {
  private static final int CAPACITY = 8;

  private final LockstepClock clock = new LockstepClock();
  private final ServiceInbox inbox = new ServiceInbox(CAPACITY, clock);

  private int questionsTaken() {
    int taken = 0;
    while (inbox.put(Channels.CONFIGURATION, new ConfigurationRequest(), 0L) == Outcome.KEPT) {
      taken++;
    }
    return taken;
  }

  @Test
  void put_floodOfQuestions_fillsAQuarterAndLeavesRoomForTheRest() {
    assertThat(questionsTaken()).isEqualTo(CAPACITY / 4);

    assertThat(inbox.put(Channels.DISCOVERY, new DiscoveryRequest(), 0L))
        .isEqualTo(Outcome.DROPPED);
    assertThat(inbox.put(Channels.CONFIGURATION, new ConfigurationChange(), 0L))
        .isEqualTo(Outcome.KEPT);
    assertThat(inbox.put(Channels.GOALS, new GoalList(), 0L)).isEqualTo(Outcome.KEPT);
    assertThat(inbox.dropped()).isEqualTo(2);
  }

  @Test
  void poll_questionTaken_makesRoomForTheNext() {
    questionsTaken();
    inbox.poll();

    assertThat(inbox.put(Channels.DISCOVERY, new DiscoveryRequest(), 0L)).isEqualTo(Outcome.KEPT);
    assertThat(inbox.put(Channels.DISCOVERY, new DiscoveryRequest(), 0L))
        .isEqualTo(Outcome.DROPPED);
  }

  @Test
  void put_safetysMessagesIntoAFullInbox_areTaken() {
    for (int i = 0; i < CAPACITY; i++) {
      inbox.put(Channels.CONFIGURATION, new ConfigurationChange(), 0L);
    }
    assertThat(inbox.put(Channels.CONFIGURATION, new ConfigurationChange(), 0L))
        .isEqualTo(Outcome.DROPPED);

    ArmCommand arm = new ArmCommand();
    EmergencyStop stop = new EmergencyStop();
    assertThat(inbox.put(Channels.ARMING, arm, 0L)).isEqualTo(Outcome.KEPT);
    assertThat(inbox.put(Channels.EMERGENCY_STOP, stop, 0L)).isEqualTo(Outcome.KEPT);
    assertThat(inbox.put(Channels.FAILSAFE, new FailsafeState(), 0L)).isEqualTo(Outcome.KEPT);
    assertThat(inbox.put(Channels.ARMING_STATE, new ArmingState(), 0L)).isEqualTo(Outcome.KEPT);

    assertThat(inbox.poll().message()).isSameAs(stop);
    for (int i = 0; i < CAPACITY; i++) {
      assertThat(inbox.poll().message()).isInstanceOf(ConfigurationChange.class);
    }
    assertThat(inbox.poll().message()).as("in its turn").isSameAs(arm);
    assertThat(inbox.depth()).isEqualTo(2);
  }

  @Test
  void put_newerOfALatestChannelWithRoom_replacesTheOneThatWaits() {
    ArmingState newer = new ArmingState();
    inbox.put(Channels.ARMING_STATE, new ArmingState(), 0L);
    inbox.put(Channels.ARMING_STATE, newer, 0L);

    assertThat(inbox.poll().message()).isSameAs(newer);
    assertThat(inbox.poll()).isNull();

    inbox.put(Channels.ARMING_STATE, newer, 0L);
    assertThat(inbox.depth()).isOne();
  }
}
