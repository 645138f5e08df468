package org.u2sa.drivers.link;

import java.io.IOException;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.interfaces.time.SystemClock;

/**
 * A link that reconnects automatically: one thread connects and reads, another writes, so the owner
 * never blocks. Back-off between attempts grows from 0.1 s to 0.8 s, so a returning device is found
 * within 2 s.
 */
final class ReconnectingLink implements ByteLink {
  private static final int FIRST_WAIT_MS = 100;
  private static final int LONGEST_WAIT_MS = 800;
  private static final int UNREAD_BYTES = 65_536;
  private static final int UNSENT_BYTES = 65_536;
  private static final int END_WITHIN_MS = 2_000;
  private static final int SENT_WITHIN_MS = 300;
  private static final int BUFFER_BYTES = 4_096;

  private final Port.Opener opener;
  private final long silenceMicros; // 0: silence does not count as loss
  private final Clock stopwatch = new SystemClock(); // hardware timeouts use real time
  private final LinkThread reader;
  private final LinkThread writer;

  // guarded by this
  private final ByteRing unread = new ByteRing(UNREAD_BYTES);
  private final Outbox unsent = new Outbox(UNSENT_BYTES);
  private Port port; // null if none is open
  private boolean connected;
  private int found;
  private int told; // number of connections the owner has seen
  private String trouble = "not found yet";
  private boolean closing; // accepts no more data but sends pending data, such as a motor stop
  private boolean closed;

  /**
   * Starts connecting.
   *
   * @param name used in thread names
   * @param silenceS time without a byte after which the device counts as lost [s]; 0: never
   */
  ReconnectingLink(String name, Port.Opener opener, double silenceS) {
    this.opener = opener;
    silenceMicros = Clock.micros(silenceS);
    reader = new LinkThread("link reads " + name, this::readAlways);
    writer = new LinkThread("link writes " + name, this::writeAlways);
  }

  private void readAlways() {
    int waitMs = FIRST_WAIT_MS;
    try {
      while (!isClosed()) {
        if (readUntilLost()) {
          waitMs = FIRST_WAIT_MS;
        }
        synchronized (this) {
          if (!closed) {
            wait(waitMs);
          }
        }
        waitMs = Math.min(LONGEST_WAIT_MS, 2 * waitMs);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // shutting down
    }
  }

  /** Returns whether the device was reached. */
  private boolean readUntilLost() {
    boolean wasThere = false;
    try (Port opened = opener.open()) {
      wasThere = true;
      if (use(opened)) {
        read(opened);
      }
    } catch (IOException e) {
      lost(e.getMessage());
    } catch (RuntimeException e) { // a library bug must not stop reconnection
      lost(e.toString());
    }
    synchronized (this) {
      port = null;
    }
    return wasThere;
  }

  private void read(Port opened) throws IOException {
    byte[] buffer = new byte[BUFFER_BYTES];
    long heardMicros = stopwatch.micros();
    while (!isClosed()) {
      int count = opened.read(buffer);
      if (count > 0) {
        heardMicros = stopwatch.micros();
        heard(buffer, count);
      } else if (silenceMicros > 0 && stopwatch.micros() - heardMicros > silenceMicros) {
        if (!opened.isFoundBySpeaking()) {
          throw new IOException("no data for " + Clock.seconds(silenceMicros) + " s");
        }
        lost("nothing arrives");
      }
    }
  }

  /** Returns false if the link was closed in the meantime. */
  private synchronized boolean use(Port opened) {
    if (closed) {
      return false;
    }
    port = opened;
    if (opened.isFoundBySpeaking()) {
      trouble = "nothing arrives";
    } else {
      found();
    }
    notifyAll();
    return true;
  }

  private void found() {
    unread.clear();
    unsent.clear();
    connected = true;
    found++;
    trouble = "";
  }

  private synchronized void heard(byte[] bytes, int count) {
    if (!connected) {
      found();
    }
    if (unread.put(bytes, count) > 0) {
      trouble = "data arrived faster than it was read: the oldest bytes were dropped";
    }
  }

  private synchronized void lost(String why) {
    connected = false;
    trouble = why;
  }

  private void writeAlways() {
    try {
      while (true) {
        byte[] next;
        Port to;
        synchronized (this) {
          while (!closing && (unsent.isEmpty() || port == null)) {
            wait();
          }
          if (unsent.isEmpty() || port == null) {
            return;
          }
          next = unsent.take();
          to = port;
        }
        send(to, next);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // shutting down
    }
  }

  private void send(Port to, byte[] bytes) {
    try {
      to.write(bytes);
    } catch (IOException | RuntimeException e) {
      lost(e.getMessage());
      close(to); // the reader detects this and reconnects
    }
  }

  private void close(Port open) {
    try {
      open.close();
    } catch (IOException e) {
      lost(e.getMessage());
    }
  }

  private synchronized boolean isClosed() {
    return closed;
  }

  @Override
  public synchronized int read(byte[] buffer) {
    if (told != found) {
      told = found; // the next bytes belong to a new connection; the owner must notice first
      return 0;
    }
    return unread.take(buffer);
  }

  @Override
  public synchronized boolean write(byte[] bytes) {
    if (closing || port == null || !port.isWritable() || !unsent.put(bytes)) {
      return false;
    }
    notifyAll();
    return true;
  }

  @Override
  public synchronized boolean isConnected() {
    return connected;
  }

  @Override
  public synchronized int connections() {
    told = found;
    return found;
  }

  @Override
  public synchronized String trouble() {
    return trouble;
  }

  @Override
  public void close() {
    Port open;
    synchronized (this) {
      closing = true;
      notifyAll();
    }
    boolean interrupted = Thread.interrupted();
    interrupted |= !writer.ended(SENT_WITHIN_MS);
    synchronized (this) {
      closed = true;
      connected = false;
      trouble = "closed";
      open = port;
      notifyAll();
    }
    if (open != null) {
      close(open);
    }
    interrupted |= !reader.ended(END_WITHIN_MS);
    interrupted |= !writer.ended(END_WITHIN_MS);
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
