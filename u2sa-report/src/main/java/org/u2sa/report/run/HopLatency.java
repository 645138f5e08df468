package org.u2sa.report.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.u2sa.interfaces.JsonText;
import org.u2sa.report.page.Chart;
import org.u2sa.report.page.Trace;

/**
 * Age of messages at the recorder, by channel, counted from the time of measurement. Simulated time
 * does not advance while services compute: there, the age is the sum of the steps in between.
 */
final class HopLatency {
  private static final double MILLIS = 1e3;

  private final Map<String, Trace> byChannel = new TreeMap<>(); // [ms]
  private boolean isShortened;

  /** Adds a message with its age: the time from its timestamp to its recording [s]. */
  void take(String channel, double timeS, double ageS) {
    if (byChannel.size() < ReportLimits.MAX_SOURCES || byChannel.containsKey(channel)) {
      byChannel.computeIfAbsent(channel, Trace::new).add(timeS, ageS * MILLIS);
    } else {
      isShortened = true;
    }
  }

  boolean isShortened() {
    return isShortened;
  }

  /** Latencies along the path from sensor to actuator. */
  Chart chart() {
    List<Trace> lines = new ArrayList<>();
    for (String channel : List.of("sensed-state", "state", "navigation", "actuation")) {
      Trace trace = byChannel.get(channel);
      if (trace != null) {
        lines.add(trace);
      }
    }
    return new Chart("Age of messages when recorded", "ms", lines, null);
  }

  List<JsonText> rows(double durationS) {
    List<JsonText> rows = new ArrayList<>();
    byChannel.forEach(
        (channel, trace) ->
            rows.add(
                new JsonText()
                    .put("channel", channel)
                    .put("messages", trace.size())
                    .put("rateHz", durationS > 0 ? trace.size() / durationS : 0.0)
                    .put("p50Ms", Trace.rounded(trace.quantile(0.5)))
                    .put("p99Ms", Trace.rounded(trace.quantile(0.99)))
                    .put("maxMs", Trace.rounded(trace.quantile(1.0)))));
    return rows;
  }
}
