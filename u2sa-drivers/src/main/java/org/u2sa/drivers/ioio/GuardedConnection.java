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
 * Wraps an IOIOLib connection for two reasons. Writes must not block on the board, so a separate
 * thread sends. In addition, the library deadlocks if the connection ends while a pin is being
 * opened: {@code IOIOImpl.openUart} and similar methods lock the IOIO's monitor and then the
 * incoming state's, {@code IncomingState.handleConnectionLost} does the reverse. Therefore pins are
 * opened in {@link #whileUp}, and a disconnect is reported to the library only outside it. {@code
 * IOIOImpl.sync} locks in the same order, so a {@link BoardEcho} ends before the report.
 */
final class GuardedConnection implements IOIOConnection {
  private static final int BUFFER = 1024;

  /** Code that opens pins. */
  interface Opening<T> {
    T open() throws ConnectionLostException;
  }

  private final IOIOConnection link;
  private final boolean direct;
  private final ReentrantLock up = new ReentrantLock(); // held while opening pins
  private final AtomicLong received = new AtomicLong();
  private Optional<BoardEcho> echo = Optional.empty(); // guarded by up
  private volatile boolean handshaking;
  private volatile boolean ended;
  private volatile InputStream in;
  private volatile ReadingLoop loop; // null in real time and before connecting
  private volatile OutputStream out;
  private BoardWriter writer; // null if writes never block; guarded by this
  private boolean disconnected; // guarded by this

  /**
   * @param direct whether writes never block
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
        throw new ConnectionLostException(); // otherwise the writer would never end
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

  /** Opens pins unless the connection has ended, and meanwhile hides its end from the library. */
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

  /**
   * Starts querying the board; ends with the connection.
   *
   * @throws ConnectionLostException if the connection has ended
   */
  void start(BoardEcho asked) throws ConnectionLostException {
    whileUp(
        () -> {
          echo = Optional.of(asked);
          asked.start();
          return asked;
        });
  }

  /** Whether the transport is open, so that the board is expected to respond. */
  boolean isHandshaking() {
    return handshaking;
  }

  /** Whether the library has stopped reading. */
  boolean hasEnded() {
    return ended;
  }

  /**
   * In lockstep, lets the library consume bytes on the calling thread while its own thread waits.
   */
  void take(byte[] bytes) {
    received.addAndGet(bytes.length);
    loop.take(bytes);
  }

  /** Number of bytes received. */
  long received() {
    return received.get();
  }

  /** Counter of the library's output in lockstep; empty in real time and before connecting. */
  Optional<FlushCounter> flushes() {
    return out instanceof FlushCounter counter ? Optional.of(counter) : Optional.empty();
  }

  /** Ends the connection after flushing pending data, with a short time limit. */
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

  /** Stream to the library, whose reading thread closes it before announcing the end. */
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
        filled = 0; // in case the source fails
        filled = Math.max(0, source.read(buffer, 0, buffer.length));
        received.addAndGet(filled);
      }
      return next == filled ? -1 : buffer[next++] & 0xFF;
    }

    @Override
    public void close() throws IOException {
      up.lock();
      ended = true;
      Optional<BoardEcho> asked = echo;
      up.unlock();
      asked.ifPresent(BoardEcho::end);
      source.close();
    }
  }
}
