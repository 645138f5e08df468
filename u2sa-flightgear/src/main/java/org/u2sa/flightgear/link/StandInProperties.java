package org.u2sa.flightgear.link;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import org.u2sa.flightgear.protocol.LineSplitter;

/**
 * Property server of the stand-in: the part of FlightGear's that {@link Repair} and {@code
 * scripts/flightgear/property} use.
 */
final class StandInProperties implements Closeable {
  private final ServerSocketChannel server;
  private final List<Client> clients = new ArrayList<>();
  private final ByteBuffer buffer = ByteBuffer.allocate(4_096);

  /**
   * @throws IOException if the port is taken
   */
  StandInProperties(String host, int port) throws IOException {
    server = StandInChannel.listen(host, port);
  }

  int port() {
    return server.socket().getLocalPort();
  }

  /** Answers requests received since the last frame. */
  void work(StandInCommands simulator) throws IOException {
    for (SocketChannel next = server.accept(); next != null; next = server.accept()) {
      next.configureBlocking(false);
      clients.add(new Client(next));
    }
    for (Iterator<Client> each = clients.iterator(); each.hasNext(); ) {
      Client client = each.next();
      if (!serve(client, simulator)) {
        client.channel.close();
        each.remove();
      }
    }
  }

  private boolean serve(Client client, StandInCommands simulator) {
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
        String answer = answer(client, line.trim(), simulator);
        client.channel.write(ByteBuffer.wrap(answer.getBytes(StandardCharsets.ISO_8859_1)));
      }
      return true;
    } catch (IOException gone) { // a reset counts as a close
      return false;
    }
  }

  private static String answer(Client client, String line, StandInCommands simulator) {
    List<String> words = List.of(line.split(" +"));
    String prompt = client.bare ? "" : "/> ";
    switch (words.get(0)) {
      case "data" -> client.bare = true;
      case "get" -> {
        String path = words.size() > 1 ? words.get(1) : "";
        String value = simulator.get(path);
        return (client.bare ? value : path + " = '" + value + "' (double)") + "\r\n" + prompt;
      }
      case "set" -> {
        if (words.size() > 2) {
          simulator.set(words.get(1), words.get(2));
        }
        return prompt;
      }
      case "run" -> {
        boolean done =
            words.size() > 1 && simulator.run(words.get(1), words.subList(2, words.size()));
        return (done ? "<completed>" : "*failed*") + "\r\n" + prompt;
      }
      default -> {
        return client.bare ? "" : "-ERR unknown command\r\n" + prompt;
      }
    }
    return "";
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
