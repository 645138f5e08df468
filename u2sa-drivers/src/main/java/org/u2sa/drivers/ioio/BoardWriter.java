package org.u2sa.drivers.ioio;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;

/**
 * Sends to a board on a daemon thread so that writers never block. Too large a backlog ends the
 * connection.
 */
final class BoardWriter extends OutputStream {
  private static final int MOST = 1 << 16;
  private static final int FINISH_ROUNDS = 3;
  private static final long FINISH_ROUND_MS = 100;

  private final OutputStream target;
  private final Thread thread = new Thread(this::send, "u2sa-ioio-writer");
  private final ByteArrayOutputStream waiting = new ByteArrayOutputStream(); // guarded by this
  private boolean flushed; // whether pending data may be sent; guarded by this
  private boolean closed; // accepts no more data; guarded by this
  private boolean done; // thread has finished; guarded by this
  private IOException failure; // null if none; guarded by this

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
      throw new IOException("the IOIO accepts no more bytes");
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
   * Accepts no more data; the thread ends once pending data is sent or the connection is closed.
   *
   * @param orderly whether to wait briefly for that
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
