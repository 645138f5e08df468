package org.u2sa.flightgear.protocol;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;

/**
 * Splits the byte stream of one connection into lines. A line that is too long is reported once and
 * skipped to its end, so memory is bounded. Confined to one thread.
 */
public final class LineSplitter {
  /** Longest line accepted [bytes]; U2SA's own are below 500. */
  public static final int LONGEST = 2_048;

  private final byte[] line = new byte[LONGEST];
  private int length;
  private boolean skipping;

  /**
   * Consumes all remaining bytes of a buffer.
   *
   * @param lines receives each complete line without its end ("\n" or "\r\n"); non-ASCII bytes
   *     become characters that are invalid in numbers
   * @param tooLong receives the beginning of each line that is too long
   */
  public void feed(ByteBuffer bytes, Consumer<String> lines, Consumer<String> tooLong) {
    while (bytes.hasRemaining()) {
      byte next = bytes.get();
      if (next == '\n') {
        if (!skipping) {
          lines.accept(text(length > 0 && line[length - 1] == '\r' ? length - 1 : length));
        }
        length = 0;
        skipping = false;
      } else if (!skipping && length == LONGEST) {
        skipping = true;
        tooLong.accept(text(LONGEST));
      } else if (!skipping) {
        line[length++] = next;
      }
    }
  }

  /** Whether bytes wait for the end of their line. */
  public boolean isInsideLine() {
    return length > 0 || skipping;
  }

  private String text(int count) {
    return new String(line, 0, count, StandardCharsets.ISO_8859_1);
  }
}
