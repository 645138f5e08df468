package org.u2sa.report.run;

/**
 * Limits of a report's data, so that a malicious recording cannot exhaust memory. Far above the
 * content of a real run.
 */
final class ReportLimits {
  static final int MAX_GOALS = 20_000;
  static final int MAX_OBJECTS = 2_000;
  static final int MAX_SOURCES = 300; // services or channels with a curve
  static final int MAX_CORNERS = 500; // of an outline
  static final int MAX_EVENTS = 2_000;
  static final int MAX_CHANGES = 10_000; // of services' conditions
  static final int MAX_SUBJECTS = 10_000; // whose last event is remembered

  private static final int MAX_TEXT = 500; // characters of a name, a cause or an error

  private ReportLimits() {}

  /** The text, cut with an ellipsis if it is too long. */
  static String clipped(String text) {
    return text.length() <= MAX_TEXT
        ? text
        : text.substring(0, MAX_TEXT) + "… (" + text.length() + " characters)";
  }
}
