package org.u2sa.chaos;

import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.FunctionalityRequest;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.shape.Sphere;

/**
 * Well-formed messages at ten times the rate of all of the Cessna's own, which is about 500 a
 * second: objects, commands to an actuator that is not there, and requests to a service that is not
 * there.
 */
final class Flood {
  private static final double MESSAGES_PER_S = 5_000.0;
  private static final int BURST = 50;

  private Flood() {}

  static void of(int brokerPort, Clock clock, double seconds) throws InterruptedException {
    MessageCodec codec = new MessageCodec(MessageTypes.discovered());
    try (Connection connection =
            new MqttTransport("127.0.0.1", brokerPort, "cessna", codec)
                .connect("Flood", new Deaf());
        Clock.Waiter waiter = clock.newWaiter("flood")) {
      long bursts = (long) (seconds * MESSAGES_PER_S / BURST);
      long due = clock.micros();
      for (long burst = 0; burst < bursts; burst++) {
        for (int i = 0; i < BURST; i++) {
          publish(connection, i);
        }
        due += Clock.micros(BURST / MESSAGES_PER_S);
        waiter.await(due);
      }
    }
  }

  private static void publish(Connection connection, int number) {
    switch (number % 3) {
      case 0 -> send(connection, Channels.ACTUATION, PercentageCommand.of("NOBODY", 50.0));
      case 1 ->
          send(
              connection,
              Channels.SENSED_OBJECTS,
              new Sphere().radius(1.0).uid("s" + number).x(0.0).y(0.0));
      default ->
          send(
              connection, Channels.FUNCTIONALITY, new FunctionalityRequest().serviceName("Nobody"));
    }
  }

  private static void send(Connection connection, Channel<?> channel, U2SAData message) {
    message.freeze();
    connection.publish(channel, message);
  }

  /** Hears nothing. */
  private static final class Deaf implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      throw new IllegalStateException("subscribed to nothing");
    }

    @Override
    public void trouble(String what) {
      // the flood ends with the connection, which is as well
    }
  }
}
