package org.u2sa.flightgear.link;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.channels.ServerSocketChannel;
import org.u2sa.flightgear.protocol.InLine;
import org.u2sa.flightgear.protocol.OutLine;

/** One of the stand-in's input or output channels, processed once a frame as in FlightGear. */
interface StandInChannel extends Closeable {
  /**
   * Processes one frame.
   *
   * @param told last commands received
   * @param line output line of this frame
   * @return commands received in this frame
   * @throws IOException if the channel is permanently lost
   */
  InLine work(InLine told, OutLine line) throws IOException;

  /**
   * Opens a non-blocking listening port.
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
