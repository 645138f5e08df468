package org.u2sa.cli.look;

import java.util.List;
import java.util.Locale;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.schema.U2SAData;

/** Measures the rate and jitter of messages. */
final class RateMeter implements Meter {
  static final List<String> COLUMNS =
      List.of("MESSAGES", "RATE", "SHORTEST", "MEAN", "LONGEST", "DEVIATION");
  private static final double MICROS = 1e6;
  private static final double MILLIS = 1e3;
  private static final double SILENT_S = 2.0; // exceeds delays of a busy broker or network
  private static final double SILENT_INTERVALS = 5.0;

  private final Spread gaps = new Spread(); // [s]
  private long messages;
  private long firstMicros;
  private long lastMicros;

  @Override
  public void take(long micros, U2SAData message) {
    if (messages++ == 0) {
      firstMicros = micros;
    } else {
      gaps.add((micros - lastMicros) / MICROS);
    }
    lastMicros = micros;
  }

  /**
   * Mean rate [Hz]; 0 before the second message, and for a source silent for much longer than
   * usual.
   */
  private double rate(long nowMicros) {
    double silenceS = (nowMicros - lastMicros) / MICROS;
    boolean isSilent = silenceS > Math.max(SILENT_S, SILENT_INTERVALS * gaps.mean());
    return lastMicros > firstMicros && !isSilent
        ? (messages - 1) * MICROS / (lastMicros - firstMicros)
        : 0.0;
  }

  @Override
  public List<String> cells(long nowMicros) {
    if (gaps.count() == 0) {
      return List.of(String.valueOf(messages), "", "", "", "", "");
    }
    return List.of(
        String.valueOf(messages),
        String.format(Locale.ROOT, "%.2f Hz", rate(nowMicros)),
        millis(gaps.quantile(0.0)),
        millis(gaps.mean()),
        millis(gaps.quantile(1.0)),
        millis(gaps.deviation()));
  }

  private static String millis(double seconds) {
    return String.format(Locale.ROOT, "%.1f ms", seconds * MILLIS);
  }

  @Override
  public void addTo(JsonText json, long nowMicros) {
    json.put("messages", messages);
    if (gaps.count() > 0) {
      json.put("rateHz", rate(nowMicros));
      json.put("shortestS", gaps.quantile(0.0)).put("meanS", gaps.mean());
      json.put("longestS", gaps.quantile(1.0)).put("deviationS", gaps.deviation());
    }
  }
}
