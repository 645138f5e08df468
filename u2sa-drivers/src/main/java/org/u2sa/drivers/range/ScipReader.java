package org.u2sa.drivers.range;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/** Splits a SCIP sensor's output into replies, each ended by an empty line. */
final class ScipReader {
  private static final int LONGEST_LINE = 256;
  private static final int MAX_LINES = 400; // enough for a scan of 8192 steps
  private static final int MAX_ANSWERS = 16;

  private final StringBuilder line = new StringBuilder();
  private List<String> lines = new ArrayList<>();
  private final Deque<List<String>> answers = new ArrayDeque<>();
  private boolean skips; // discarding up to the next empty line
  private long malformed;

  /** Resets all but the counter after an interruption. */
  void reset() {
    line.setLength(0);
    lines = new ArrayList<>();
    answers.clear();
    skips = false;
  }

  /** Consumes bytes. */
  void accept(byte[] bytes, int length) {
    for (int i = 0; i < length; i++) {
      char each = (char) (bytes[i] & 0xFF);
      if (each == '\n') {
        endLine();
      } else if (each != '\r') {
        line.append(each);
        if (line.length() > LONGEST_LINE) {
          skip();
        }
      }
    }
  }

  private void endLine() {
    if (line.length() > 0) {
      lines.add(line.toString());
      line.setLength(0);
      if (lines.size() > MAX_LINES) {
        skip();
      }
      return;
    }
    if (!skips && !lines.isEmpty()) {
      answers.add(lines);
      if (answers.size() > MAX_ANSWERS) {
        answers.remove(); // unread: keep only the newest
      }
    }
    skips = false;
    lines = new ArrayList<>();
  }

  private void skip() {
    malformed += skips ? 0 : 1;
    skips = true;
    line.setLength(0);
    lines = new ArrayList<>();
  }

  /** Oldest unread reply: echo, status, data. */
  Optional<List<String>> take() {
    return Optional.ofNullable(answers.poll());
  }

  /** Number of overlong lines and replies. */
  long malformed() {
    return malformed;
  }
}
