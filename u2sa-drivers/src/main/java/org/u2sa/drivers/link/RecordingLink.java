package org.u2sa.drivers.link;

import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.disk.DiskThread;
import org.u2sa.interfaces.time.Clock;

/**
 * Records a link's traffic for a {@link ReplayLink}. Text, one line per event: microseconds since
 * the start, then {@code <} with received bytes, {@code >} with sent bytes, {@code +} for
 * connected, {@code -} for lost; bytes in hexadecimal.
 *
 * <p>In real time the {@link DiskThread} writes, because the device must not wait for a hanging
 * disk; a recording that would have gaps is ended.
 */
final class RecordingLink implements ByteLink {
  /** First line of a recording. */
  static final String HEADER = "# u2sa link recording 1";

  private static final int MAX_WAITING_CHARS = 1_000_000;
  private static final long CLOSES_WITHIN_MS = 1_000;
  private static final char[] HEX = "0123456789abcdef".toCharArray();

  private final ByteLink link;
  private final Path file;
  private final Clock clock;
  private final long beginMicros;
  private final Writer out; // belongs to the thread that writes
  private final StringBuilder waiting = new StringBuilder(); // also the lock of the next three
  private boolean jobPending;
  private boolean ended; // after a failure or close
  private String failure = "";
  private int connections;
  private boolean connected;

  /**
   * Starts a recording.
   *
   * @param wanted file name; a number is appended if it exists, so that recordings from before a
   *     crash are kept
   * @throws BadInputException if it cannot be written
   */
  RecordingLink(ByteLink link, Path wanted, Clock clock) {
    this.link = link;
    file = free(wanted);
    this.clock = clock;
    beginMicros = clock.micros();
    try {
      out = Files.newBufferedWriter(file, StandardCharsets.US_ASCII, StandardOpenOption.CREATE_NEW);
      out.write(HEADER + "\n");
      out.flush();
    } catch (IOException e) {
      throw new BadInputException("recording " + file + " cannot be written: " + e, e);
    }
  }

  /** The file, or the first of gps-2.rec, gps-3.rec and so on that does not exist. */
  private static Path free(Path wanted) {
    String name = wanted.getFileName().toString();
    int dot = name.lastIndexOf('.') > 0 ? name.lastIndexOf('.') : name.length();
    Path free = wanted;
    for (int number = 2; Files.exists(free, LinkOption.NOFOLLOW_LINKS); number++) {
      free = wanted.resolveSibling(name.substring(0, dot) + "-" + number + name.substring(dot));
    }
    return free;
  }

  @Override
  public synchronized int read(byte[] buffer) {
    int count = link.read(buffer);
    watch();
    if (count > 0) {
      record('<', buffer, count);
    }
    return count;
  }

  private void watch() {
    if (link.connections() != connections) {
      connections = link.connections();
      connected = true;
      record('+', new byte[0], 0);
    }
    if (connected && !link.isConnected()) {
      connected = false;
      record('-', new byte[0], 0);
    }
  }

  @Override
  public synchronized boolean write(byte[] bytes) {
    boolean sent = link.write(bytes);
    if (sent) {
      record('>', bytes, bytes.length);
    }
    return sent;
  }

  private void record(char what, byte[] bytes, int count) {
    synchronized (waiting) {
      if (ended) {
        return;
      }
      if (waiting.length() + 2 * count > MAX_WAITING_CHARS) {
        fail("the disk does not answer");
        return;
      }
      append(what, bytes, count);
      if (jobPending) {
        return;
      }
      jobPending = true;
    }
    if (clock.isSimulated()) {
      writeWaiting();
    } else {
      DiskThread.ofProcess().execute(this::writeWaiting);
    }
  }

  private void append(char what, byte[] bytes, int count) {
    waiting.append(clock.micros() - beginMicros).append(' ').append(what);
    if (count > 0) {
      waiting.append(' ');
    }
    for (int i = 0; i < count; i++) {
      waiting.append(HEX[bytes[i] >> 4 & 0xF]).append(HEX[bytes[i] & 0xF]);
    }
    waiting.append('\n');
  }

  private void writeWaiting() {
    String text;
    synchronized (waiting) {
      text = waiting.toString();
      waiting.setLength(0);
      jobPending = false;
    }
    try {
      out.write(text);
      out.flush(); // the bytes before a crash matter most
    } catch (IOException e) {
      fail(e.getMessage());
    }
  }

  /** Ends the recording, because the device matters more. */
  private void fail(String why) {
    synchronized (waiting) {
      failure = "recording " + file + " ended: " + why;
      ended = true;
    }
  }

  @Override
  public boolean isConnected() {
    return link.isConnected();
  }

  @Override
  public int connections() {
    return link.connections();
  }

  @Override
  public synchronized String trouble() {
    String own = link.trouble();
    synchronized (waiting) {
      return own.isEmpty() || failure.isEmpty() ? own + failure : own + "; " + failure;
    }
  }

  @Override
  public synchronized void close() {
    link.close();
    synchronized (waiting) {
      if (ended) {
        return;
      }
      ended = true;
    }
    try {
      if (clock.isSimulated()) {
        out.close();
      } else {
        DiskThread.ofProcess().call(this::closeFile, CLOSES_WITHIN_MS);
      }
    } catch (IOException e) {
      fail(e.getMessage());
    }
  }

  private Path closeFile() throws IOException {
    out.close();
    return file;
  }
}
