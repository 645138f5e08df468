package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.SocketChannel;

/** A {@link BrokerChannel} without encryption. */
final class PlainChannel implements BrokerChannel {
  private final SocketChannel socket;

  PlainChannel(SocketChannel socket) {
    this.socket = socket;
  }

  @Override
  public int read(ByteBuffer to) throws IOException {
    return socket.read(to);
  }

  @Override
  public int write(ByteBuffer from) throws IOException {
    return socket.write(from);
  }

  @Override
  public boolean hasUnread() {
    return false;
  }

  @Override
  public boolean hasUnsent() {
    return false;
  }

  @Override
  public boolean isOpen() {
    return socket.isOpen();
  }

  @Override
  public void close() throws IOException {
    socket.close();
  }
}
