package org.u2sa.gcs.report;

import java.util.List;

/**
 * What the simulator says of the end of a flight.
 *
 * @param crashed whether the vehicle hit something, or the ground harder than its gear bears
 * @param stalled whether a wing stalled in the air
 * @param violations other rules broken, a sentence each
 */
public record FlightOutcome(boolean crashed, boolean stalled, List<String> violations) {

  public FlightOutcome {
    violations = List.copyOf(violations);
  }

  /** Nothing to complain of. */
  public static FlightOutcome clean() {
    return new FlightOutcome(false, false, List.of());
  }
}
