package org.u2sa.drivers.ioio;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/**
 * Tells in lockstep whether, and by which thread, the IOIO library has sent a UART's data, and runs
 * the library's sending loop until it has.
 */
final class FlushCounter extends OutputStream {
  private static final int HEADER = 2; // of a message of UART data: type; number and length
  private static final long AT_MOST_MS = 5_000;

  /**
   * Leaves the library's loop. The same one each time, without a stack trace: that takes longest.
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
      new ByteArrayOutputStream(); // until the library flushes; guarded by this, as all below
  private long dataSent; // bytes of what was flushed, less a header for each flush
  private long dataExpected;
  private boolean isLeft; // by an error, as soon as all data are sent
  private Thread sender; // of the last data

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
    target.write(bytes); // at once: the library writes byte by byte
    target.flush();
    dataSent += bytes.length - HEADER;
    sender = Thread.currentThread();
    notifyAll();
    if (isLeft && dataSent >= dataExpected) {
      isLeft = false;
      throw allSent;
    }
  }

  /** Counts from here; until the data are sent, nothing else may be written. */
  synchronized void expect(int dataBytes) {
    dataSent = 0;
    dataExpected = dataBytes;
  }

  /** Runs the library's sending loop until it has sent the data, or would wait. */
  void run(Runnable loop) {
    leave(true);
    try {
      loop.run();
    } catch (AllSent e) {
      return; // nothing follows the flush: the message went out as a whole
    } finally {
      leave(false);
    }
  }

  private synchronized void leave(boolean whenSent) {
    isLeft = whenSent;
  }

  /** Waits until the data are sent, and returns the library's thread that did so. */
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
   * @throws IOException if not all data are sent
   */
  synchronized void requireAll() throws IOException {
    if (dataSent < dataExpected) {
      throw new IOException("the IOIO library does not send what was written to a UART");
    }
  }
}
