package org.u2sa.report.export;

/** A cell of a table (RFC 4180). */
final class CsvCell {
  private CsvCell() {}

  /** Returns the text, in quotes if it needs them. */
  static String of(String text) {
    boolean needsQuotes = text.chars().anyMatch(c -> c == ',' || c == '"' || c < ' ');
    return needsQuotes ? '"' + text.replace("\"", "\"\"") + '"' : text;
  }
}
