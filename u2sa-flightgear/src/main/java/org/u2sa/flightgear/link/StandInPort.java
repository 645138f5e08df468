package org.u2sa.flightgear.link;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.channels.ServerSocketChannel;

/** A port at which the stand-in listens; it asks between its frames who has come. */
final class StandInPort {
  private StandInPort() {}

  /**
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
