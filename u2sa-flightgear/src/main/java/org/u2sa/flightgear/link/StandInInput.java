package org.u2sa.flightgear.link;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.util.ArrayList;
import java.util.List;
import org.u2sa.flightgear.protocol.InLine;
import org.u2sa.flightgear.protocol.LineSplitter;
import org.u2sa.flightgear.protocol.MalformedLineException;
import org.u2sa.flightgear.protocol.OutLine;

/**
 * Input channel of the stand-in. Like FlightGear it serves one client at a time. After a client
 * that closed in mid-line, without sending anything, or by a reset, it accepts connections but
 * ignores them permanently.
 */
final class StandInInput implements StandInChannel {
  private final ServerSocketChannel server;
  private final ByteBuffer buffer = ByteBuffer.allocate(16_384);
  private final List<SocketChannel> ignored = new ArrayList<>();
  private SocketChannel client;
  private LineSplitter lines = new LineSplitter();
  private boolean spoke;
  private boolean dead;
  private InLine told = InLine.nothing();
  private String poison = "";

  /**
   * @throws IOException if the port is taken
   */
  StandInInput(String host, int port) throws IOException {
    server = StandInChannel.listen(host, port);
  }

  int port() {
    return server.socket().getLocalPort();
  }

  @Override
  public InLine work(InLine before, OutLine line) throws IOException {
    told = before;
    if (dead) {
      for (SocketChannel next = server.accept(); next != null; next = server.accept()) {
        ignored.add(next);
      }
      return told;
    }
    if (client == null) {
      client = server.accept();
      if (client == null) {
        return told;
      }
      client.configureBlocking(false);
      lines = new LineSplitter();
      spoke = false;
    }
    hear();
    if (!poison.isEmpty()) {
      throw new IOException(poison);
    }
    return told;
  }

  private void hear() throws IOException {
    try {
      for (int got = read(); got != 0; got = read()) {
        if (got < 0) {
          hangUp(!spoke || lines.isInsideLine());
          return;
        }
        spoke = true;
        buffer.flip();
        lines.feed(buffer, this::take, start -> take(start));
      }
    } catch (IOException reset) { // handled as in FlightGear
      hangUp(true);
    }
  }

  private int read() throws IOException {
    buffer.clear();
    return client.read(buffer);
  }

  private void take(String line) {
    try {
      told = told.after(line);
    } catch (MalformedLineException e) {
      poison = e.getMessage();
    }
  }

  private void hangUp(boolean forEver) throws IOException {
    dead = forEver;
    client.close();
    client = null;
  }

  @Override
  public void close() throws IOException {
    server.close();
    if (client != null) {
      client.close();
    }
    for (SocketChannel one : ignored) {
      one.close();
    }
  }
}
