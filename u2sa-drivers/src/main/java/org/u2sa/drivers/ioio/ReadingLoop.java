package org.u2sa.drivers.ioio;

import java.io.IOException;
import java.io.InputStream;

/**
 * Runs the IOIO library's reader on the thread that provides the bytes. The library reads only on
 * its own thread, and waking and awaiting that thread costs far more than the reading.
 *
 * <p>The library's loop ({@code IOIOProtocol.IncomingThread.run}) keeps its state between messages
 * in fields only. So while its thread waits here between two messages, another thread runs the same
 * loop and leaves it with an error once all bytes are read. The loop closes its stream on any exit
 * and would then announce a lost connection, so {@link #close} rethrows the error.
 */
final class ReadingLoop extends InputStream {
  private static final byte[] NOTHING = {};

  /**
   * Exits the loop. A shared instance without stack trace, whose creation would dominate the cost.
   */
  private static final class AllRead extends Error {
    private static final long serialVersionUID = 1L;

    AllRead() {
      super("all is read", null, false, false);
    }
  }

  private final InputStream board;
  private final AllRead allRead = new AllRead();
  private volatile Thread owner; // the library's thread, from its first read
  private byte[] bytes = NOTHING; // this and the fields below belong to the consuming thread
  private int next;
  private boolean isLeaving;

  /**
   * @param board stream the library reads, blocking, on its own thread
   */
  ReadingLoop(InputStream board) {
    this.board = board;
  }

  /** Lets the library consume bytes while its own thread waits. */
  void take(byte[] come) {
    bytes = come;
    next = 0;
    isLeaving = false;
    Runnable loop = owner;
    try {
      loop.run(); // returns only on invalid bytes, after closing the stream
    } catch (AllRead e) {
      bytes = NOTHING;
    } catch (AssertionError e) {
      bytes = NOTHING; // also thrown on invalid bytes, after closing the stream
    }
  }

  @Override
  public int read() throws IOException {
    if (owner == null) {
      owner = Thread.currentThread();
    }
    if (isOwner()) {
      return board.read();
    }
    if (next == bytes.length) {
      isLeaving = true;
      throw allRead;
    }
    return bytes[next++] & 0xFF;
  }

  private boolean isOwner() {
    return Thread.currentThread() == owner;
  }

  @Override
  public void close() throws IOException {
    if (!isOwner() && isLeaving) {
      throw allRead;
    }
    board.close();
  }
}
