package org.u2sa.control.cascade;

import java.util.LinkedHashMap;
import java.util.Map;

/** Parser of actuator costs in a configuration: "NAME 4, OTHER NAME 2". */
final class Costs {
  private static final double DEAREST = 1000.0;

  private Costs() {}

  /**
   * Costs by name.
   *
   * @throws IllegalArgumentException if an entry is invalid, naming it
   */
  static Map<String, Double> parse(String text) {
    Map<String, Double> costs = new LinkedHashMap<>();
    for (String part : text.split(",")) {
      String entry = part.trim();
      if (!entry.isEmpty()) {
        int space = entry.lastIndexOf(' ');
        double cost = space < 0 ? Double.NaN : number(entry.substring(space + 1));
        if (!(cost > 0.0 && cost < DEAREST)) {
          throw new IllegalArgumentException(
              "COSTS: \"" + entry + "\": expected a name and a number above 0, below 1000");
        }
        costs.put(entry.substring(0, space).trim(), cost);
      }
    }
    return costs;
  }

  private static double number(String text) {
    try {
      return Double.parseDouble(text);
    } catch (NumberFormatException e) {
      return Double.NaN; // rejected by the caller, which reports the whole entry
    }
  }
}
