package org.u2sa.report.score;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * What the simulator says of the end of a run.
 *
 * @param contacts how often the vehicle hit something, or the ground harder than its gear bears
 * @param stalled whether a wing stalled in the air
 * @param violations other rules broken, a sentence each
 * @param counts what else the rules count, by their names in {@code summary.json}, in order
 * @param figures what else they measure, alike
 */
public record RunOutcome(
    int contacts,
    boolean stalled,
    List<String> violations,
    Map<String, Integer> counts,
    Map<String, Double> figures) {

  public RunOutcome {
    violations = List.copyOf(violations);
    counts = Collections.unmodifiableMap(new LinkedHashMap<>(counts));
    figures = Collections.unmodifiableMap(new LinkedHashMap<>(figures));
  }

  /** Without further figures. */
  public RunOutcome(int contacts, boolean stalled, List<String> violations) {
    this(contacts, stalled, violations, Map.of(), Map.of());
  }

  /** Nothing to complain of. */
  public static RunOutcome clean() {
    return new RunOutcome(0, false, List.of());
  }

  /** The same with further broken rules. */
  RunOutcome breaking(List<String> more) {
    List<String> all = new ArrayList<>(violations);
    all.addAll(more);
    return new RunOutcome(contacts, stalled, all, counts, figures);
  }

  /** Whether nothing was hit, no wing stalled and no rule was broken. */
  public boolean isClean() {
    return contacts == 0 && !stalled && violations.isEmpty();
  }

  /** Whether it hit anything. */
  public boolean crashed() {
    return contacts > 0;
  }
}
