package org.u2sa.estimation.fusion;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.u2sa.estimation.measurement.SensedQuantity;

/** Reports on each source of the filter, for operators and health reports. */
public final class SourceReports {
  private static final double INTERVALS = 5.0;
  private static final double SILENT_AFTER_S = 1.0;
  private static final double GATED_STREAK = 3.0;
  private static final double OUTLIERS = 0.05; // fraction of vectors

  /** Status of a source: the worst of its quantities. */
  public enum Standing {
    /** Its measurements are fused. */
    USED,
    /** None of its measurements can be used yet, or at all. */
    UNUSED,
    /** Its newest measurements contradict the estimate, or many single ones of a velocity log. */
    GATED,
    /** The source contradicts other sources, always in the same direction. */
    BIASED,
    /** It repeats its values while the vehicle moves. */
    FROZEN,
    /** It has been silent for longer than its usual interval. */
    SILENT
  }

  /**
   * Report on one source.
   *
   * @param used number of vectors fused
   * @param gated number of vectors rejected
   * @param sigmaFactor largest factor applied to its claimed standard deviations
   * @param lateS estimated delay of its positions [s]; 0 if not significant
   * @param offsetM subtracted from its altitudes [m]
   */
  public record Report(
      String source,
      Standing standing,
      long used,
      long gated,
      double sigmaFactor,
      double lateS,
      double offsetM) {

    /** Text such as "biased, used 312, gated 40, sigma x2.9, late by 0.20 s". */
    public String text() {
      return String.format(
          "%s, used %s, gated %s, sigma x%s%s%s",
          standing.name().toLowerCase(Locale.ROOT),
          used,
          gated,
          Math.round(10.0 * sigmaFactor) / 10.0,
          lateS == 0.0 ? "" : ", late by " + Math.round(100.0 * lateS) / 100.0 + " s",
          offsetM == 0.0
              ? ""
              : ", altitude corrected by " + Math.round(-10.0 * offsetM) / 10.0 + " m");
    }
  }

  private final FilterState s;
  private final SourceTrust trust;
  private final FilterTuning tuning;

  SourceReports(FilterState s, SourceTrust trust, FilterTuning tuning) {
    this.s = s;
    this.trust = trust;
    this.tuning = tuning;
  }

  /** Reports on all sources, sorted by name. */
  public List<Report> at(long nowMicros) {
    List<Report> reports = new ArrayList<>();
    for (int source = 0; source < trust.sources(); source++) {
      reports.add(report(source, nowMicros));
    }
    reports.sort(Comparator.comparing(Report::source));
    return Collections.unmodifiableList(reports);
  }

  private Report report(int source, long nowMicros) {
    int own = trust.of(s, source);
    double[] t = s.trust;
    long used = 0;
    long gated = 0;
    double factor = 1.0;
    Standing standing = Standing.UNUSED;
    for (int q = 0; q < SensedQuantity.count(); q++) {
      SensedQuantity quantity = SensedQuantity.at(q);
      if (!trust.isKnown(source, quantity)) {
        continue;
      }
      int at = trust.of(s, source, quantity);
      used += (long) t[at + SourceTrust.USED];
      gated += (long) t[at + SourceTrust.GATED];
      factor = Math.max(factor, Math.sqrt(SourceTrust.factor(s, at)));
      standing = worse(standing, standing(at));
    }
    if (t[own + SourceTrust.IS_FROZEN] != 0.0) {
      standing = Standing.FROZEN;
    }
    double silentS = (nowMicros - t[own + SourceTrust.LAST_MICROS]) * 1e-6;
    if (silentS > Math.max(SILENT_AFTER_S, INTERVALS * t[own + SourceTrust.INTERVAL])) {
      standing = Standing.SILENT;
    }
    double lateS = DelayErrors.lateS(s, source);
    double offsetM =
        trust.isShifted(s, source, SensedQuantity.ALTITUDE)
            ? t[trust.of(s, source, SensedQuantity.ALTITUDE) + SourceTrust.OFFSET]
            : 0.0;
    return new Report(trust.name(source), standing, used, gated, factor, lateS, offsetM);
  }

  private Standing standing(int at) {
    double[] t = s.trust;
    if (t[at + SourceTrust.IS_BIASED] != 0.0) {
      return Standing.BIASED;
    }
    if (t[at + SourceTrust.STREAK] >= GATED_STREAK || t[at + SourceTrust.OUTLIERS] > OUTLIERS) {
      return Standing.GATED;
    }
    double sinceS = (s.micros - t[at + SourceTrust.LAST_USED]) * 1e-6;
    boolean isUsed = t[at + SourceTrust.USED] > 0.0 && sinceS < tuning.resetAfterS() * INTERVALS;
    return isUsed ? Standing.USED : Standing.UNUSED;
  }

  private static Standing worse(Standing a, Standing b) {
    return a.compareTo(b) >= 0 && a != Standing.UNUSED ? a : b == Standing.UNUSED ? a : b;
  }
}
