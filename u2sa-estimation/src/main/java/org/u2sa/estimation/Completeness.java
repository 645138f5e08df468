package org.u2sa.estimation;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.service.U2SAService;

/**
 * Reports in a service's log and health report when published states have lacked needed values for
 * too long, and when they are complete again.
 */
final class Completeness {
  private final U2SAService service;
  private final List<StateField> needed;
  private final long withinMicros;
  private final Map<StateField, Long> seenMicros = new EnumMap<>(StateField.class);
  private String said = "";

  /**
   * @param withinMicros time for which a value may be absent [µs]
   */
  Completeness(U2SAService service, List<StateField> needed, long withinMicros) {
    this.service = service;
    this.needed = needed;
    this.withinMicros = withinMicros;
  }

  /**
   * Parses a comma-separated list of field names.
   *
   * @throws IllegalArgumentException if a name is unknown
   */
  static List<StateField> fields(String names) {
    List<StateField> fields = new ArrayList<>();
    for (String each : names.split(",")) {
      if (!each.trim().isEmpty()) {
        fields.add(field(each.trim()));
      }
    }
    return fields;
  }

  private static StateField field(String name) {
    for (StateField field : StateField.values()) {
      if (field.fieldName().equals(name)) {
        return field;
      }
    }
    throw new IllegalArgumentException(
        "\"" + name + "\": expected numbers of a state, such as x, y, psi");
  }

  /** Checks a published state, computed from these sensors' measurements. */
  void look(StateInformation state, Collection<StateInformation> sensors) {
    long now = state.timestamp().orElseThrow();
    List<StateField> missing = new ArrayList<>();
    for (StateField field : needed) {
      seenMicros.putIfAbsent(field, now); // the grace period starts at the first state
      if (state.number(field).isPresent()) {
        seenMicros.put(field, now);
      } else if (now - seenMicros.get(field) > withinMicros) {
        missing.add(field);
      }
    }
    say(missing.isEmpty() ? "" : words(missing), sensors);
  }

  private void say(String what, Collection<StateInformation> sensors) {
    if (what.equals(said)) {
      return;
    }
    said = what;
    if (what.isEmpty()) {
      service.log("state complete again");
      return;
    }
    Set<String> heard = new TreeSet<>();
    sensors.forEach(sensor -> heard.add(sensor.sensorName()));
    service.trouble(what + " on sensed-state (received: " + String.join(", ", heard) + ")");
  }

  private static String words(List<StateField> missing) {
    List<String> names = new ArrayList<>();
    Set<String> sources = new LinkedHashSet<>();
    for (StateField field : missing) {
      names.add(field.fieldName());
      sources.add("no source of " + quantity(field));
    }
    return "state lacks " + String.join(", ", names) + ": " + String.join(", ", sources);
  }

  private static String quantity(StateField field) {
    switch (field) {
      case X:
      case Y:
        return "position";
      case Z:
        return "altitude";
      case PSI:
        return "heading";
      case PHI:
      case THETA:
        return "attitude";
      default:
        return field.fieldName();
    }
  }
}
