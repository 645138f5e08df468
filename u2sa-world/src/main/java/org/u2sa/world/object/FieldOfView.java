package org.u2sa.world.object;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.messages.frame.Point;

/**
 * What a sensor sees: a sector in the plane of the vehicle.
 *
 * @param halfWidth to each side of its middle [rad]
 * @param reach [m]
 * @param middle from straight ahead, to the left positive [rad]
 */
record FieldOfView(double halfWidth, double reach, double middle) {
  private static final Pattern ENTRY =
      Pattern.compile(
          "\\s*([^:;]+?)\\s*:\\s*([0-9.]+)\\s*deg\\s*,\\s*([0-9.]+)\\s*m\\s*(?:,\\s*(-?[0-9.]+)\\s*deg\\s*)?");

  /**
   * Fields of view by the names of sensors, from a text such as {@code Camera: 60 deg, 8 m; Radar:
   * 120 deg, 150 m, 90 deg}: width, reach, and the direction of its middle, to the left positive.
   *
   * @throws IllegalArgumentException naming the entry that is wrong
   */
  static Map<String, FieldOfView> parse(String text) {
    Map<String, FieldOfView> fields = new LinkedHashMap<>();
    for (String entry : text.split(";")) {
      if (entry.trim().isEmpty()) {
        continue;
      }
      Matcher matcher = ENTRY.matcher(entry);
      if (!matcher.matches()) {
        throw new IllegalArgumentException(
            "FIELDS OF VIEW: \""
                + entry.trim()
                + "\": expected a sensor's name, width and reach, such as Camera: 60 deg, 8 m");
      }
      double middle = matcher.group(4) == null ? 0.0 : number(entry, matcher.group(4));
      fields.put(
          matcher.group(1),
          new FieldOfView(
              Math.toRadians(number(entry, matcher.group(2))) / 2.0,
              number(entry, matcher.group(3)),
              Math.toRadians(middle)));
    }
    return fields;
  }

  private static double number(String entry, String text) {
    try {
      return Double.parseDouble(text);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException(
          "FIELDS OF VIEW: \"" + entry.trim() + "\": " + text + " is not a number", e);
    }
  }

  /**
   * Whether it sees a place.
   *
   * @param frd from the vehicle, forward, right, down [m]
   */
  boolean sees(Point frd) {
    double off = Math.IEEEremainder(Math.atan2(-frd.y(), frd.x()) - middle, 2.0 * Math.PI);
    return Math.hypot(frd.x(), frd.y()) <= reach && Math.abs(off) <= halfWidth;
  }
}
