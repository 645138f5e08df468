package org.u2sa.fuzz;

import org.u2sa.interfaces.BadInputException;

/** What the command line prints of an input that cannot be used: one line. */
public final class OneLine {
  private OneLine() {}

  /**
   * @throws AssertionError if there is no message or if it is more than a line
   */
  public static void require(BadInputException e) {
    String message = e.getMessage();
    if (message == null || message.isEmpty() || message.chars().anyMatch(OneLine::endsLine)) {
      throw new AssertionError("expected one line, not \"" + message + "\"", e);
    }
  }

  private static boolean endsLine(int c) {
    return c == '\n' || c == '\r';
  }
}
