package org.u2sa.drivers.ioio;

import ioio.lib.api.IOIOConnection;
import ioio.lib.api.exception.ConnectionLostException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Another connection whose first attempt breaks after a number of bytes in one direction, or has
 * one byte changed.
 */
final class CutConnection implements BoardConnection {
  private static final int CHANGE = 0x55;

  private final BoardConnection whole;
  private int inputBytes;
  private int outputBytes;
  private final int changedAt; // index of the byte from the board
  private Cut first; // null before it
  private boolean isFirst; // whether the first is the present one
  private int read;

  /** One whose byte from the board at an index is changed. */
  static CutConnection garbled(BoardConnection whole, int index) {
    return new CutConnection(whole, Integer.MAX_VALUE, Integer.MAX_VALUE, index);
  }

  /** One that breaks. */
  CutConnection(BoardConnection whole, int inputBytes, int outputBytes) {
    this(whole, inputBytes, outputBytes, -1);
  }

  private CutConnection(BoardConnection whole, int inputBytes, int outputBytes, int changedAt) {
    this.whole = whole;
    this.changedAt = changedAt;
    this.inputBytes = inputBytes;
    this.outputBytes = outputBytes;
  }

  @Override
  public String address() {
    return whole.address();
  }

  @Override
  public boolean isLockstep() {
    return whole.isLockstep();
  }

  @Override
  public void exchange(long nowMicros, Consumer<byte[]> reader) {
    whole.exchange(nowMicros, bytes -> reader.accept(isFirst ? first.cut(bytes) : bytes));
  }

  @Override
  public synchronized IOIOConnection newConnection() {
    IOIOConnection connection = whole.newConnection();
    isFirst = first == null;
    if (!isFirst) {
      return connection;
    }
    first = new Cut(connection);
    return first;
  }

  private synchronized boolean mayRead() {
    return inputBytes-- > 0;
  }

  private synchronized boolean mayWrite() {
    return outputBytes-- > 0;
  }

  private final class Cut implements IOIOConnection {
    private final IOIOConnection connection;

    Cut(IOIOConnection connection) {
      this.connection = connection;
    }

    /** What is left of bytes that the library does not read itself. */
    byte[] cut(byte[] bytes) {
      for (int i = 0; i < bytes.length; i++) {
        if (!mayRead()) {
          connection.disconnect();
          return Arrays.copyOf(bytes, i);
        }
        bytes[i] ^= (byte) (read++ == changedAt ? CHANGE : 0);
      }
      return bytes;
    }

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
      InputStream source = connection.getInputStream();
      return new InputStream() {
        @Override
        public int read() throws IOException {
          if (mayRead()) {
            int octet = source.read();
            return read++ == changedAt && octet >= 0 ? octet ^ CHANGE : octet;
          }
          connection.disconnect();
          return -1;
        }

        @Override
        public int read(byte[] target, int offset, int length) throws IOException {
          int octet = read();
          if (octet < 0) {
            return -1;
          }
          target[offset] = (byte) octet;
          return 1;
        }

        @Override
        public void close() throws IOException {
          source.close();
        }
      };
    }

    @Override
    public OutputStream getOutputStream() throws ConnectionLostException {
      OutputStream target = connection.getOutputStream();
      return new OutputStream() {
        @Override
        public void write(int octet) throws IOException {
          if (!mayWrite()) {
            connection.disconnect();
            throw new IOException("cut");
          }
          target.write(octet);
        }
      };
    }

    @Override
    public boolean canClose() {
      return true;
    }
  }
}
