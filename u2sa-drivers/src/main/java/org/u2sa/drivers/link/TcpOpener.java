package org.u2sa.drivers.link;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.util.Optional;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.SecuredSocket;

/** Connects to a device server over TCP. */
final class TcpOpener implements Port.Opener {
  private static final int CONNECT_MS = 1_000;
  private static final int LOGIN_MS = 25_000; // total time, however the bytes arrive

  private final String host;
  private final int port;
  private final Optional<BrokerAccess> access;

  /**
   * @param access user for a server with log-in, over TLS; empty: plain connection
   */
  TcpOpener(String host, int port, Optional<BrokerAccess> access) {
    this.host = host;
    this.port = port;
    this.access = access;
  }

  @Override
  public Port open() throws IOException {
    Socket socket = new Socket();
    try {
      socket.connect(new InetSocketAddress(host, port), CONNECT_MS); // resolved on every attempt
      socket.setTcpNoDelay(true);
      socket.setSoTimeout(LOGIN_MS);
      Socket spoken =
          access.isPresent()
              ? SecuredSocket.logIn(access.get(), socket, host, port, LOGIN_MS)
              : socket;
      socket.setSoTimeout(Port.PATIENCE_MS);
      return new Connected(host + ":" + port, socket, spoken);
    } catch (IOException | RuntimeException e) {
      socket.close();
      throw new IOException("no answer at " + host + ":" + port + " (" + e.getMessage() + ")", e);
    }
  }

  private static final class Connected implements Port {
    private final String peer;
    private final Socket socket;
    private final InputStream in;
    private final OutputStream out;

    /**
     * @param socket the plain socket, because closing an encrypted one waits for its writer
     * @param spoken the same socket, or the encrypted one
     */
    Connected(String peer, Socket socket, Socket spoken) throws IOException {
      this.peer = peer;
      this.socket = socket;
      in = spoken.getInputStream();
      out = spoken.getOutputStream();
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
