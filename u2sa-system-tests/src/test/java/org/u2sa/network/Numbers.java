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
import org.u2sa.interfaces.communication.MqttTransport;
import org.u2sa.interfaces.communication.Receiver;
import org.u2sa.messages.contract.GoalCommand;
import org.u2sa.messages.schema.MessageCodec;
import org.u2sa.messages.schema.MessageTypes;
import org.u2sa.messages.schema.U2SAData;

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
  }

  private final Process sender;
  private final BufferedReader said;
  private final Map<String, Ticks> ticks = new TreeMap<>(); // by channel
  private final Map<String, Connection> connections = new TreeMap<>();

  /** Begins to count with the first number: it awaits that both channels are heard. */
  Numbers(Process sender, String address, int port) throws IOException {
    this.sender = sender;
    said =
        new BufferedReader(new InputStreamReader(sender.getInputStream(), StandardCharsets.UTF_8));
    MqttTransport transport =
        new MqttTransport(address, port, "cessna", new MessageCodec(MessageTypes.discovered()));
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
    of.twice += of.arrived.get(number) ? 1 : 0;
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
    sender.destroyForcibly();
    Map<String, Balance> balances = new TreeMap<>();
    connections.forEach((name, connection) -> balances.put(name, balance(name, connection)));
    return balances;
  }

  private synchronized Balance balance(String name, Connection connection) {
    Ticks of = ticks.get(name);
    return new Balance(
        newest(name) - first(name) + 1, of.arrived.cardinality(), connection.missed(), of.twice);
  }

  /**
   * What became of the numbers from the first that arrived to the last.
   *
   * @param sent how many
   * @param received how many different ones arrived
   * @param missed how many the receiver's connection knows it missed
   * @param twice how many arrived more than once
   */
  record Balance(long sent, long received, long missed, long twice) {
    boolean isEven() {
      return sent == received + missed && twice == 0;
    }
  }

  @Override
  public void close() {
    sender.destroyForcibly();
    connections.values().forEach(Connection::close);
  }
}
