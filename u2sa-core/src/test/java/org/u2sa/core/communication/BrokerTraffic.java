package org.u2sa.core.communication;

import static org.awaitility.Awaitility.await;

import java.time.Duration;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.PercentageCommand;

/** Commands that go from one connection to another. */
final class BrokerTraffic {
  private static final Duration SOON = Duration.ofSeconds(30);

  private BrokerTraffic() {}

  /** A command as it is published. */
  static PercentageCommand command(String systemId, String actuator) {
    PercentageCommand command = PercentageCommand.of(actuator, 1.0);
    command.systemId(systemId);
    command.timestamp(1);
    command.freeze();
    return command;
  }

  /** Publishes until a subscriber, whose subscription may be on its way, hears it. */
  static void publishUntilReceived(Connection from, RecordingReceiver to) {
    PercentageCommand knock = command("cessna", "KNOCK");
    await()
        .atMost(SOON)
        .until(
            () -> {
              from.publish(Channels.ACTUATION, knock);
              return to.messages.contains(knock);
            });
  }
}
