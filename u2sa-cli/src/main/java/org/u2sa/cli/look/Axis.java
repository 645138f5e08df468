package org.u2sa.cli.look;

import java.util.Locale;

/**
 * The span of an axis.
 *
 * @param from its lower end
 * @param to its upper end, above the lower
 */
record Axis(double from, double to) {
  private static final double MARGIN = 0.05;

  /** One that shows all of these; a single value gets room around it. */
  static Axis around(double lowest, double highest) {
    double span = highest - lowest;
    double least = Math.max(1e-9, 1e-6 * Math.max(Math.abs(lowest), Math.abs(highest)));
    double room =
        span < least
            ? Math.max(least, 0.5 * Math.max(1e-3, Math.abs(highest) * 1e-3))
            : span * MARGIN;
    return new Axis(lowest - room, highest + room);
  }

  /** Where a value is, 0 at the lower end to 1 at the upper. */
  double share(double value) {
    return (value - from) / (to - from);
  }

  /** A value with as many digits as tell it from its neighbours on this axis. */
  String label(double value) {
    int digits = (int) Math.ceil(-Math.log10((to - from) / 100.0));
    return String.format(Locale.ROOT, "%." + Math.max(0, Math.min(9, digits)) + "f", value);
  }
}
