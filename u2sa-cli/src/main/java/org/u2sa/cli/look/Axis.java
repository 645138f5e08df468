package org.u2sa.cli.look;

import java.util.Locale;

/**
 * Range of an axis, with tick marks.
 *
 * @param from lower end
 * @param to upper end, above the lower
 */
record Axis(double from, double to) {
  private static final double MARGIN = 0.05;

  /** Creates an axis that covers the given range; a single value gets margins. */
  static Axis around(double lowest, double highest) {
    double span = highest - lowest;
    double least = Math.max(1e-9, 1e-6 * Math.max(Math.abs(lowest), Math.abs(highest)));
    double room =
        span < least
            ? Math.max(least, 0.5 * Math.max(1e-3, Math.abs(highest) * 1e-3))
            : span * MARGIN;
    return new Axis(lowest - room, highest + room);
  }

  /** Relative position of a value, from 0 at the lower end to 1 at the upper. */
  double share(double value) {
    return (value - from) / (to - from);
  }

  /** Formats a value with just enough digits to distinguish neighbouring marks. */
  String label(double value) {
    int digits = (int) Math.ceil(-Math.log10((to - from) / 100.0));
    return String.format(Locale.ROOT, "%." + Math.max(0, Math.min(9, digits)) + "f", value);
  }
}
