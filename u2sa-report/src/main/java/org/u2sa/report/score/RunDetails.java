package org.u2sa.report.score;

import java.util.OptionalInt;

/**
 * Details of a run in a summary, besides its score.
 *
 * @param demo name of the demo or system, e.g. {@code cessna}; heads the picture
 * @param seed seed of everything random in the run
 * @param simulator what simulated the vehicle, e.g. {@code embedded} or {@code FlightGear
 *     2020.3.16}
 * @param wallSeconds wall-clock duration of the run [s], more than 0
 * @param goals goals of the mission; empty: as many as the plan has waypoints
 * @param goalsCompleted goals that the Mission Manager reported completed; empty: unknown
 */
public record RunDetails(
    String demo,
    long seed,
    String simulator,
    double wallSeconds,
    OptionalInt goals,
    OptionalInt goalsCompleted) {

  /** Details of a run whose goals are the waypoints of its plan. */
  public RunDetails(
      String demo, long seed, String simulator, double wallSeconds, OptionalInt goalsCompleted) {
    this(demo, seed, simulator, wallSeconds, OptionalInt.empty(), goalsCompleted);
  }
}
