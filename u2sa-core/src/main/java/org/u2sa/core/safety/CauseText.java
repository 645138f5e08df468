package org.u2sa.core.safety;

import java.math.BigDecimal;
import java.math.RoundingMode;
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

  /** A value below a limit, rounded down to hundredths: it never reads like the limit. */
  static String below(double value) {
    if (!Double.isFinite(value)) {
      return String.valueOf(value); // a safety step must not fail for its text
    }
    return String.valueOf(BigDecimal.valueOf(value).setScale(2, RoundingMode.FLOOR).doubleValue());
  }

  /** Parses a comma-separated list; empty text gives no names. */
  static List<String> names(String list) {
    return Stream.of(list.split(","))
        .map(String::trim)
        .filter(name -> !name.isEmpty())
        .collect(Collectors.toCollection(ArrayList::new));
  }
}
