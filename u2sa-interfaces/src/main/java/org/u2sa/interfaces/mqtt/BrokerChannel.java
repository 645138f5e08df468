package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.ByteChannel;
import java.nio.channels.SocketChannel;

/**
 * Bytes from and to the broker, never blocking. One reader and one writer thread at a time may use
 * it concurrently.
 */
interface BrokerChannel extends ByteChannel {
  /** Whether bytes have arrived that a selector does not announce; asked by the reading thread. */
  boolean hasUnread();

  /** Whether the next write has something to send besides its own bytes. */
  boolean hasUnsent();

  /** A channel without encryption, over a connected and non-blocking socket. */
  record Plain(SocketChannel socket) implements BrokerChannel {
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
}
