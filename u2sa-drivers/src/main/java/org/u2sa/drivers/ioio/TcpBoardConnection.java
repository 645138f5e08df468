package org.u2sa.drivers.ioio;

import ioio.lib.api.IOIOConnection;
import ioio.lib.api.exception.ConnectionLostException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetSocketAddress;
import java.net.Socket;

/**
 * A connection over TCP to where a board is served: the firmware simulator, or a serial port on the
 * network. The library's own socket connection waits for a board that calls, which none does today.
 */
final class TcpBoardConnection implements IOIOConnection {
  private static final int CONNECT_WITHIN_MS = 2000;

  private final String host;
  private final int port;
  private final Socket socket = new Socket();

  TcpBoardConnection(String host, int port) {
    this.host = host;
    this.port = port;
  }

  @Override
  public void waitForConnect() throws ConnectionLostException {
    try {
      socket.setTcpNoDelay(true);
      socket.connect(new InetSocketAddress(host, port), CONNECT_WITHIN_MS);
    } catch (IOException e) {
      disconnect();
      throw new ConnectionLostException(e);
    }
  }

  @Override
  public void disconnect() {
    try {
      socket.close();
    } catch (IOException e) {
      throw new IllegalStateException("socket to " + host + ":" + port + " does not close", e);
    }
  }

  @Override
  public InputStream getInputStream() throws ConnectionLostException {
    try {
      return socket.getInputStream();
    } catch (IOException e) {
      throw new ConnectionLostException(e);
    }
  }

  @Override
  public OutputStream getOutputStream() throws ConnectionLostException {
    try {
      return socket.getOutputStream();
    } catch (IOException e) {
      throw new ConnectionLostException(e);
    }
  }

  @Override
  public boolean canClose() {
    return true;
  }
}
