package org.u2sa.drivers.ioio;

import ioio.lib.api.IOIOConnection;
import ioio.lib.api.exception.ConnectionLostException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.locks.ReentrantLock;

/**
 * What stands between the IOIO library and a connection, for two reasons. Writing must not wait for
 * the board, so a thread of its own does it. And the library deadlocks when the connection ends
 * while a pin is being opened: {@code IOIOImpl.openUart} and its likes hold the IOIO's monitor and
 * ask for that of the incoming state, {@code IncomingState.handleConnectionLost} does the opposite.
 * So pins are opened in {@link #whileUp}, and the library hears of the end only outside of it.
 */
final class GuardedConnection implements IOIOConnection {
  private static final int BUFFER = 1024;

  /** Code that opens pins. */
  interface Opening<T> {
    T open() throws ConnectionLostException;
  }

  private final IOIOConnection link;
  private final boolean direct;
  private final ReentrantLock up = new ReentrantLock(); // held while pins are opened
  private final AtomicLong received = new AtomicLong();
  private volatile boolean handshaking;
  private volatile boolean ended;
  private volatile InputStream in;
  private volatile ReadingLoop loop; // null in real time, or before the connection
  private volatile OutputStream out;
  private BoardWriter writer; // null if writing does not wait; guarded by this
  private boolean disconnected; // guarded by this

  /**
   * @param direct whether writing never waits anyway
   */
  GuardedConnection(IOIOConnection link, boolean direct) {
    this.link = link;
    this.direct = direct;
  }

  @Override
  public void waitForConnect() throws ConnectionLostException {
    link.waitForConnect();
    InputStream source = link.getInputStream();
    OutputStream target = link.getOutputStream();
    synchronized (this) {
      if (disconnected) {
        throw new ConnectionLostException(); // and nobody would end the writer
      }
      in = new FromBoard(source);
      if (direct) {
        loop = new ReadingLoop(in);
        in = loop;
        out = new FlushCounter(target);
      } else {
        writer = new BoardWriter(target);
        out = writer;
      }
    }
    handshaking = true;
  }

  /** Opens pins, unless the connection has ended; it does not end meanwhile. */
  <T> T whileUp(Opening<T> opening) throws ConnectionLostException {
    up.lock();
    try {
      if (ended) {
        throw new ConnectionLostException();
      }
      return opening.open();
    } finally {
      up.unlock();
    }
  }

  /** Whether the way to the board is open, and so it is time that the board says something. */
  boolean isHandshaking() {
    return handshaking;
  }

  /** Whether the library reads no more. */
  boolean hasEnded() {
    return ended;
  }

  /** In lockstep, has the library take bytes on the calling thread while its own one waits. */
  void take(byte[] bytes) {
    received.addAndGet(bytes.length);
    loop.take(bytes);
  }

  /** How many bytes have come. */
  long received() {
    return received.get();
  }

  /**
   * What counts the library's writing in lockstep; empty in real time, or before the connection.
   */
  Optional<FlushCounter> flushes() {
    return out instanceof FlushCounter counter ? Optional.of(counter) : Optional.empty();
  }

  /**
   * Ends the connection; what was written goes out before, if that takes no longer than a blink.
   */
  @Override
  public void disconnect() {
    BoardWriter leaving;
    synchronized (this) {
      disconnected = true;
      leaving = writer;
    }
    if (leaving != null) {
      leaving.finish(!ended);
    }
    link.disconnect();
  }

  @Override
  public InputStream getInputStream() {
    return in;
  }

  @Override
  public OutputStream getOutputStream() {
    return out;
  }

  @Override
  public boolean canClose() {
    return link.canClose();
  }

  /**
   * The bytes to the library, whose reading thread closes this before it tells anyone of the end.
   */
  private final class FromBoard extends InputStream {
    private final InputStream source;
    private final byte[] buffer = new byte[BUFFER];
    private int next;
    private int filled;

    FromBoard(InputStream source) {
      this.source = source;
    }

    @Override
    public int read() throws IOException {
      if (next == filled) {
        next = 0;
        filled = 0; // should the source fail
        filled = Math.max(0, source.read(buffer, 0, buffer.length));
        received.addAndGet(filled);
      }
      return next == filled ? -1 : buffer[next++] & 0xFF;
    }

    @Override
    public void close() throws IOException {
      up.lock();
      ended = true;
      up.unlock();
      source.close();
    }
  }
}
