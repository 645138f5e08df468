package org.u2sa.cli.look;

import java.util.List;
import java.util.Locale;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.schema.U2SAData;

/** Measures one source's messages. */
interface Meter {
  double MICROS = 1e6; // per second

  /** Adds a message, with its time of arrival [µs of real time]. */
  void take(long micros, U2SAData message);

  /** Cells of the row, in column order, at the given time [µs of real time]. */
  List<String> cells(long nowMicros);

  /** Adds the same values as numbers. */
  void addTo(JsonText json, long nowMicros);

  private static String millis(String form, double seconds) {
    return String.format(Locale.ROOT, form, seconds * 1e3);
  }

  /** Measures the rate and jitter of messages. */
  final class Rate implements Meter {
    static final List<String> COLUMNS =
        List.of("MESSAGES", "RATE", "SHORTEST", "MEAN", "LONGEST", "DEVIATION");
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
          millis("%.1f ms", gaps.quantile(0.0)),
          millis("%.1f ms", gaps.mean()),
          millis("%.1f ms", gaps.quantile(1.0)),
          millis("%.1f ms", gaps.deviation()));
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

  /**
   * Measures the age of messages on arrival, from the timestamp of their measurement. Requires
   * synchronised clocks; not meaningful in simulated time, which has its own clock.
   */
  final class Delay implements Meter {
    static final List<String> COLUMNS =
        List.of("MESSAGES", "SHORTEST", "MEDIAN", "P99", "LONGEST", "REMARK");
    private static final double OTHER_CLOCK_S = 86_400.0;
    private static final double SAME_CLOCK_S = 0.001; // how well processes of one machine agree

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
        return "timestamps come from another clock; simulated time?";
      }
      return delays.quantile(0.0) < -SAME_CLOCK_S ? "from the future: the clocks differ" : "";
    }

    @Override
    public List<String> cells(long nowMicros) {
      String messages = String.valueOf(delays.count() + undated);
      if (delays.count() == 0 || Math.abs(delays.quantile(0.5)) > OTHER_CLOCK_S) {
        return List.of(messages, "", "", "", "", remark());
      }
      return List.of(
          messages,
          millis("%.2f ms", delays.quantile(0.0)),
          millis("%.2f ms", delays.quantile(0.5)),
          millis("%.2f ms", delays.quantile(0.99)),
          millis("%.2f ms", delays.quantile(1.0)),
          remark());
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

  /** Measures the encoded size of messages, without topics and MQTT overhead. */
  final class Bandwidth implements Meter {
    static final List<String> COLUMNS =
        List.of("MESSAGES", "BANDWIDTH", "SMALLEST", "MEAN", "LARGEST");
    private static final double KILO = 1e3;

    private final Spread sizes = new Spread(); // [B]
    private final long beganMicros;
    private long bytes;

    /** Starts counting at the given time [µs of real time]. */
    Bandwidth(long beganMicros) {
      this.beganMicros = beganMicros;
    }

    @Override
    public void take(long micros, U2SAData message) {
      int size = message.serialize().length;
      sizes.add(size);
      bytes += size;
    }

    private double perSecond(long nowMicros) {
      return bytes / Math.max(1e-3, (nowMicros - beganMicros) / MICROS);
    }

    @Override
    public List<String> cells(long nowMicros) {
      return List.of(
          String.valueOf(sizes.count()),
          amount(perSecond(nowMicros)) + "/s",
          amount(sizes.quantile(0.0)),
          amount(sizes.mean()),
          amount(sizes.quantile(1.0)));
    }

    private static String amount(double bytes) {
      if (bytes < KILO) {
        return String.format(Locale.ROOT, "%.0f B", bytes);
      }
      return bytes < KILO * KILO
          ? String.format(Locale.ROOT, "%.1f kB", bytes / KILO)
          : String.format(Locale.ROOT, "%.1f MB", bytes / KILO / KILO);
    }

    @Override
    public void addTo(JsonText json, long nowMicros) {
      json.put("messages", sizes.count()).put("bytes", bytes);
      json.put("bytesPerS", perSecond(nowMicros));
      json.put("smallestB", sizes.quantile(0.0)).put("meanB", sizes.mean());
      json.put("largestB", sizes.quantile(1.0));
    }
  }
}
