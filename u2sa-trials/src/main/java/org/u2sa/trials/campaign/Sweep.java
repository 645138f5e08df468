package org.u2sa.trials.campaign;

import java.util.List;
import org.u2sa.interfaces.BadInputException;

/**
 * A parameter and the values that a campaign sweeps.
 *
 * @param name name of a demo's option without dashes, such as {@code payload}, or a service's
 *     variable, such as {@code Control:SPEED GAIN}, or a value of a vehicle file, such as {@code
 *     vehicle:body/mass}
 * @param values the distinct values as written, at least one
 */
record Sweep(String name, List<String> values) {
  private static final String VEHICLE = "vehicle:";

  /**
   * Reads {@code NAME=VALUE,VALUE,…}.
   *
   * @throws BadInputException if the text has another form
   */
  static Sweep of(String text) {
    int equals = text.indexOf('=');
    String name = equals < 0 ? "" : text.substring(0, equals).strip();
    List<String> values =
        equals < 0 ? List.of() : List.of(text.substring(equals + 1).split(",", -1));
    boolean clear =
        !name.isEmpty()
            && !name.startsWith("-")
            && values.stream().noneMatch(String::isBlank)
            && values.stream().map(String::strip).distinct().count() == values.size();
    if (!clear) {
      throw new BadInputException(
          "--sweep \""
              + text
              + "\": expected NAME=VALUE,VALUE,… with different values, such as payload=0,5,10 or"
              + " \"PathPlanner:LOOK AHEAD=0.8,1.2\"");
    }
    return new Sweep(name, values.stream().map(String::strip).toList());
  }

  /** Command-line arguments for one of the values. */
  List<String> arguments(String value) {
    if (name.startsWith(VEHICLE)) {
      return List.of("--change", name.substring(VEHICLE.length()) + "=" + value);
    }
    return name.contains(":")
        ? List.of("--set", name + "=" + value)
        : List.of("--" + name + "=" + value);
  }
}
