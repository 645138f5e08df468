package org.u2sa.planning.payload;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.messages.contract.ActuatorAnnouncement;

/** Release mechanisms that report their positions, and how often those have changed. */
public final class PayloadReleases {
  private static final int MAX_KNOWN = 100; // further names are ignored

  private record Known(double percentage, int changes, boolean isAvailable) {}

  private final Map<String, Known> mechanisms = new TreeMap<>();

  public void see(ActuatorAnnouncement announced) {
    String name = announced.actuatorName();
    Known before = mechanisms.get(name);
    if (announced.percentage().isEmpty() || (before == null && mechanisms.size() >= MAX_KNOWN)) {
      return;
    }
    double now = announced.percentage().getAsDouble();
    boolean changes = before != null && before.percentage() != now;
    int count = before == null ? 0 : before.changes() + (changes ? 1 : 0);
    mechanisms.put(name, new Known(now, count, announced.available().orElse(100.0) > 0.0));
  }

  /** Why a payload cannot be released; empty if its mechanism is there. */
  public Optional<String> missing(String payload) {
    Known known = mechanisms.get(payload);
    if (known != null) {
      return known.isAvailable() ? Optional.empty() : Optional.of("\"" + payload + "\" is lost");
    }
    String there =
        mechanisms.isEmpty() ? "none is there" : "there: " + String.join(", ", mechanisms.keySet());
    return Optional.of("\"" + payload + "\" is not a mechanism that reports its release; " + there);
  }

  /** Number of changes of a mechanism's position seen so far. */
  public int changes(String payload) {
    Known known = mechanisms.get(payload);
    return known == null ? 0 : known.changes();
  }
}
