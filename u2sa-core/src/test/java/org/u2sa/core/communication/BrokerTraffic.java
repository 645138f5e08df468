package org.u2sa.core.communication;

import static org.awaitility.Awaitility.await;

import java.time.Duration;
import org.awaitility.core.ConditionFactory;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.schema.U2SAData;

/** Messages of system cessna that go from one connection to another. */
final class BrokerTraffic {
  private BrokerTraffic() {}

  /** A message as it is published. */
  static <T extends U2SAData> T frozen(T message) {
    return frozen(message, 1);
  }

  /** The same of a time [µs]. */
  static <T extends U2SAData> T frozen(T message, long timestamp) {
    message.systemId("cessna");
    message.timestamp(timestamp);
    message.freeze();
    return message;
  }

  static PercentageCommand command(double percent) {
    return frozen(PercentageCommand.of("RUDDER", percent));
  }

  /** Patience enough for a machine with much else to do. */
  static ConditionFactory soon() {
    return await().atMost(Duration.ofSeconds(30));
  }

  /**
   * Publishes until it arrives: the broker tells its listeners of a new subscription a moment after
   * it confirmed it.
   */
  static void publishUntilReceived(
      Connection from, RecordingReceiver to, Channel<?> channel, U2SAData message) {
    soon()
        .until(
            () -> {
              from.publish(channel, message);
              return to.messages.contains(message);
            });
  }

  /** The same on {@link Channels#ACTUATION}. */
  static void publishUntilReceived(Connection from, RecordingReceiver to, U2SAData message) {
    publishUntilReceived(from, to, Channels.ACTUATION, message);
  }
}
