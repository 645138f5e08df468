package org.u2sa.flightgear.link;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.channels.ServerSocketChannel;
import org.u2sa.flightgear.protocol.InLine;
import org.u2sa.flightgear.protocol.OutLine;

/**
 * One of the stand-in's input and output channels, worked on in each of its frames, as FlightGear
 * does.
 */
interface StandInChannel extends Closeable {
  /**
   * Works one frame.
   *
   * @param told the last commands received
   * @param line the line of this frame
   * @return the commands received now
   * @throws IOException if the channel is lost for good
   */
  InLine work(InLine told, OutLine line) throws IOException;

  /**
   * A port that does not block.
   *
   * @throws IOException if the port is taken
   */
  static ServerSocketChannel listen(String host, int port) throws IOException {
    ServerSocketChannel server = ServerSocketChannel.open();
    try {
      server.bind(new InetSocketAddress(host, port));
      server.configureBlocking(false);
    } catch (IOException e) {
      server.close();
      throw new IOException("cannot listen on " + host + ":" + port + ": " + e.getMessage(), e);
    }
    return server;
  }
}
