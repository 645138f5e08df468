package org.u2sa.drivers.ioio;

import java.io.IOException;
import java.io.InputStream;

/**
 * Has the IOIO library read on the thread that has bytes for it. The library reads on a thread of
 * its own only, and to wake that and wait for it takes far longer than the reading.
 *
 * <p>The library's loop ({@code IOIOProtocol.IncomingThread.run}) keeps nothing from one message to
 * the next but fields. So while its thread waits here for bytes, between two messages, another one
 * runs the same loop, and leaves it by an error when all is read. The loop closes its stream
 * whatever leaves it, and would tell everyone that the connection is lost if that returned: so
 * {@link #close} throws the error again.
 */
final class ReadingLoop extends InputStream {
  private static final byte[] NOTHING = {};

  /** Leaves the loop. The same one each time, without a stack trace: that would take longest. */
  private static final class AllRead extends Error {
    private static final long serialVersionUID = 1L;

    AllRead() {
      super("all is read", null, false, false);
    }
  }

  private final InputStream board;
  private final AllRead allRead = new AllRead();
  private volatile Thread owner; // the library's, from its first read on
  private byte[] bytes = NOTHING; // this and what follows belongs to the thread that takes bytes
  private int next;
  private boolean isLeaving;

  /**
   * @param board the bytes that the library reads on its own thread, which waits there
   */
  ReadingLoop(InputStream board) {
    this.board = board;
  }

  /** Has the library take bytes, while its own thread waits for some. */
  void take(byte[] come) {
    bytes = come;
    next = 0;
    isLeaving = false;
    Runnable loop = owner;
    try {
      loop.run(); // returns if the bytes were wrong: it has closed the stream, then
    } catch (AllRead e) {
      bytes = NOTHING;
    } catch (AssertionError e) {
      bytes = NOTHING; // so it says of wrong bytes, too, and has closed the stream
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
