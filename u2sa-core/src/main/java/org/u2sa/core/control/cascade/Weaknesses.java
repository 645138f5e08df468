package org.u2sa.core.control.cascade;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.u2sa.core.control.allocation.Effector;

/**
 * Actuators that were found not to respond, or weakly, until they are tried again. For one thread.
 */
final class Weaknesses {
  private static final double FULL_PERCENT = 100.0;

  private final Map<String, Double> left = new TreeMap<>(); // share, 0…1
  private final Map<String, Long> untilMicros = new TreeMap<>();

  /** Takes note of what was found, beside what was found of the same actuator before. */
  void add(ResponseWatch.Finding found, long retryMicros) {
    left.merge(found.actuator(), found.left(), (before, more) -> before * more);
    untilMicros.put(found.actuator(), retryMicros);
  }

  /** Forgets those whose time has come; returns whether there are any. */
  boolean forget(long nowMicros) {
    boolean forgets = untilMicros.values().removeIf(until -> until <= nowMicros);
    left.keySet().retainAll(untilMicros.keySet());
    return forgets;
  }

  /** The effectors as they respond, without those that do not. */
  List<Effector> of(List<Effector> announced) {
    List<Effector> responding = new ArrayList<>();
    for (Effector each : announced) {
      double share = left.getOrDefault(each.name(), 1.0);
      if (share == 1.0) {
        responding.add(each);
      } else if (share > 0.0) {
        responding.add(each.weakened(share));
      }
    }
    return responding;
  }

  /** Those that do not respond, by name. */
  List<String> lost() {
    List<String> lost = new ArrayList<>(left.keySet());
    lost.removeIf(name -> left.get(name) > 0.0);
    return lost;
  }

  /** Those that respond weakly, for people: "weak: THRUSTER 3 (60 %); "; empty if none does. */
  String words() {
    List<String> weak = new ArrayList<>();
    left.forEach(
        (name, share) -> {
          if (share > 0.0) {
            weak.add(String.format(Locale.ROOT, "%s (%.0f %%)", name, FULL_PERCENT * share));
          }
        });
    return weak.isEmpty() ? "" : "weak: " + String.join(", ", weak) + "; ";
  }
}
