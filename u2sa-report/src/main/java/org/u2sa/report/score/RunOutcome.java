package org.u2sa.report.score;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Outcome of a run according to the simulator.
 *
 * @param contacts number of collisions, including ground contacts beyond the landing gear's limit
 * @param stalled whether a wing stalled in the air
 * @param violations other rule violations, one sentence each
 * @param counts other counts defined by the rules, by name in {@code summary.json}, in order
 * @param figures other metrics defined by the rules, likewise
 */
public record RunOutcome(
    int contacts,
    boolean stalled,
    List<String> violations,
    Map<String, Integer> counts,
    Map<String, Double> figures) {

  /** Number of goals without a position, which are scored by completion. */
  public static final String GOALS_WITHOUT_PLACE = "goalsWithoutPlace";

  /** Number of waypoints that were left out because enough others were chosen. */
  public static final String WAYPOINTS_LEFT_OUT = "waypointsLeftOut";

  /** Number of waypoints that operators moved; they are scored where they were moved to. */
  public static final String WAYPOINTS_MOVED = "waypointsMoved";

  /** How often the vehicle left the fence then in force; absent if there was none. */
  public static final String FENCE_BREACHES = "fenceBreaches";

  /** Number of tasks in the rules. */
  public static final String TASKS = "tasks";

  /** Number of completed tasks. */
  public static final String TASKS_DONE = "tasksDone";

  public RunOutcome {
    violations = List.copyOf(violations);
    counts = Collections.unmodifiableMap(new LinkedHashMap<>(counts));
    figures = Collections.unmodifiableMap(new LinkedHashMap<>(figures));
  }

  /** Creates an outcome without further metrics. */
  public RunOutcome(int contacts, boolean stalled, List<String> violations) {
    this(contacts, stalled, violations, Map.of(), Map.of());
  }

  /** Copy with another count. */
  public RunOutcome counting(String name, int count) {
    Map<String, Integer> all = new LinkedHashMap<>(counts);
    all.put(name, count);
    return new RunOutcome(contacts, stalled, violations, all, figures);
  }

  public static RunOutcome clean() {
    return new RunOutcome(0, false, List.of());
  }

  /** With further violations. */
  public RunOutcome breaking(List<String> more) {
    List<String> all = new ArrayList<>(violations);
    all.addAll(more);
    return new RunOutcome(contacts, stalled, all, counts, figures);
  }

  /** Whether there was no contact, no stall and no rule violation. */
  public boolean isClean() {
    return contacts == 0 && !stalled && violations.isEmpty();
  }

  /** Whether it hit anything. */
  public boolean crashed() {
    return contacts > 0;
  }
}
