package org.u2sa.scenarios.report;

import java.util.ArrayList;
import java.util.List;

/**
 * What the simulator says of the end of a run.
 *
 * @param contacts how often the vehicle hit something, or the ground harder than its gear bears
 * @param stalled whether a wing stalled in the air
 * @param violations other rules broken, a sentence each
 */
public record RunOutcome(int contacts, boolean stalled, List<String> violations) {

  public RunOutcome {
    violations = List.copyOf(violations);
  }

  /** Nothing to complain of. */
  public static RunOutcome clean() {
    return new RunOutcome(0, false, List.of());
  }

  /** The same with further broken rules. */
  RunOutcome breaking(List<String> more) {
    List<String> all = new ArrayList<>(violations);
    all.addAll(more);
    return new RunOutcome(contacts, stalled, all);
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
