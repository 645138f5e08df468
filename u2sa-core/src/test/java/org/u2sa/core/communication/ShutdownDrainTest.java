package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;
import static org.u2sa.core.communication.BrokerTraffic.frozen;

import java.io.IOException;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.TcpRelay;

/** What is published just before the embedded broker ends. */
@Timeout(120)
class ShutdownDrainTest {
  private static final Channel<PercentageCommand> REPORTS =
      Channel.every("reports", PercentageCommand.TYPE);
  private static final int MANY = 300; // far more than the broker sends without acknowledgement

  private final TestManager broker = new TestManager();
  private final RecordingReceiver inbox = new RecordingReceiver();
  private final Connection local = broker.local("Local", new RecordingReceiver());

  @AfterEach
  void stop() {
    broker.close();
  }

  /** Returns when copies of the channel reach the new client. */
  private void join(int at, Channel<?> channel, U2SAData knock) {
    Connection remote = broker.keep(TestManager.transport(at).connect("Remote", inbox));
    assertThat(remote.subscribe(channel)).isTrue();
    BrokerTraffic.publishUntilReceived(local, inbox, channel, knock);
  }

  private static PercentageCommand report(int number) {
    return frozen(PercentageCommand.of("RUDDER " + number, 1.0));
  }

  private List<PercentageCommand> publishMany() {
    List<PercentageCommand> sent =
        IntStream.range(0, MANY).mapToObj(ShutdownDrainTest::report).toList();
    sent.forEach(report -> local.publish(REPORTS, report));
    return sent;
  }

  @Test
  void close_rightAfterMany_allHaveArrived() {
    join(broker.port, REPORTS, report(-1));

    List<PercentageCommand> sent = publishMany();
    broker.manager().close();

    assertThat(inbox.messages).containsSubsequence(sent);
    assertThat(broker.manager().dropped()).isZero();
  }

  @Test
  void close_rightAfterNeutralCommands_allHaveArrived() {
    join(broker.port, Channels.ACTUATION, frozen(PercentageCommand.of("KNOCK", 1.0)));
    List<PercentageCommand> neutral =
        List.of("AILERON", "ELEVATOR", "RUDDER", "THROTTLE", "BRAKES").stream()
            .map(actuator -> frozen(PercentageCommand.of(actuator, 0.0)))
            .toList();

    neutral.forEach(command -> local.publish(Channels.ACTUATION, command));
    broker.manager().close();

    assertThat(inbox.messages).containsSubsequence(neutral);
  }

  @Test
  void close_clientTakesNothing_isCountedAndEndsAllTheSame() throws IOException {
    try (TcpRelay wire = new TcpRelay(broker.port)) {
      join(wire.port(), REPORTS, report(-1));
      wire.goDead();

      publishMany();
      broker.manager().close();

      assertThat(broker.manager().dropped()).isPositive();
      assertThat(broker.log).anyMatch(line -> line.contains("undelivered to remote subscribers"));
    }
  }
}
