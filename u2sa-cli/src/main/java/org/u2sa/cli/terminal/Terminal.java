package org.u2sa.cli.terminal;

import java.io.PrintWriter;
import java.util.Map;
import org.u2sa.interfaces.OneLine;

/**
 * Capabilities of the output terminal.
 *
 * @param out output stream, flushed after each line
 * @param redraws whether the cursor can move back, so that a live status can be redrawn in place;
 *     false for pipes, files and dumb terminals
 * @param colours whether colours and bold may be used
 * @param columns width in characters, at least 20
 */
public record Terminal(PrintWriter out, boolean redraws, boolean colours, int columns) {

  private static final int DEFAULT_COLUMNS = 80;
  private static final int MIN_COLUMNS = 20;

  /**
   * @throws IllegalArgumentException if narrower than 20 columns
   */
  public Terminal {
    if (columns < MIN_COLUMNS) {
      throw new IllegalArgumentException(
          "columns: " + columns + ", expected " + MIN_COLUMNS + " or more");
    }
  }

  /**
   * Detects the terminal of this process.
   *
   * @param out output stream
   * @param environment environment variables: {@code NO_COLOR} (any value, no-color.org) disables
   *     colours, {@code TERM=dumb} also redrawing, {@code COLUMNS} is the width (80 if unset or not
   *     a number)
   */
  public static Terminal detect(PrintWriter out, Map<String, String> environment) {
    return of(out, System.console() != null, environment);
  }

  static Terminal of(PrintWriter out, boolean interactive, Map<String, String> environment) {
    boolean redraws =
        interactive && environment.containsKey("TERM") && !"dumb".equals(environment.get("TERM"));
    boolean colours = redraws && environment.getOrDefault("NO_COLOR", "").isEmpty();
    return new Terminal(out, redraws, colours, columns(environment.get("COLUMNS")));
  }

  private static int columns(String text) {
    if (text == null || !text.matches("[0-9]{1,5}")) {
      return DEFAULT_COLUMNS;
    }
    return Math.max(MIN_COLUMNS, Integer.parseInt(text));
  }

  /** Moves to the upper left corner and clears the terminal. */
  public void clear() {
    out.print("\u001b[H\u001b[J");
  }

  /** {@code text} in bold, if supported. */
  public String bold(String text) {
    return sgr("1", text);
  }

  /** {@code text} in the colour of success, if supported. */
  public String good(String text) {
    return sgr("32", text);
  }

  /** {@code text} in the colour of failure, if supported. */
  public String bad(String text) {
    return sgr("31", text);
  }

  private String sgr(String code, String text) {
    return colours ? "\u001b[" + code + "m" + text + "\u001b[0m" : text;
  }

  /**
   * {@code text} on one line, without colours or other control sequences, truncated to the width
   * minus one column so that it never wraps.
   */
  public String fitted(String text) {
    int most = columns - 1;
    String line = OneLine.of(text);
    return line.length() <= most ? line : line.substring(0, most);
  }
}
