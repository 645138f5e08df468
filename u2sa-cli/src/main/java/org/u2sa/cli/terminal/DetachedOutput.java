package org.u2sa.cli.terminal;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.Charset;
import java.util.ArrayDeque;
import java.util.Deque;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;

/**
 * Non-blocking output while detached: a daemon thread writes the queued text. Otherwise writes pass
 * through.
 */
final class DetachedOutput extends OutputStream {
  static final int MAX_WAITING_BYTES = 256 * 1024;
  private static final long MICROS_PER_MS = 1_000L;

  private final Clock clock = new SystemClock();
  private final OutputStream target;
  private final long givesUpAfterMs; // without progress
  private final Deque<byte[]> waiting = new ArrayDeque<>(); // also the lock of the fields below
  private int waitingBytes;
  private int detached; // nesting depth
  private boolean queues; // until everything waiting is written
  private boolean writing;
  private boolean failed; // e.g. because of a closed pipe
  private long dropped; // writes, usually lines
  private long written; // writes from the queue, to detect progress
  private Thread writer;

  /** {@link #drain} gives up after this long without progress [ms]. */
  DetachedOutput(OutputStream target, long givesUpAfterMs) {
    this.target = target;
    this.givesUpAfterMs = givesUpAfterMs;
  }

  /** Makes output non-blocking from now on. */
  void detach() {
    synchronized (waiting) {
      detached++;
      queues = true;
      if (writer == null) {
        writer = new Thread(this::writeAll, "u2sa-console");
        writer.setDaemon(true);
        writer.start();
      }
    }
  }

  /** Undoes {@link #detach}, after a bounded wait for pending output. */
  void attach() {
    drain();
    synchronized (waiting) {
      detached--;
      reattach();
    }
  }

  /** Waits until the queue is empty, or until it has not been drained for a while. */
  void drain() {
    boolean interrupted = false;
    synchronized (waiting) {
      long before = written;
      long left = givesUpAfterMs;
      long beganMicros = clock.micros();
      while (!isIdle() && left > 0) {
        try {
          waiting.wait(left);
        } catch (InterruptedException e) {
          interrupted = true;
        }
        if (before != written) {
          before = written;
          beganMicros = clock.micros();
        }
        left = givesUpAfterMs - (clock.micros() - beganMicros) / MICROS_PER_MS;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  private boolean isIdle() {
    return waiting.isEmpty() && !writing;
  }

  private void reattach() {
    if (detached == 0 && isIdle()) {
      queues = false;
    }
  }

  @Override
  public void write(int oneByte) throws IOException {
    write(new byte[] {(byte) oneByte}, 0, 1);
  }

  @Override
  public void write(byte[] bytes, int offset, int length) throws IOException {
    synchronized (waiting) {
      if (queues) {
        byte[] copy = new byte[length];
        System.arraycopy(bytes, offset, copy, 0, length);
        add(copy);
        return;
      }
    }
    target.write(bytes, offset, length);
  }

  private void add(byte[] bytes) {
    if (failed) {
      return;
    }
    if (waitingBytes + bytes.length > MAX_WAITING_BYTES) {
      dropped++;
      return;
    }
    if (dropped > 0) {
      put(gap());
    }
    put(bytes);
  }

  private void put(byte[] bytes) {
    waiting.add(bytes);
    waitingBytes += bytes.length;
    waiting.notifyAll();
  }

  private byte[] gap() {
    String text = "u2sa: lines not printed because the output was blocked: " + dropped + "\n";
    dropped = 0;
    return text.getBytes(Charset.defaultCharset());
  }

  private void writeAll() {
    while (true) {
      byte[] next = take();
      try {
        target.write(next);
        target.flush();
        done(false);
      } catch (IOException e) { // nowhere left to report it
        done(true);
      }
    }
  }

  private byte[] take() {
    synchronized (waiting) {
      while (waiting.isEmpty()) {
        try {
          waiting.wait();
        } catch (InterruptedException e) {
          continue; // ends only with the process
        }
      }
      writing = true;
      byte[] next = waiting.remove();
      waitingBytes -= next.length;
      return next;
    }
  }

  private void done(boolean hasFailed) {
    synchronized (waiting) {
      writing = false;
      written++;
      if (hasFailed) {
        failed = true;
        waiting.clear();
        waitingBytes = 0;
      } else if (waiting.isEmpty() && dropped > 0) {
        put(gap());
      }
      reattach();
      waiting.notifyAll();
    }
  }
}
