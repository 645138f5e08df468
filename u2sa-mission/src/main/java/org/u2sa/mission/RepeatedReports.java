package org.u2sa.mission;

import java.util.HashMap;
import java.util.Map;
import org.u2sa.messages.goal.GoalInformation;

/**
 * Detects duplicate reports (same goal and time) from the network or from a planner that waits for
 * an answer. In a loop each would count as another lap. Not thread-safe.
 */
final class RepeatedReports {
  private final Map<String, Long> newest = new HashMap<>(); // by goal [µs]

  /** Whether the report is a duplicate; false without a time. */
  boolean repeats(GoalInformation report) {
    if (report.timestamp().isEmpty()) {
      return false;
    }
    Long before = newest.put(report.uid(), report.timestamp().getAsLong());
    return before != null && before == report.timestamp().getAsLong();
  }

  /** Resets for another mission. */
  void forget() {
    newest.clear();
  }
}
