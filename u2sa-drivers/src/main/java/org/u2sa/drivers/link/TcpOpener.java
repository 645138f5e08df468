package org.u2sa.drivers.link;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;

/** Connects to a device server over TCP. */
final class TcpOpener implements Port.Opener {
  private static final int CONNECT_MS = 1_000;

  private final String host;
  private final int port;

  TcpOpener(String host, int port) {
    this.host = host;
    this.port = port;
  }

  @Override
  public Port open() throws IOException {
    Socket socket = new Socket();
    try {
      socket.connect(new InetSocketAddress(host, port), CONNECT_MS); // resolved on every attempt
      socket.setTcpNoDelay(true);
      socket.setSoTimeout(Port.PATIENCE_MS);
      return new Connected(host + ":" + port, socket);
    } catch (IOException | RuntimeException e) {
      socket.close();
      throw new IOException(
          "nobody answers at " + host + ":" + port + " (" + e.getMessage() + ")", e);
    }
  }

  private static final class Connected implements Port {
    private final String peer;
    private final Socket socket;
    private final InputStream in;
    private final OutputStream out;

    Connected(String peer, Socket socket) throws IOException {
      this.peer = peer;
      this.socket = socket;
      in = socket.getInputStream();
      out = socket.getOutputStream();
    }

    @Override
    public int read(byte[] buffer) throws IOException {
      try {
        int count = in.read(buffer);
        if (count < 0) {
          throw new EOFException(peer + " closed the connection");
        }
        return count;
      } catch (SocketTimeoutException e) {
        return 0; // a read timeout is normal
      }
    }

    @Override
    public void write(byte[] bytes) throws IOException {
      out.write(bytes);
      out.flush();
    }

    @Override
    public void close() throws IOException {
      socket.close();
    }
  }
}
