package org.u2sa.drivers.link;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.time.Clock;

/**
 * Replays a {@link RecordingLink}'s file in place of the device, at recorded speed on the run's
 * clock, including simulated time. Writes are accepted and discarded. After the last event the
 * device is lost.
 */
final class ReplayLink implements ByteLink {
  private record Event(long dueMicros, char what, byte[] bytes) {}

  private static final long MAX_BYTES = 64L << 20; // because it is held in memory

  private final Path file;
  private final Clock clock;
  private final double speed;
  private final Deque<Event> events = new ArrayDeque<>();
  private final ByteRing unread;
  private long beginMicros = Clock.NEVER; // time of the first access
  private boolean connected;
  private int connections;
  private int told;
  private boolean closed;

  /**
   * Opens a recording.
   *
   * @param speed playback speed relative to the recording
   * @throws BadInputException if it is missing or not a recording; names the line
   */
  ReplayLink(Path file, Clock clock, double speed) {
    this.file = file;
    this.clock = clock;
    this.speed = speed;
    List<String> lines;
    try {
      if (Files.exists(file) && (!Files.isRegularFile(file) || Files.size(file) > MAX_BYTES)) {
        throw new BadInputException(
            "recording " + file + ": expected a regular file of up to " + MAX_BYTES + " bytes");
      }
      lines = Files.readAllLines(file, StandardCharsets.US_ASCII);
    } catch (IOException e) {
      throw new BadInputException("recording " + file + " cannot be read: " + e, e);
    }
    if (lines.isEmpty() || !lines.get(0).equals(RecordingLink.HEADER)) {
      throw new BadInputException(
          "recording " + file + ", line 1: expected \"" + RecordingLink.HEADER + "\"");
    }
    int largest = 1;
    for (int i = 1; i < lines.size(); i++) {
      Event event = event(i + 1, lines.get(i));
      largest = Math.max(largest, event.bytes.length);
      events.add(event);
    }
    unread = new ByteRing(Math.max(largest, 1 << 16));
  }

  private Event event(int lineNumber, String line) {
    String[] parts = line.split(" ");
    try {
      if (parts.length >= 2 && parts[1].length() == 1 && "<>+-".contains(parts[1])) {
        byte[] bytes = parts.length > 2 ? bytes(parts[2]) : new byte[0];
        return new Event(Long.parseLong(parts[0]), parts[1].charAt(0), bytes);
      }
    } catch (NumberFormatException e) {
      throw noEvent(lineNumber, line, e);
    }
    throw noEvent(lineNumber, line, null);
  }

  private BadInputException noEvent(int lineNumber, String line, Throwable cause) {
    return new BadInputException(
        "recording "
            + file
            + ", line "
            + lineNumber
            + ": \""
            + line
            + "\": expected MICROSECONDS, one of < > + -, and bytes in hexadecimal",
        cause);
  }

  private static byte[] bytes(String hex) {
    if (hex.length() % 2 != 0) {
      throw new NumberFormatException("half a byte");
    }
    byte[] bytes = new byte[hex.length() / 2];
    for (int i = 0; i < bytes.length; i++) {
      bytes[i] = (byte) Integer.parseInt(hex.substring(2 * i, 2 * i + 2), 16);
    }
    return bytes;
  }

  /** Processes due events. */
  private void play() {
    long now = clock.micros();
    if (beginMicros == Clock.NEVER) {
      beginMicros = now;
    }
    while (!closed && !events.isEmpty() && events.peek().dueMicros <= speed * (now - beginMicros)) {
      Event event = events.remove();
      if (event.what == '<') {
        find(connected);
        unread.put(event.bytes, event.bytes.length);
      } else if (event.what == '+') {
        find(false);
      } else if (event.what == '-') {
        connected = false;
      }
    }
  }

  private void find(boolean already) {
    if (!already) {
      unread.clear();
      connected = true;
      connections++;
    }
  }

  @Override
  public synchronized int read(byte[] buffer) {
    play();
    if (told != connections) {
      told = connections;
      return 0;
    }
    return unread.take(buffer);
  }

  @Override
  public synchronized boolean write(byte[] bytes) {
    return isConnected();
  }

  @Override
  public synchronized boolean isConnected() {
    play();
    return connected && !isOver();
  }

  private boolean isOver() {
    return closed || events.isEmpty();
  }

  @Override
  public synchronized int connections() {
    play();
    told = connections;
    return connections;
  }

  @Override
  public synchronized String trouble() {
    if (isConnected()) {
      return "";
    }
    return closed ? "closed" : isOver() ? "the recording has ended" : "lost in the recording";
  }

  @Override
  public synchronized void close() {
    closed = true;
    unread.clear();
  }
}
