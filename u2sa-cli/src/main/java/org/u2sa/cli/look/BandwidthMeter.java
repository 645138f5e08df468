package org.u2sa.cli.look;

import java.util.List;
import java.util.Locale;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.schema.U2SAData;

/** Measures the encoded size of messages, without topics and MQTT overhead. */
final class BandwidthMeter implements Meter {
  static final List<String> COLUMNS =
      List.of("MESSAGES", "BANDWIDTH", "SMALLEST", "MEAN", "LARGEST");
  private static final double MICROS = 1e6;
  private static final double KILO = 1e3;

  private final Spread sizes = new Spread(); // [B]
  private final long beganMicros;
  private long bytes;

  /** Starts counting at the given time [µs of real time]. */
  BandwidthMeter(long beganMicros) {
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
