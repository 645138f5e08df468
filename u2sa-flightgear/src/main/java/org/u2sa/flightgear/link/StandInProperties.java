package org.u2sa.flightgear.link;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import org.u2sa.flightgear.protocol.LineSplitter;
import org.u2sa.flightgear.protocol.OutField;
import org.u2sa.flightgear.protocol.OutLine;
import org.u2sa.flightgear.protocol.ProtocolFiles;

/**
 * Property server of the stand-in: the part of FlightGear's that {@link Repair} and {@code
 * scripts/flightgear/property} use, that is readings, speed-up and channel commands.
 */
final class StandInProperties implements Closeable {
  private static final String SPEED_UP = "/sim/speed-up";
  private static final int CONFIG_PARTS = 8; // generic,socket,out,20,127.0.0.1,5501,tcp,u2sa-out

  private final StandInFlightGear standIn;
  private final Map<String, String> configs = new HashMap<>(); // channel configurations by path
  private final ServerSocketChannel server;
  private final List<Client> clients = new ArrayList<>();
  private final ByteBuffer buffer = ByteBuffer.allocate(4_096);

  /**
   * @throws IOException if the port is taken
   */
  StandInProperties(StandInFlightGear standIn, String host, int port) throws IOException {
    this.standIn = standIn;
    server = StandInChannel.listen(host, port);
  }

  int port() {
    return server.socket().getLocalPort();
  }

  /** Answers requests received since the last frame. */
  void work() throws IOException {
    for (SocketChannel next = server.accept(); next != null; next = server.accept()) {
      next.configureBlocking(false);
      clients.add(new Client(next));
    }
    for (Iterator<Client> each = clients.iterator(); each.hasNext(); ) {
      Client client = each.next();
      if (!serve(client)) {
        client.channel.close();
        each.remove();
      }
    }
  }

  private boolean serve(Client client) {
    try {
      buffer.clear();
      int got = client.channel.read(buffer);
      if (got < 0) {
        return false;
      }
      buffer.flip();
      List<String> asked = new ArrayList<>();
      client.lines.feed(buffer, asked::add, asked::add);
      for (String line : asked) {
        String answer = answer(client, line.trim());
        client.channel.write(ByteBuffer.wrap(answer.getBytes(StandardCharsets.ISO_8859_1)));
      }
      return true;
    } catch (IOException gone) { // a reset counts as a close
      return false;
    }
  }

  private String answer(Client client, String line) {
    List<String> words = List.of(line.split(" +"));
    String prompt = client.bare ? "" : "/> ";
    switch (words.get(0)) {
      case "data" -> client.bare = true;
      case "get" -> {
        String path = words.size() > 1 ? words.get(1) : "";
        String value = get(path);
        return (client.bare ? value : path + " = '" + value + "' (double)") + "\r\n" + prompt;
      }
      case "set" -> {
        if (words.size() > 2) {
          set(words.get(1), words.get(2));
        }
        return prompt;
      }
      case "run" -> {
        boolean done = words.size() > 1 && run(words.get(1), words.subList(2, words.size()));
        return (done ? "<completed>" : "*failed*") + "\r\n" + prompt;
      }
      default -> {
        return client.bare ? "" : "-ERR unknown command\r\n" + prompt;
      }
    }
    return "";
  }

  /** Records how a channel was opened, for later queries. */
  void noteConfig(String name, String direction, String host, int port, String protocol) {
    configs.put(
        "/io/channels/" + name + "/config",
        "generic,socket," + direction + ",20," + host + "," + port + ",tcp," + protocol);
  }

  /** Returns the value of a property as text; empty if unset. */
  private String get(String path) {
    OutLine said = standIn.said();
    for (OutField field : OutField.values()) {
      if (field.node().equals(path)) {
        return said.format().split(",", -1)[field.ordinal()];
      }
    }
    return path.equals(SPEED_UP)
        ? String.valueOf(standIn.speedUp())
        : configs.getOrDefault(path, "");
  }

  /** Sets a property. */
  private void set(String path, String value) {
    if (path.equals(SPEED_UP) && value.matches("[0-9]{1,2}([.][0-9]+)?")) {
      standIn.speedUp(Double.parseDouble(value));
    }
  }

  /**
   * Runs a command with arguments "name=value".
   *
   * @return whether it succeeded
   */
  private boolean run(String command, List<String> arguments) {
    Map<String, String> values = new HashMap<>();
    for (String argument : arguments) {
      int equals = argument.indexOf('=');
      if (equals > 0) {
        values.put(argument.substring(0, equals), argument.substring(equals + 1));
      }
    }
    String name = values.getOrDefault("name", "");
    return switch (command) {
      case "exit" -> {
        standIn.exit();
        yield true;
      }
      case "remove-io-channel" -> standIn.remove(name);
      case "add-io-channel" -> add(name, values.getOrDefault("config", "").split(",", -1));
      default -> false;
    };
  }

  private boolean add(String name, String[] config) {
    if (name.isEmpty() || config.length != CONFIG_PARTS || !config[5].matches("[0-9]{1,5}")) {
      return false;
    }
    int port = Integer.parseInt(config[5]);
    noteConfig(name, config[2], config[4], port, config[7]);
    if (config[2].equals("out") && config[7].equals(ProtocolFiles.OUT)) {
      return standIn.add(name, () -> new StandInOutput(config[4], port));
    }
    return config[2].equals("in")
        && config[7].equals(ProtocolFiles.IN)
        && standIn.add(name, () -> new StandInInput(standIn.host(), port));
  }

  @Override
  public void close() throws IOException {
    server.close();
    for (Client client : clients) {
      client.channel.close();
    }
  }

  /** One connection. */
  private static final class Client {
    private final SocketChannel channel;
    private final LineSplitter lines = new LineSplitter();
    private boolean bare;

    private Client(SocketChannel channel) {
      this.channel = channel;
    }
  }
}
