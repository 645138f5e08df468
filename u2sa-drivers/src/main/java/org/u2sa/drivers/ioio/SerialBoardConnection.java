package org.u2sa.drivers.ioio;

import com.fazecast.jSerialComm.SerialPort;
import com.fazecast.jSerialComm.SerialPortInvalidPortException;
import ioio.lib.api.IOIOConnection;
import ioio.lib.api.exception.ConnectionLostException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/**
 * A IOIO-OTG as a USB serial port of a desktop. The board takes the signal DTR for the connection:
 * with its rise it says who it is, with its fall, as when the port is closed or the process dies,
 * it resets its pins.
 */
final class SerialBoardConnection implements IOIOConnection {
  private static final int READ_TIMEOUT_MS = 100; // how long a reader takes to see the end

  private final String name;
  private SerialPort port; // null before and after; guarded by this
  private volatile boolean ended;

  SerialBoardConnection(String name) {
    this.name = name;
  }

  @Override
  public synchronized void waitForConnect() throws ConnectionLostException {
    if (ended) {
      throw new ConnectionLostException();
    }
    try {
      SerialPort candidate = SerialPort.getCommPort(name);
      candidate.setComPortTimeouts(SerialPort.TIMEOUT_READ_SEMI_BLOCKING, READ_TIMEOUT_MS, 0);
      if (!candidate.openPort()) {
        throw lost("does not open (error " + candidate.getLastErrorCode() + ")", null);
      }
      candidate.clearDTR();
      candidate.setDTR();
      port = candidate;
    } catch (SerialPortInvalidPortException e) {
      throw lost("is not there", e);
    } catch (LinkageError e) { // a phone has no such natives: first unsatisfied, then no class
      throw lost("cannot be opened: no serial ports on this platform", e);
    }
  }

  private ConnectionLostException lost(String how, Throwable cause) {
    return new ConnectionLostException(new IOException("serial port " + name + " " + how, cause));
  }

  @Override
  public synchronized void disconnect() {
    ended = true;
    if (port != null) {
      port.closePort();
      port = null;
    }
  }

  private synchronized SerialPort port() throws ConnectionLostException {
    if (port == null) {
      throw new ConnectionLostException();
    }
    return port;
  }

  @Override
  public InputStream getInputStream() throws ConnectionLostException {
    return new FromPort(port());
  }

  @Override
  public OutputStream getOutputStream() throws ConnectionLostException {
    return port().getOutputStream();
  }

  @Override
  public boolean canClose() {
    return true;
  }

  /** Waits for bytes over the port's own time-outs, until the connection ends. */
  private final class FromPort extends InputStream {
    private final SerialPort source;

    FromPort(SerialPort source) {
      this.source = source;
    }

    @Override
    public int read() throws IOException {
      byte[] one = new byte[1];
      return read(one, 0, 1) < 0 ? -1 : one[0] & 0xFF;
    }

    @Override
    public int read(byte[] target, int offset, int length) throws IOException {
      byte[] buffer = offset == 0 && length == target.length ? target : new byte[length];
      while (!ended) {
        int count = source.readBytes(buffer, length);
        if (count < 0) {
          throw new IOException("serial port " + name + " is gone");
        }
        if (count > 0) {
          System.arraycopy(buffer, 0, target, offset, count);
          return count;
        }
      }
      return -1;
    }
  }
}
