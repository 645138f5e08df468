package org.u2sa.world.object;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.u2sa.messages.frame.Point;

/**
 * A sensor's field of view: a sector in the vehicle's plane.
 *
 * @param halfWidth half of the opening angle [rad]
 * @param reach maximum range [m]
 * @param middle direction of the centre line from straight ahead, positive to the left [rad]
 */
record FieldOfView(double halfWidth, double reach, double middle) {
  private static final Pattern ENTRY =
      Pattern.compile(
          "\\s*([^:;]+?)\\s*:\\s*([0-9.]+)\\s*deg\\s*,\\s*([0-9.]+)\\s*m\\s*(?:,\\s*(-?[0-9.]+)\\s*deg\\s*)?");

  /**
   * Parses fields of view by sensor name, such as {@code Camera: 60 deg, 8 m; Radar: 120 deg, 150
   * m, 90 deg}: width, range, and direction of the centre line, positive to the left.
   *
   * @throws IllegalArgumentException naming the invalid entry
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
   * Whether a point is in the field of view.
   *
   * @param frd position relative to the vehicle, forward, right, down [m]
   */
  boolean sees(Point frd) {
    double off = Math.IEEEremainder(Math.atan2(-frd.y(), frd.x()) - middle, 2.0 * Math.PI);
    return Math.hypot(frd.x(), frd.y()) <= reach && Math.abs(off) <= halfWidth;
  }
}
