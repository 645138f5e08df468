package org.u2sa.core.safety;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Formats quantities for the causes of failsafes and the reasons of refusals. */
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
    List<String> names = new ArrayList<>();
    for (String name : list.split(",")) {
      if (!name.trim().isEmpty()) {
        names.add(name.trim());
      }
    }
    return names;
  }
}
