package org.u2sa.drivers.range;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/** Splits what a SCIP sensor sends into answers: lines up to an empty one. */
final class ScipReader {
  private static final int LONGEST_LINE = 256;
  private static final int MOST_LINES = 400; // a scan of 8192 steps
  private static final int MOST_ANSWERS = 16;

  private final StringBuilder line = new StringBuilder();
  private List<String> lines = new ArrayList<>();
  private final Deque<List<String>> answers = new ArrayDeque<>();
  private boolean skips; // up to the next empty line
  private long malformed;

  /** Forgets all but the count: the stream was cut. */
  void beginAnew() {
    line.setLength(0);
    lines = new ArrayList<>();
    answers.clear();
    skips = false;
  }

  /** Takes the next bytes of the stream. */
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
      if (lines.size() > MOST_LINES) {
        skip();
      }
      return;
    }
    if (!skips && !lines.isEmpty()) {
      answers.add(lines);
      if (answers.size() > MOST_ANSWERS) {
        answers.remove(); // nobody takes them: the newest count
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

  /** The oldest answer not yet taken: echo, status, data. */
  Optional<List<String>> take() {
    return Optional.ofNullable(answers.poll());
  }

  /** How often lines or answers were endless. */
  long malformed() {
    return malformed;
  }
}
