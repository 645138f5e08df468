package org.u2sa.drivers.ioio;

import ioio.lib.api.IOIOConnection;
import ioio.lib.api.exception.ConnectionLostException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Arrays;
import org.u2sa.drivers.link.ByteLinks;
import org.u2sa.drivers.link.Port;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.mqtt.BrokerAccess;

/**
 * A board on a desktop serial port (IOIO-OTG on USB) or over TCP: the firmware simulator or a
 * network serial port. The library's own socket connection waits for the board to connect, which no
 * current board does.
 *
 * <p>The board treats the DTR signal as the connection: on its rise it identifies itself; on its
 * fall, when the port closes or the process dies, it resets its pins.
 */
final class PortConnection implements IOIOConnection {
  private final Port.Opener opener;
  private Port port; // null before and after the connection; guarded by this
  private volatile boolean ended;

  private PortConnection(Port.Opener opener) {
    this.opener = opener;
  }

  private record Address(String address, Port.Opener opener) implements BoardConnection {
    @Override
    public IOIOConnection newConnection() {
      return new PortConnection(opener);
    }
  }

  /** See {@link BoardConnection#of}. */
  static BoardConnection at(String address) {
    try {
      return new Address(address, ByteLinks.opener(address));
    } catch (BadInputException e) {
      throw new BadInputException(
          "IOIO: \""
              + address
              + "\" is not an address, serial:/dev/ttyACM0, tcp:host:port or tls:host:port expected: "
              + e.getMessage(),
          e);
    }
  }

  /**
   * The same for a board that requires a user.
   *
   * @throws BadInputException if the address is not {@code tls:HOST:PORT}
   */
  static BoardConnection at(String address, BrokerAccess access) {
    return new Address(address, ByteLinks.opener(address, access));
  }

  @Override
  public void waitForConnect() throws ConnectionLostException {
    try {
      Port opened = opener.open();
      synchronized (this) {
        port = opened;
      }
      if (ended) {
        disconnect();
        throw new ConnectionLostException();
      }
    } catch (IOException e) {
      throw new ConnectionLostException(e);
    }
  }

  @Override
  public void disconnect() {
    ended = true;
    Port open;
    synchronized (this) {
      open = port;
      port = null;
    }
    try {
      if (open != null) {
        open.close();
      }
    } catch (IOException e) {
      throw new IllegalStateException("the connection to the IOIO does not close", e);
    }
  }

  private synchronized Port port() throws ConnectionLostException {
    if (port == null) {
      throw new ConnectionLostException();
    }
    return port;
  }

  @Override
  public InputStream getInputStream() throws ConnectionLostException {
    Port source = port();
    return new InputStream() {
      @Override
      public int read() throws IOException {
        byte[] one = new byte[1];
        return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
      }

      @Override
      public int read(byte[] target, int offset, int length) throws IOException {
        byte[] buffer = new byte[length];
        int count = 0;
        while (count == 0 && !ended) {
          count = source.read(buffer); // blocks only briefly
        }
        System.arraycopy(buffer, 0, target, offset, count);
        return count == 0 ? -1 : count;
      }
    };
  }

  @Override
  public OutputStream getOutputStream() throws ConnectionLostException {
    Port target = port();
    return new OutputStream() {
      @Override
      public void write(int octet) throws IOException {
        target.write(new byte[] {(byte) octet});
      }

      @Override
      public void write(byte[] bytes, int offset, int length) throws IOException {
        target.write(Arrays.copyOfRange(bytes, offset, offset + length));
      }
    };
  }

  @Override
  public boolean canClose() {
    return true;
  }
}
