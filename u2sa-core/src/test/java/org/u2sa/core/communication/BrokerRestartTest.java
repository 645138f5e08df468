package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.command;
import static org.u2sa.core.communication.BrokerTraffic.frozen;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.goal.GoalList;

/** The embedded broker's end and its successor in the same process. */
@Timeout(90)
class BrokerRestartTest extends TwoClients {
  @Test
  void restartBroker_remoteComesBackAndIsGivenWhatIsRetained() {
    remote.subscribe(Channels.ACTUATION);
    publishUntilReceived(command(1.0));
    GoalList goals = frozen(new GoalList());
    local.publish(Channels.GOALS, goals);

    broker.manager().restartBroker();

    publishUntilReceived(command(2.0));
    RecordingReceiver late = new RecordingReceiver();
    broker.remote("Late", late).subscribe(Channels.GOALS);
    late.awaitMessage(goals);
    assertThat(broker.log).anyMatch(line -> line.contains("restarted"));
  }

  @Test
  void restartBroker_servicesOfTheProcessNoticeNothing() {
    RecordingReceiver other = new RecordingReceiver();
    Connection subscriber = broker.local("Other", other);
    subscriber.subscribe(Channels.ACTUATION);

    local.publish(Channels.ACTUATION, command(1.0));
    broker.manager().restartBroker();
    local.publish(Channels.ACTUATION, command(2.0));

    assertThat(other.messages).containsExactly(command(1.0), command(2.0));
    assertThat(other.troubles).isEmpty();
    assertThat(local.refused()).isZero();
  }
}
