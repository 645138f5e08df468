package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Formats quantities for the causes of failsafes and the reasons for refusals. */
final class CauseText {
  private CauseText() {}

  static String seconds(double seconds) {
    return String.format(Locale.ROOT, "%.1f s", seconds);
  }

  static String metres(double metres) {
    return String.format(Locale.ROOT, "%.0f m", metres);
  }

  /** Parses a comma-separated list; empty text gives no names. */
  static List<String> names(String list) {
    return Stream.of(list.split(","))
        .map(String::trim)
        .filter(name -> !name.isEmpty())
        .collect(Collectors.toCollection(ArrayList::new));
  }
}
