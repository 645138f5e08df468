package org.u2sa.report.score;

import java.util.List;
import java.util.Locale;
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
 * @param interventions emergency stops and failsafe actions, one text each; shown if the run failed
 */
public record RunDetails(
    String demo,
    long seed,
    String simulator,
    double wallSeconds,
    OptionalInt goals,
    OptionalInt goalsCompleted,
    List<String> interventions) {

  public RunDetails {
    interventions = List.copyOf(interventions);
  }

  /** Details of a run whose goals are the waypoints of its plan. */
  public RunDetails(
      String demo, long seed, String simulator, double wallSeconds, OptionalInt goalsCompleted) {
    this(demo, seed, simulator, wallSeconds, OptionalInt.empty(), goalsCompleted, List.of());
  }

  /**
   * The result in words: that of the score, preceded by the completed goals if the mission has
   * others than waypoints and the rules define no tasks.
   */
  public String verdict(RunScore score) {
    boolean areOthers = goals.isPresent() && goals.getAsInt() != score.waypoints().size();
    if (!areOthers
        || goalsCompleted.isEmpty()
        || score.outcome().counts().containsKey(RunOutcome.TASKS)) {
      return score.verdict();
    }
    String completed =
        String.format(
            Locale.ROOT, "%d of %d goals completed", goalsCompleted.getAsInt(), goals.getAsInt());
    return score.waypoints().isEmpty() ? completed : completed + ", " + score.verdict();
  }
}
