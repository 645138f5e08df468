package org.u2sa.mission;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.service.handover.HandOver;

/**
 * Who drives the vehicle by hand, and which drives the mission has been paused for: also one that
 * began, or even ended, while no Mission Manager ran. Confined to the manager's thread.
 */
final class DrivingByHand {
  private static final String PAUSED_FOR = "PAUSED FOR DRIVES BY HAND";
  private static final int MAX_DRIVERS = 16;

  private final boolean isRestart;
  private final Map<String, Long> drives = new LinkedHashMap<>(); // by driver
  private String driver = ""; // empty: nobody

  /**
   * @param isRestart whether retained states are of this run, whatever their age
   */
  DrivingByHand(boolean isRestart) {
    this.isRestart = isRestart;
  }

  /** The present driver; empty: nobody. */
  String driver() {
    return driver;
  }

  /**
   * Sees a state of driving by hand.
   *
   * @param isNews whether it is fresh; an older one, retained, may be of another run
   * @return whether the mission must pause for a drive
   */
  boolean see(ManualState state, boolean isNews) {
    boolean isOfThisRun = isNews || isRestart;
    driver = state.active() && isOfThisRun ? state.operator() : "";
    long unknown = isRestart ? 0L : state.takeovers();
    boolean wasMissed = state.takeovers() > drives.getOrDefault(state.operator(), unknown);
    drives.put(state.operator(), state.takeovers());
    if (drives.size() > MAX_DRIVERS) {
      drives.remove(drives.keySet().iterator().next());
    }
    return !driver.isEmpty() || isOfThisRun && wasMissed;
  }

  void handOver(HandOver state) {
    List<String> lines = new ArrayList<>();
    drives.forEach((who, count) -> lines.add(count + " " + who));
    state.texts(PAUSED_FOR, lines);
  }

  /** Continues after the predecessor; what was saved by an earlier run does not count. */
  void takeOver(HandOver state) {
    if (isRestart) {
      for (String line : state.texts(PAUSED_FOR)) {
        int end = line.indexOf(' ');
        drives.put(line.substring(end + 1), Long.parseLong(line.substring(0, end)));
      }
    }
  }
}
