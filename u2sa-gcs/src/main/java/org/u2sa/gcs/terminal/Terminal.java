package org.u2sa.gcs.terminal;

import java.io.PrintWriter;
import java.util.Map;
import org.u2sa.interfaces.OneLine;

/**
 * What is known of the terminal that text goes to.
 *
 * @param out where to print; flushed by each line
 * @param redraws whether the cursor can go back, so that a live status can redraw in place; false
 *     for pipes, files and dumb terminals
 * @param colours whether colours and bold may be used
 * @param columns width in characters, 20 or more
 */
public record Terminal(PrintWriter out, boolean redraws, boolean colours, int columns) {

  private static final int DEFAULT_COLUMNS = 80;
  private static final int LEAST_COLUMNS = 20;

  /**
   * @throws IllegalArgumentException if narrower than 20 columns
   */
  public Terminal {
    if (columns < LEAST_COLUMNS) {
      throw new IllegalArgumentException(
          "columns: " + columns + ", expected " + LEAST_COLUMNS + " or more");
    }
  }

  /**
   * The terminal of this process.
   *
   * @param out where to print
   * @param environment variables of the process: {@code NO_COLOR} (any value, no-color.org) refuses
   *     colours, {@code TERM=dumb} redrawing as well, {@code COLUMNS} is the width (80 if unset or
   *     not a number)
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
    return Math.max(LEAST_COLUMNS, Integer.parseInt(text));
  }

  /** {@code text} in bold, where the terminal can. */
  public String bold(String text) {
    return sgr("1", text);
  }

  /** {@code text} in the colour of good news, where the terminal can. */
  public String good(String text) {
    return sgr("32", text);
  }

  /** {@code text} in the colour of bad news, where the terminal can. */
  public String bad(String text) {
    return sgr("31", text);
  }

  private String sgr(String code, String text) {
    return colours ? "\u001b[" + code + "m" + text + "\u001b[0m" : text;
  }

  /**
   * {@code text} on one line, without colours or other commands to the terminal, and cut to its
   * width less one column, so that it never wraps.
   */
  public String fitted(String text) {
    int most = columns - 1;
    String line = OneLine.of(text);
    return line.length() <= most ? line : line.substring(0, most);
  }
}
