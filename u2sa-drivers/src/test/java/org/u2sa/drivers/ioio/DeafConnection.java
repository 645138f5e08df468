package org.u2sa.drivers.ioio;

import ioio.lib.api.IOIOConnection;
import ioio.lib.api.exception.ConnectionLostException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/** Another connection that can lose what is sent to the board, while the board's bytes arrive. */
final class DeafConnection implements BoardConnection {
  private final BoardConnection whole;
  private volatile boolean deaf;

  DeafConnection(BoardConnection whole) {
    this.whole = whole;
  }

  /** Loses what is sent from now on, or no more. */
  void deaf(boolean on) {
    deaf = on;
  }

  @Override
  public String address() {
    return whole.address();
  }

  @Override
  public IOIOConnection newConnection() {
    IOIOConnection connection = whole.newConnection();
    return new IOIOConnection() {
      @Override
      public void waitForConnect() throws ConnectionLostException {
        connection.waitForConnect();
      }

      @Override
      public void disconnect() {
        connection.disconnect();
      }

      @Override
      public InputStream getInputStream() throws ConnectionLostException {
        return connection.getInputStream();
      }

      @Override
      public OutputStream getOutputStream() throws ConnectionLostException {
        OutputStream target = connection.getOutputStream();
        return new OutputStream() {
          @Override
          public void write(int octet) throws IOException {
            if (!deaf) {
              target.write(octet);
            }
          }
        };
      }

      @Override
      public boolean canClose() {
        return true;
      }
    };
  }
}
