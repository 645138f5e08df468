package org.u2sa.device.payload;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.u2sa.interfaces.BadInputException;

/** Named positions of a switched payload and their levels [%], in the order of their text. */
final class SwitchPositions {
  private static final double FULL_PERCENT = 100.0;
  private static final double SAME_PERCENT = 1.0e-6;

  private final Map<String, Double> levels = new LinkedHashMap<>();

  /**
   * @param text names and levels, such as {@code OPEN 0, CLOSED 100}
   * @throws BadInputException unless it has two positions or more with different levels in 0…100
   */
  SwitchPositions(String text) {
    for (String each : text.split(",")) {
      String position = each.trim();
      int space = position.lastIndexOf(' ');
      double level = space < 1 ? Double.NaN : level(position.substring(space + 1));
      boolean isNew = levels.values().stream().noneMatch(other -> same(other, level));
      boolean isGood = level >= 0.0 && level <= FULL_PERCENT && isNew;
      if (!isGood || levels.put(position.substring(0, space).trim(), level) != null) {
        throw wrong(text);
      }
    }
    if (levels.size() < 2) {
      throw wrong(text);
    }
  }

  private static boolean same(double one, double other) {
    return Math.abs(one - other) < SAME_PERCENT;
  }

  private static double level(String text) {
    try {
      return Double.parseDouble(text);
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  private static BadInputException wrong(String text) {
    return new BadInputException(
        ("POSITIONS: \""
                + text
                + "\": expected two or more names with different levels in 0…100 %,")
            + " such as \"OPEN 0, CLOSED 100\"");
  }

  /** The level nearest to a commanded percentage [%]. */
  double nearest(double percent) {
    return levels.values().stream()
        .min((a, b) -> Double.compare(Math.abs(a - percent), Math.abs(b - percent)))
        .orElseThrow();
  }

  /** Level of the first position [%]. */
  double first() {
    return levels.values().iterator().next();
  }

  /** Level of the last position [%]. */
  double last() {
    return levels.values().stream().reduce((one, next) -> next).orElseThrow();
  }

  /** Name of the position nearest to a level [%]. */
  String name(double percent) {
    double level = nearest(percent);
    return levels.entrySet().stream()
        .filter(each -> same(each.getValue(), level))
        .map(Map.Entry::getKey)
        .findFirst()
        .orElseThrow();
  }

  /** Positions in words: {@code OPEN at 0 %, CLOSED at 100 %}. */
  @Override
  public String toString() {
    return levels.entrySet().stream()
        .map(each -> String.format(Locale.ROOT, "%s at %.0f %%", each.getKey(), each.getValue()))
        .collect(Collectors.joining(", "));
  }
}
