package org.u2sa.control.cascade;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.u2sa.control.allocation.Effector;

/** Actuators found to respond weakly or not at all, until they are retried. Not thread-safe. */
final class WeakActuators {
  private static final double FULL_PERCENT = 100.0;

  private final Map<String, Double> left = new TreeMap<>(); // share, 0…1
  private final Map<String, Long> untilMicros = new TreeMap<>();

  /** Adds a finding, combined with earlier findings on the same actuator. */
  void add(ResponseWatch.Finding found, long retryMicros) {
    left.merge(found.actuator(), found.left(), (before, more) -> before * more);
    untilMicros.put(found.actuator(), retryMicros);
  }

  /** Drops entries due for a retry; returns whether any were dropped. */
  boolean forget(long nowMicros) {
    boolean forgets = untilMicros.values().removeIf(until -> until <= nowMicros);
    left.keySet().retainAll(untilMicros.keySet());
    return forgets;
  }

  /** Effectors scaled by their response, without those that do not respond. */
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

  /** Actuators that do not respond, sorted by name. */
  List<String> lost() {
    List<String> lost = new ArrayList<>(left.keySet());
    lost.removeIf(name -> left.get(name) > 0.0);
    return lost;
  }

  /** Human-readable list of weak actuators: "weak: THRUSTER 3 (60 %); "; empty if none. */
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
