package org.u2sa.network;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.BitSet;
import java.util.Map;
import java.util.TreeMap;
import org.awaitility.Awaitility;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Connection;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.mission.GoalCommand;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.testkit.ProcessTree;

/**
 * Ticks off what a {@link NumberedMain} on another host sends: each number must arrive or be
 * counted as missed, and none may come twice.
 */
final class Numbers implements Receiver, AutoCloseable {
  private static final Duration ARRIVES_WITHIN = Duration.ofSeconds(60);

  /** Messages of one channel. */
  private static final class Ticks {
    private final BitSet arrived = new BitSet();
    private long twice;
    private long late; // after a greater one, and so counted as missed
  }

  private final Process sender;
  private final BufferedReader said;
  private final Map<String, Ticks> ticks = new TreeMap<>(); // by channel
  private final Map<String, Connection> connections = new TreeMap<>();

  /** Begins to count with the first number: it awaits that both channels are heard. */
  Numbers(Process sender, String address, int port, String system) throws IOException {
    this.sender = sender;
    said =
        new BufferedReader(new InputStreamReader(sender.getInputStream(), StandardCharsets.UTF_8));
    MqttTransport transport =
        new MqttTransport(address, port, system, new MessageCodec(MessageTypes.discovered()));
    for (Channel<?> channel : new Channel<?>[] {NumberedMain.EVERY, NumberedMain.LATEST}) {
      ticks.put(channel.name(), new Ticks());
      Connection connection = transport.connect("Numbers-" + channel.name(), this);
      connection.subscribe(channel);
      connections.put(channel.name(), connection);
    }
    Awaitility.await("numbers arrive")
        .atMost(ARRIVES_WITHIN)
        .until(() -> ticks.keySet().stream().allMatch(name -> first(name) > 0));
  }

  @Override
  public synchronized void receive(Channel<?> channel, U2SAData message) {
    Ticks of = ticks.get(channel.name());
    int number = Integer.parseInt(((GoalCommand) message).uid());
    boolean isNew = !of.arrived.get(number);
    of.twice += isNew ? 0 : 1;
    of.late += isNew && number < of.arrived.length() ? 1 : 0;
    of.arrived.set(number);
  }

  @Override
  public void trouble(String what) {
    // expected throughout: what counts is the sum at the end
  }

  private synchronized long first(String channel) {
    return ticks.get(channel).arrived.nextSetBit(0);
  }

  private synchronized long newest(String channel) {
    return ticks.get(channel).arrived.length() - 1L;
  }

  /** Ends the sending and returns the balance of each channel. */
  Map<String, Balance> finish() throws IOException {
    sender.getOutputStream().write('\n');
    sender.getOutputStream().flush();
    String line = said.readLine();
    long sent = Long.parseLong("sends".equals(line) ? said.readLine() : line);
    Awaitility.await("later numbers arrive")
        .atMost(ARRIVES_WITHIN)
        .until(() -> ticks.keySet().stream().allMatch(name -> newest(name) > sent));
    ProcessTree.kill(sender);
    Map<String, Balance> balances = new TreeMap<>();
    connections.forEach((name, connection) -> balances.put(name, balance(name, connection)));
    return balances;
  }

  private synchronized Balance balance(String name, Connection connection) {
    Ticks of = ticks.get(name);
    return new Balance(
        newest(name) - first(name) + 1,
        of.arrived.cardinality(),
        connection.missed() - of.late,
        of.twice,
        of.late);
  }

  /**
   * What became of the numbers from the first that arrived to the last.
   *
   * @param sent how many
   * @param received how many different ones arrived
   * @param missed how many the receiver's connection knows it missed, without those that came late
   * @param twice how many arrived more than once
   * @param late how many arrived after a greater one
   */
  record Balance(long sent, long received, long missed, long twice, long late) {
    /** Whether each arrived once, in order, or is counted as missed. */
    boolean isEven() {
      return isAccounted() && twice == 0 && late == 0;
    }

    /** Whether each arrived, perhaps late or twice as QoS 1 allows, or is counted as missed. */
    boolean isAccounted() {
      return sent == received + missed;
    }
  }

  @Override
  public void close() {
    ProcessTree.kill(sender);
    connections.values().forEach(Connection::close);
  }
}
