package org.u2sa.benchmarks.chain;

import java.util.Locale;
import org.HdrHistogram.Histogram;

/**
 * One run.
 *
 * @param command from a measurement's publishing to the last actuator's callback [ns]
 * @param plan from a measurement's publishing to the control's receipt of the point planned from it [ns]
 * @param sent measurements of the IMU
 * @param late of these, those whose command came after the next measurement was due
 * @param merged of these, those without a command of their own, as another measurement's state took the place of theirs
 * @param overruns steps that periodic services missed, warm-up left out
 * @param dropped messages that inboxes lost
 * @param replaced messages that newer ones of the same source replaced, which is no loss
 * @param gcMillis time of garbage collections [ms]
 * @param load of the machine, over a minute
 */
record ChainResult(
    Scenario scenario,
    int round,
    Histogram command,
    Histogram plan,
    long sent,
    long late,
    long merged,
    long overruns,
    long dropped,
    long replaced,
    long gcCount,
    long gcMillis,
    double load) {
  private static final double MICRO = 1e3;

  static String head() {
    return String.format(
        "%-32s %8s %8s %8s %8s | %8s %8s | %7s %5s %6s %8s %5s %8s %9s %5s",
        "chain, us", "p50", "p99", "p99.9", "max", "plan p50", "p99", "sent", "late", "merged", "overruns", "lost", "replaced",
        "GC", "load");
  }

  String row() {
    return String.format(Locale.ROOT, "%-32s", scenario)
        + String.format(
            Locale.ROOT,
            " %8.0f %8.0f %8.0f %8.0f | %8.0f %8.0f | %7d %5d %6d %8d %5d %8d %3d/%2d ms %5.1f",
            figures());
  }

  String json() {
    return String.format(
            Locale.ROOT,
            "{\"benchmark\": \"chain\", \"hz\": %d, \"neighbours\": %d, \"company\": \"%s\", \"round\": %d, ",
            scenario.hz(),
            scenario.neighbours(),
            scenario.company(),
            round)
        + String.format(
            Locale.ROOT,
            "\"p50_us\": %.1f, \"p99_us\": %.1f, \"p99.9_us\": %.1f, \"max_us\": %.1f, \"plan_p50_us\": %.1f, \"plan_p99_us\": %.1f,"
                + " \"sent\": %d, \"late\": %d, \"merged\": %d, \"overruns\": %d, \"lost\": %d, \"replaced\": %d, \"gc\": %d, \"gc_ms\": %d,"
                + " \"load\": %.2f}",
            figures());
  }

  /** In the order of the table. */
  private Object[] figures() {
    return new Object[] {
      micros(command, 50.0),
      micros(command, 99.0),
      micros(command, 99.9),
      micros(command, 100.0),
      micros(plan, 50.0),
      micros(plan, 99.0),
      sent,
      late,
      merged,
      overruns,
      dropped,
      replaced,
      gcCount,
      gcMillis,
      load
    };
  }

  private static double micros(Histogram histogram, double percentile) {
    return histogram.getValueAtPercentile(percentile) / MICRO;
  }
}
