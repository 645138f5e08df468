package org.u2sa.drivers.ioio;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/**
 * In lockstep, tracks whether and by which thread the IOIO library has sent a UART's data, and runs
 * the library's sending loop until it has.
 */
final class FlushCounter extends OutputStream {
  private static final int HEADER = 2; // header of a UART data message: type; number and length
  private static final long AT_MOST_MS = 5_000;

  /**
   * Exits the library's loop. A shared instance without stack trace, whose creation would dominate
   * the cost.
   */
  private static final class AllSent extends Error {
    private static final long serialVersionUID = 1L;

    AllSent() {
      super("all is sent", null, false, false);
    }
  }

  private final AllSent allSent = new AllSent();
  private final OutputStream target;
  private final ByteArrayOutputStream waiting =
      new ByteArrayOutputStream(); // until the library flushes; guarded by this, like all fields
  // below
  private long dataSent; // flushed bytes, excluding one header per flush
  private long dataExpected;
  private boolean isLeft; // exit by error once all data is sent
  private Thread sender; // thread that sent the last data

  FlushCounter(OutputStream target) {
    this.target = target;
  }

  @Override
  public synchronized void write(int octet) throws IOException {
    waiting.write(octet);
  }

  @Override
  public synchronized void flush() throws IOException {
    byte[] bytes = waiting.toByteArray();
    waiting.reset();
    target.write(bytes); // all at once: the library writes byte by byte
    target.flush();
    dataSent += bytes.length - HEADER;
    sender = Thread.currentThread();
    notifyAll();
    if (isLeft && dataSent >= dataExpected) {
      isLeft = false;
      throw allSent;
    }
  }

  /** Starts counting; nothing else may be written until the data is sent. */
  synchronized void expect(int dataBytes) {
    dataSent = 0;
    dataExpected = dataBytes;
  }

  /** Runs the library's sending loop until the data is sent or it would block. */
  void run(Runnable loop) {
    leave(true);
    try {
      loop.run();
    } catch (AllSent e) {
      return; // nothing follows the flush: the message was sent whole
    } finally {
      leave(false);
    }
  }

  private synchronized void leave(boolean whenSent) {
    isLeft = whenSent;
  }

  /** Waits until the data is sent and returns the library thread that sent it. */
  synchronized Thread awaitSender() throws IOException, InterruptedException {
    while (dataSent < dataExpected) {
      long before = dataSent;
      wait(AT_MOST_MS);
      if (dataSent == before) {
        requireAll();
      }
    }
    return sender;
  }

  /**
   * @throws IOException if not all data is sent
   */
  synchronized void requireAll() throws IOException {
    if (dataSent < dataExpected) {
      throw new IOException("the IOIO library does not send the data written to a UART");
    }
  }
}
