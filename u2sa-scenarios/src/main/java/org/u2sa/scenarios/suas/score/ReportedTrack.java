package org.u2sa.scenarios.suas.score;

import java.util.ArrayList;
import java.util.List;

/**
 * The aircraft's positions as reported to the judges, every 0.1 s: duplicates are dropped, and gaps
 * of more than 5 s are not bridged.
 */
public final class ReportedTrack {
  private static final double STEP_S = 0.1;
  private static final double GAP_S = 5.0;

  /**
   * A report.
   *
   * @param timeS time of the run [s]
   * @param eastM position [m]
   * @param northM likewise
   * @param upM likewise
   */
  public record Sample(double timeS, double eastM, double northM, double upM) {
    double distanceM(double east, double north, double up) {
      return Math.sqrt(
          (eastM - east) * (eastM - east)
              + (northM - north) * (northM - north)
              + (upM - up) * (upM - up));
    }
  }

  private final List<Sample> reports = new ArrayList<>();

  /** Adds a report, unless its position is that of the previous one. */
  public void add(Sample report) {
    if (!reports.isEmpty()) {
      Sample last = reports.get(reports.size() - 1);
      if (report.timeS() <= last.timeS()
          || last.distanceM(report.eastM(), report.northM(), report.upM()) == 0.0) {
        return;
      }
    }
    reports.add(report);
  }

  public List<Sample> reports() {
    return List.copyOf(reports);
  }

  /** Mean time between reports [s]; infinite with fewer than two. */
  public double meanGapS() {
    int count = reports.size();
    return count < 2
        ? Double.POSITIVE_INFINITY
        : (reports.get(count - 1).timeS() - reports.get(0).timeS()) / (count - 1);
  }

  /** The reports and positions between them. */
  public List<Sample> interpolated() {
    List<Sample> all = new ArrayList<>();
    for (int i = 0; i < reports.size(); i++) {
      Sample to = reports.get(i);
      if (i > 0 && to.timeS() - reports.get(i - 1).timeS() <= GAP_S) {
        Sample from = reports.get(i - 1);
        double span = to.timeS() - from.timeS();
        for (double since = STEP_S; since < span - 1e-9; since += STEP_S) {
          double share = since / span;
          all.add(
              new Sample(
                  from.timeS() + since,
                  from.eastM() + share * (to.eastM() - from.eastM()),
                  from.northM() + share * (to.northM() - from.northM()),
                  from.upM() + share * (to.upM() - from.upM())));
        }
      }
      all.add(to);
    }
    return all;
  }
}
