package org.u2sa.network;

import java.util.List;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;

/**
 * Sends numbered messages from a host, a hundred a second on a channel where each one counts and as
 * many on one where the newest counts, until its input ends; then says how many.
 */
final class NumberedMain {
  static final Channel<GoalCommand> EVERY = Channel.every("numbers-every", GoalCommand.TYPE);
  static final Channel<GoalCommand> LATEST =
      Channel.latest("numbers-latest", GoalCommand.TYPE, command -> "");
  private static final long PERIOD_MICROS = 10_000;

  private NumberedMain() {}

  /** Takes the broker's address, its port, and the system as whose message each number is sent. */
  public static void main(String[] arguments) throws Exception {
    MqttTransport transport =
        new MqttTransport(
                arguments[0],
                Integer.parseInt(arguments[1]),
                arguments[2],
                new MessageCodec(MessageTypes.discovered()))
            .waiting(30.0);
    Clock clock = new SystemClock();
    try (Connection connection = transport.connect("Numbered", new Silent());
        Clock.Waiter waiter = clock.newWaiter("numbered")) {
      System.out.println("sends");
      long sent = 0;
      while (System.in.available() == 0) { // any byte ends it
        send(connection, arguments[2], ++sent);
        waiter.await(clock.micros() + PERIOD_MICROS);
      }
      System.out.println(sent);
      System.in.read();
      while (System.in.available() == 0) { // more, uncounted, so that a gap at the end shows
        send(connection, arguments[2], ++sent);
        waiter.await(clock.micros() + PERIOD_MICROS);
      }
    }
  }

  private static void send(Connection connection, String system, long number) {
    for (Channel<GoalCommand> channel : List.of(EVERY, LATEST)) {
      GoalCommand command = new GoalCommand().uid(String.valueOf(number));
      command.systemId(system);
      command.freeze();
      connection.publish(channel, command); // whether it was taken or not, its number is used up
    }
  }

  /** Hears nothing, and expects its troubles. */
  static final class Silent implements Receiver {
    @Override
    public void receive(Channel<?> channel, U2SAData message) {
      throw new IllegalStateException("not subscribed to " + channel);
    }

    @Override
    public void trouble(String what) {
      System.err.println(what);
    }
  }
}
