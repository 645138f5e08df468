package org.u2sa.drivers.ioio;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/**
 * Sends to a board on a daemon thread, so that whoever writes never waits. What piles up because
 * the board takes nothing ends the connection.
 */
final class BoardWriter extends OutputStream {
  private static final int MOST = 1 << 16;
  private static final int FINISH_ROUNDS = 3;
  private static final long FINISH_ROUND_MS = 100;

  private final OutputStream target;
  private final Thread thread = new Thread(this::send, "u2sa-ioio-writer");
  private final ByteArrayOutputStream waiting = new ByteArrayOutputStream(); // guarded by this
  private boolean flushed; // whether what waits may go; guarded by this
  private boolean closed; // takes no more; guarded by this
  private boolean done; // the thread is at its end; guarded by this
  private IOException failure; // null while all goes well; guarded by this

  BoardWriter(OutputStream target) {
    this.target = target;
    thread.setDaemon(true);
    thread.start();
  }

  @Override
  public synchronized void write(int octet) throws IOException {
    check();
    waiting.write(octet);
  }

  @Override
  public synchronized void flush() throws IOException {
    check();
    flushed = true;
    notifyAll();
  }

  private void check() throws IOException {
    if (failure != null) {
      throw new IOException(failure);
    }
    if (closed) {
      throw new IOException("the connection to the IOIO has ended");
    }
    if (waiting.size() >= MOST) {
      throw new IOException("the IOIO takes no more bytes");
    }
  }

  private void send() {
    try {
      for (byte[] bytes = next(); bytes != null; bytes = next()) {
        target.write(bytes);
        target.flush();
      }
    } catch (IOException e) {
      fail(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      synchronized (this) {
        closed = true;
        done = true;
        notifyAll();
      }
    }
  }

  private synchronized byte[] next() throws InterruptedException {
    while (!closed && !(flushed && waiting.size() > 0)) {
      wait();
    }
    if (!flushed || waiting.size() == 0) {
      return null;
    }
    byte[] bytes = waiting.toByteArray();
    waiting.reset();
    flushed = false;
    return bytes;
  }

  private synchronized void fail(IOException e) {
    failure = e;
  }

  /**
   * Takes no more; the thread ends when it has sent what waits, or when the connection is closed
   * under it.
   *
   * @param orderly whether to wait for that, a moment at most
   */
  synchronized void finish(boolean orderly) {
    closed = true;
    notifyAll();
    try {
      for (int i = 0; orderly && !done && i < FINISH_ROUNDS; i++) {
        wait(FINISH_ROUND_MS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
