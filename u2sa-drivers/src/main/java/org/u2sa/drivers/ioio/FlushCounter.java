package org.u2sa.drivers.ioio;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/**
 * Tells in lockstep when the IOIO library has sent what was written to a UART. Its own thread does
 * that, at a moment of its own; a run that is to repeat waits for it.
 */
final class FlushCounter extends OutputStream {
  private static final int HEADER = 2; // of a message of UART data: type; number and length
  private static final long AT_MOST_MS = 5_000;

  private final OutputStream target;
  private final ByteArrayOutputStream waiting =
      new ByteArrayOutputStream(); // until the library flushes; guarded by this, as all below
  private long dataSent; // bytes of what was flushed, less a header for each flush
  private long dataExpected;
  private boolean counting;

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
    if (counting) {
      dataSent += bytes.length - HEADER;
    }
    notifyAll();
  }

  /** Counts from here; until the data are sent, nothing else may be written. */
  synchronized void expect(int dataBytes) {
    counting = true;
    dataSent = 0;
    dataExpected = dataBytes;
  }

  /**
   * Waits until the data are sent, if any are expected; an interrupt ends that, and leaves the
   * thread's flag set.
   */
  synchronized void await() throws IOException {
    try {
      while (dataSent < dataExpected) {
        long before = dataSent;
        wait(AT_MOST_MS);
        if (dataSent == before) {
          throw new IOException("the IOIO library does not send what was written to a UART");
        }
      }
      counting = false;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
