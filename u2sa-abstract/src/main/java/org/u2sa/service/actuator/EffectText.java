package org.u2sa.service.actuator;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Point;

/**
 * Text form of an actuator's effect in configurations, in the vehicle's forward, right and down
 * axes:
 *
 * <ul>
 *   <li>{@code thrust 40 / 30 at 0.16 -0.11 0.0 towards 1 1 0}: 40 N at +100 % and 30 N at −100 %
 *       (equal if the second number is omitted), at that position [m], in that direction of any
 *       length;
 *   <li>{@code wrench 0 0 0 900 0 40}: X, Y, Z [N] and K, M, N [N m] at +100 %; six more numbers
 *       after a / give the effect at −100 %.
 * </ul>
 *
 * @param force at +100 % [N]
 * @param moment at +100 % [N m]
 * @param reverseForce at −100 % [N]
 * @param reverseMoment at −100 % [N m]
 */
record EffectText(
    Point force, Point moment, Optional<Point> reverseForce, Optional<Point> reverseMoment) {
  private static final String FORMS =
      "expected \"thrust N [/ N] at x y z towards x y z\" or \"wrench X Y Z K M N [/ X Y Z K M N]\"";

  /**
   * @throws IllegalArgumentException quoting the text and the expected form
   */
  static EffectText parse(String text) {
    List<String> words = new ArrayList<>(List.of(text.trim().split("[\\s,]+")));
    String form = words.remove(0);
    try {
      EffectText effect =
          switch (form) {
            case "thrust" -> thrust(words);
            case "wrench" -> wrench(words);
            default -> throw new IllegalArgumentException("unknown form \"" + form + "\"");
          };
      if (!words.isEmpty()) {
        throw new IllegalArgumentException(
            "unexpected \"" + String.join(" ", words) + "\" at the end");
      }
      return effect;
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          "effect \"" + text + "\": " + e.getMessage() + "; " + FORMS, e);
    }
  }

  private static EffectText thrust(List<String> words) {
    double forward = positive(words);
    double reverse = skip(words, "/") ? positive(words) : forward;
    require(words, "at");
    Point place = point(words);
    require(words, "towards");
    Point direction = point(words);
    return ofThrust(place, direction, forward, reverse);
  }

  /**
   * Effect of a thrust at a position, in a direction of any length.
   *
   * @throws IllegalArgumentException if the length is 0
   */
  static EffectText ofThrust(Point place, Point direction, double forward, double reverse) {
    double length = direction.distance();
    if (!(length > 0.0)) {
      throw new IllegalArgumentException("the direction has no length");
    }
    Point unit = direction.times(1.0 / length);
    Point force = unit.times(forward);
    Point astern = unit.times(-reverse);
    return reverse == forward
        ? new EffectText(force, place.cross(force), Optional.empty(), Optional.empty())
        : new EffectText(
            force, place.cross(force), Optional.of(astern), Optional.of(place.cross(astern)));
  }

  private static EffectText wrench(List<String> words) {
    Point force = point(words);
    Point moment = point(words);
    return skip(words, "/")
        ? new EffectText(force, moment, Optional.of(point(words)), Optional.of(point(words)))
        : new EffectText(force, moment, Optional.empty(), Optional.empty());
  }

  private static boolean skip(List<String> words, String word) {
    boolean found = !words.isEmpty() && words.get(0).equals(word);
    if (found) {
      words.remove(0);
    }
    return found;
  }

  private static void require(List<String> words, String word) {
    if (!skip(words, word)) {
      throw new IllegalArgumentException("\"" + word + "\" is missing");
    }
  }

  private static double positive(List<String> words) {
    double value = number(words);
    if (!(value > 0.0)) {
      throw new IllegalArgumentException(value + " N is not above 0");
    }
    return value;
  }

  private static double number(List<String> words) {
    if (words.isEmpty()) {
      throw new IllegalArgumentException("a number is missing");
    }
    String word = words.remove(0);
    double value;
    try {
      value = Double.parseDouble(word);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("\"" + word + "\" is not a number", e);
    }
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(word + " is not finite");
    }
    return value;
  }

  private static Point point(List<String> words) {
    double x = number(words);
    double y = number(words);
    return Point.of(x, y, number(words));
  }

  ActuatorAnnouncement addTo(ActuatorAnnouncement announcement) {
    announcement.force(force).moment(moment);
    reverseForce.ifPresent(announcement::reverseForce);
    reverseMoment.ifPresent(announcement::reverseMoment);
    return announcement;
  }
}
