package org.u2sa.drivers.link;

import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;

/**
 * Records a link's traffic for a {@link ReplayLink}. Text, one line per event: microseconds since
 * the start, then {@code <} with received bytes, {@code >} with sent bytes, {@code +} for
 * connected, {@code -} for lost; bytes in hexadecimal.
 */
final class RecordingLink implements ByteLink {
  /** First line of a recording. */
  static final String HEADER = "# u2sa link recording 1";

  private static final char[] HEX = "0123456789abcdef".toCharArray();

  private final ByteLink link;
  private final Path file;
  private final Clock clock;
  private final long beginMicros;
  private final StringBuilder line = new StringBuilder();
  private Writer out; // null after a failure or close
  private String failure = "";
  private int connections;
  private boolean connected;

  /**
   * Starts a recording.
   *
   * @param wanted numbered if it exists: what was recorded before a crash is not lost
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
    if (out == null) {
      return;
    }
    line.setLength(0);
    line.append(clock.micros() - beginMicros).append(' ').append(what);
    if (count > 0) {
      line.append(' ');
    }
    for (int i = 0; i < count; i++) {
      line.append(HEX[bytes[i] >> 4 & 0xF]).append(HEX[bytes[i] & 0xF]);
    }
    try {
      out.append(line).append('\n');
      out.flush(); // the bytes before a crash matter most
    } catch (IOException e) {
      fail(e);
    }
  }

  private void fail(IOException e) {
    failure = "recording " + file + " ended: " + e.getMessage();
    out = null; // the device matters more than its recording
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
    return own.isEmpty() || failure.isEmpty() ? own + failure : own + "; " + failure;
  }

  @Override
  public synchronized void close() {
    link.close();
    if (out != null) {
      try {
        out.close();
      } catch (IOException e) {
        fail(e);
      }
      out = null;
    }
  }
}
