package org.u2sa.flightgear.link;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import org.u2sa.flightgear.protocol.InLine;
import org.u2sa.flightgear.protocol.OutLine;

/**
 * Output channel of the stand-in. Like FlightGear it connects only once, and the whole program
 * freezes while the peer does not read.
 */
final class StandInOutput implements StandInChannel {
  private static final int PATIENCE_MS = 2_000;

  private final SocketChannel channel = SocketChannel.open();

  /**
   * @throws IOException if there is no listener; the channel then does not exist
   */
  StandInOutput(String host, int port) throws IOException {
    try {
      channel.socket().connect(new InetSocketAddress(host, port), PATIENCE_MS);
      channel.socket().setTcpNoDelay(true);
    } catch (IOException e) {
      channel.close();
      throw new IOException("no listener on " + host + ":" + port + ": " + e.getMessage(), e);
    }
  }

  @Override
  public InLine work(InLine told, OutLine line) throws IOException {
    ByteBuffer bytes = ByteBuffer.wrap((line.format() + "\n").getBytes(StandardCharsets.US_ASCII));
    while (bytes.hasRemaining()) {
      channel.write(bytes);
    }
    return told;
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
