package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.command;
import static org.u2sa.core.communication.BrokerTraffic.frozen;
import static org.u2sa.core.communication.BrokerTraffic.soon;

import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.safety.StopCommand;
import org.u2sa.messages.schema.U2SAData;

/** What does not get through a broken link is counted, by one side or the other. */
@Timeout(90)
class MissedMessagesTest extends WiredClients {
  private int numbered; // commands published, each with its number

  @Test
  void linkCut_whatWasSentMeanwhile_isCountedAsMissedByWhoCouldNotHearIt() {
    remote.subscribe(Channels.ACTUATION);
    publishUntilOneMoreIsReceived();
    cutWire();
    for (int i = 0; i < 7; i++) {
      publishNext();
    }
    restoreWire();
    publishUntilOneMoreIsReceived();
    publishNext();
    soon()
        .until(() -> number(remoteInbox.messages.get(remoteInbox.messages.size() - 1)) == numbered);

    int sinceTheFirstReceived = numbered - (int) number(remoteInbox.messages.get(0)) + 1;
    assertThat(remote.missed())
        .isEqualTo(sinceTheFirstReceived - remoteInbox.messages.size())
        .isGreaterThanOrEqualTo(7);
    assertThat(local.missed()).isZero();
  }

  private void publishNext() {
    local.publish(Channels.ACTUATION, command(++numbered));
  }

  private static double number(U2SAData command) {
    return ((PercentageCommand) command).percentage();
  }

  private void publishUntilOneMoreIsReceived() {
    int before = remoteInbox.messages.size();
    soon()
        .until(
            () -> {
              publishNext();
              return remoteInbox.messages.size() > before;
            });
  }

  @Test
  void linkCut_whatItCouldNotSend_isCountedAsMissedByTheOtherSide() {
    local.subscribe(Channels.STOP);
    remote.publish(Channels.STOP, frozen(new StopCommand().serviceName("first")));
    soon().until(() -> localInbox.messages.size() == 1);
    cutWire();
    for (int i = 0; i < 5; i++) {
      remote.publish(Channels.STOP, frozen(new StopCommand().serviceName("lost"), 2));
    }
    restoreWire();
    remote.publish(Channels.STOP, frozen(new StopCommand().serviceName("last"), 3));
    soon().until(() -> localInbox.messages.size() == 2);

    assertThat(local.missed()).isEqualTo(5);
  }

  @Test
  void linkDead_messagesWithoutConfirmationAreCounted() {
    wire.goDead();
    int sent = 0;
    while (remoteInbox.troubles.isEmpty()) {
      remote.publish(Channels.STOP, frozen(new StopCommand(), ++sent));
      LockSupport.parkNanos(10_000_000); // not as fast as the processor can
    }

    assertThat(remote.refused()).isGreaterThanOrEqualTo(sent - 1);
    wire.restore();
  }
}
