package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.u2sa.core.communication.BrokerTraffic.command;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.goal.GoalList;

/** What remote services notice of a link that goes and comes back. */
@Timeout(90)
class BrokenLinkTest extends WiredClients {
  @Test
  void linkCut_brokerSaysTheWillOnce_withTheInstance() {
    local.subscribe(Channels.HEALTH);
    RecordingReceiver witness = new RecordingReceiver();
    Connection other = broker.remote("Witness", witness);
    other.subscribe(Channels.HEALTH);

    wire.cut();

    soon().until(() -> !localInbox.messages.isEmpty() && !witness.messages.isEmpty());
    assertThat(localInbox.messages).hasSize(1).isEqualTo(witness.messages);
    ConnectionLost will = (ConnectionLost) localInbox.messages.get(0);
    assertThat(will.serviceName()).isEqualTo("Remote");
    assertThat(will.instance()).contains(remote.instance());
    assertThat(will.status()).isEqualTo(ServiceStatus.FAILED);
    assertThat(will.lastError()).contains("connection lost");
  }

  @Test
  void close_cleanly_noWillIsSaid() {
    local.subscribe(Channels.HEALTH);
    remote.close();
    Connection other = broker.remote("Witness", new RecordingReceiver());
    local.subscribe(Channels.ACTUATION);

    soon()
        .until(
            () -> {
              other.publish(Channels.ACTUATION, command(3.0));
              return !localInbox.messages.isEmpty();
            });

    assertThat(localInbox.messages).noneMatch(ConnectionLost.class::isInstance);
  }

  @Test
  void linkCutAndRestored_subscriptionsAreBackAndNothingIsTwice() {
    remote.subscribe(Channels.ACTUATION);
    publishUntilReceived(command(1.0));

    cutWire();
    assertThat(remote.publish(Channels.STOP, command(2.0))).isFalse();
    restoreWire();
    remoteInbox.messages.clear();
    local.publish(Channels.ACTUATION, command(3.0));
    local.publish(Channels.ACTUATION, command(4.0));

    remoteInbox.awaitMessage(command(4.0));
    assertThat(remoteInbox.messages).containsExactly(command(3.0), command(4.0));
    assertThat(remote.refused()).isEqualTo(1);
    assertThat(remoteInbox.troubles).anyMatch(line -> line.contains("1 messages could not"));
  }

  @Test
  void subscribe_whileTheLinkIsBroken_beginsWhenItIsBack() {
    cutWire();

    assertThat(remote.subscribe(Channels.ACTUATION)).isTrue();
    wire.restore();

    publishUntilReceived(command(1.0));
  }

  @Test
  void linkDeadWithoutAWord_isFoundWithinSeconds_hereAndByTheBroker() {
    local.subscribe(Channels.HEALTH);

    wire.goDead();

    await().atMost(Duration.ofSeconds(30)).until(() -> !localInbox.messages.isEmpty());
    await()
        .atMost(Duration.ofSeconds(30))
        .until(() -> remoteInbox.troubles.stream().anyMatch(line -> line.contains("lost")));
    restoreWire();
  }

  @Test
  void retainedMessageOfAnother_isNotOverwrittenAndNotHeardTwice() {
    GoalList old = frozen(new GoalList());
    GoalList newer = frozen(new GoalList(), 2);
    remote.publish(Channels.GOALS, old);
    remote.subscribe(Channels.GOALS);
    local.subscribe(Channels.GOALS);
    localInbox.awaitMessage(old);
    BrokerTraffic.publishUntilReceived(local, remoteInbox, Channels.GOALS, newer);
    GoalList newest = frozen(new GoalList(), 3); // once, when nothing is on its way any more
    local.publish(Channels.GOALS, newest);
    remoteInbox.awaitMessage(newest);
    cutWire();
    remoteInbox.messages.clear();
    restoreWire();
    remote.subscribe(Channels.ACTUATION);
    publishUntilReceived(command(1.0));

    assertThat(remoteInbox.messages).doesNotHaveAnyElementsOfTypes(GoalList.class);
    assertThat(localInbox.messages.get(localInbox.messages.size() - 1)).isEqualTo(newest);
  }
}
