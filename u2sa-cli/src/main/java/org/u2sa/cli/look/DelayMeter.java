package org.u2sa.cli.look;

import java.util.List;
import java.util.Locale;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.schema.U2SAData;

/**
 * Measures the age of messages on arrival, from the timestamp of their measurement. Requires
 * synchronised clocks; not meaningful in simulated time, which has its own clock.
 */
final class DelayMeter implements Meter {
  static final List<String> COLUMNS =
      List.of("MESSAGES", "SHORTEST", "MEDIAN", "P99", "LONGEST", "REMARK");
  private static final double MICROS = 1e6;
  private static final double MILLIS = 1e3;
  private static final double OTHER_CLOCK_S = 86_400.0;

  private final Spread delays = new Spread(); // [s]
  private long undated;

  @Override
  public void take(long micros, U2SAData message) {
    if (message.timestamp().isPresent()) {
      delays.add((micros - message.timestamp().getAsLong()) / MICROS);
    } else {
      undated++;
    }
  }

  private String remark() {
    if (delays.count() == 0) {
      return undated + " without a timestamp";
    }
    if (Math.abs(delays.quantile(0.5)) > OTHER_CLOCK_S) {
      return "timestamps are of another clock: simulated time?";
    }
    return delays.quantile(0.0) < 0.0 ? "from the future: the clocks differ" : "";
  }

  @Override
  public List<String> cells(long nowMicros) {
    String messages = String.valueOf(delays.count() + undated);
    if (delays.count() == 0 || Math.abs(delays.quantile(0.5)) > OTHER_CLOCK_S) {
      return List.of(messages, "", "", "", "", remark());
    }
    return List.of(
        messages,
        millis(delays.quantile(0.0)),
        millis(delays.quantile(0.5)),
        millis(delays.quantile(0.99)),
        millis(delays.quantile(1.0)),
        remark());
  }

  private static String millis(double seconds) {
    return String.format(Locale.ROOT, "%.2f ms", seconds * MILLIS);
  }

  @Override
  public void addTo(JsonText json, long nowMicros) {
    json.put("messages", delays.count() + undated).put("undated", undated);
    if (delays.count() > 0) {
      json.put("shortestS", delays.quantile(0.0)).put("medianS", delays.quantile(0.5));
      json.put("p99S", delays.quantile(0.99)).put("longestS", delays.quantile(1.0));
    }
    json.put("remark", remark());
  }
}
