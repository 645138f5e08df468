package org.u2sa.scenarios.suas.score;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;

/**
 * Score of the targets: for each, the fraction of correct fields (0.2), its position (0.3 · (150 ft
 * − d) / 150 ft), being reported in flight (0.3) and without human help (0.2), as in the rules of
 * 2019. A report counts for the target that it matches best. Further reports cost 0.05 of a target
 * each.
 */
public final class ObjectScore {
  private static final double WIDE_M = 45.72; // 150 ft
  private static final double CHARACTERISTICS = 0.2;
  private static final double PLACE = 0.3;
  private static final double IN_FLIGHT = 0.3;
  private static final double AUTONOMOUS = 0.2;
  private static final double EXTRA = 0.05;

  /**
   * A target, or a report of one.
   *
   * @param fields shape, colour, letter, letter's colour, orientation; null if unknown
   */
  public record Sheet(double eastM, double northM, List<String> fields) {}

  /**
   * A report and its target.
   *
   * @param distanceM distance of the report from the target [m]
   * @param rightFields number of correct fields, not including the position
   */
  public record Match(int target, int report, double distanceM, int rightFields, double score) {}

  /**
   * Result.
   *
   * @param falseReports reports that match no target
   * @param score of all targets, 0…1
   */
  public record Result(List<Match> matches, int falseReports, double score) {}

  private ObjectScore() {}

  public static Result of(List<Sheet> targets, List<Sheet> reports) {
    List<Match> pairs = new ArrayList<>();
    for (int t = 0; t < targets.size(); t++) {
      for (int r = 0; r < reports.size(); r++) {
        pairs.add(match(t, r, targets.get(t), reports.get(r)));
      }
    }
    pairs.sort((a, b) -> Double.compare(b.score(), a.score()));
    Set<Integer> takenTargets = new HashSet<>();
    Set<Integer> takenReports = new HashSet<>();
    List<Match> matches = new ArrayList<>();
    double sum = 0.0;
    for (Match pair : pairs) {
      if (pair.distanceM() < WIDE_M
          && !takenTargets.contains(pair.target())
          && !takenReports.contains(pair.report())) {
        takenTargets.add(pair.target());
        takenReports.add(pair.report());
        matches.add(pair);
        sum += pair.score();
      }
    }
    int extra = reports.size() - matches.size();
    double score = targets.isEmpty() ? 0.0 : (sum - EXTRA * extra) / targets.size();
    return new Result(List.copyOf(matches), extra, Math.max(0.0, score));
  }

  private static Match match(int t, int r, Sheet target, Sheet report) {
    double distance =
        Math.hypot(target.eastM() - report.eastM(), target.northM() - report.northM());
    int right = 0;
    for (int i = 0; i < target.fields().size(); i++) {
      right += Objects.equals(target.fields().get(i), report.fields().get(i)) ? 1 : 0;
    }
    double score =
        CHARACTERISTICS * right / target.fields().size()
            + PLACE * Math.max(0.0, (WIDE_M - distance) / WIDE_M)
            + IN_FLIGHT
            + AUTONOMOUS;
    return new Match(t, r, distance, right, score);
  }
}
