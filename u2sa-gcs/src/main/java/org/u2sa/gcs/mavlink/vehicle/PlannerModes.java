package org.u2sa.gcs.mavlink.vehicle;

import java.util.List;
import java.util.Optional;
import org.u2sa.messages.contract.DiscoveryResponse;

/**
 * Classes that can replace the vehicle's Path Planner, including those from jars. Each is a
 * separate mode; Mission is the first class received. Messages may arrive on any thread.
 */
public final class PlannerModes {
  private static final String ROLE = "PATH_PLANNER";
  private static final int MAX_CLASSES = 32;
  private static final int MAX_LABEL = 34; // of AVAILABLE_MODES

  /**
   * The known planner and its classes.
   *
   * @param service its name; empty if unknown
   * @param usual class received first
   * @param running its class
   * @param others classes other than the usual one
   * @param version counts changes of the list
   */
  private record Known(
      String service, String usual, String running, List<String> others, int version) {}

  private volatile Known known = new Known("", "", "", List.of(), 0);

  void take(DiscoveryResponse response) {
    if (!response.serviceType().equals(ROLE) || response.className().isEmpty()) {
      return;
    }
    Known before = known;
    String running = response.className().get();
    boolean isSame = response.serviceName().equals(before.service());
    if (!isSame && !before.service().isEmpty()) {
      return; // only one planner provides modes
    }
    String usual = isSame ? before.usual() : running;
    List<String> others =
        response.choices().stream()
            .filter(each -> !each.equals(usual))
            .sorted()
            .distinct()
            .limit(MAX_CLASSES)
            .toList();
    int version = before.version() + (others.equals(before.others()) ? 0 : 1);
    known = new Known(response.serviceName(), usual, running, others, version);
  }

  /** Number of changes of the list so far. */
  public int version() {
    return known.version();
  }

  /** Number of classes other than that of the mode Mission. */
  public int size() {
    return known.others().size();
  }

  /** Name of a mode, by its index from 0. */
  public String label(int index) {
    String name = known.others().get(index);
    String simple = name.substring(name.lastIndexOf('.') + 1).replace('$', '.');
    return simple.substring(0, Math.min(MAX_LABEL, simple.length()));
  }

  /** Index of the running class; empty if it is that of the mode Mission. */
  public Optional<Integer> running() {
    int index = known.others().indexOf(known.running());
    return index < 0 ? Optional.empty() : Optional.of(index);
  }

  /** Name of the planner's service. */
  String service() {
    return known.service();
  }

  /** Class of a mode by its index; without an index that of the mode Mission. */
  String className(Optional<Integer> index) {
    return index.isPresent() ? known.others().get(index.get()) : known.usual();
  }
}
