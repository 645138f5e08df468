package org.u2sa.gcs.services;

import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.function.ToLongFunction;
import org.u2sa.gcs.terminal.TextTable;
import org.u2sa.messages.contract.DiscoveryResponse;
import org.u2sa.messages.contract.HealthReport;

/** The services of a system as a table, one a line. */
final class ServiceTable {
  private static final double SECONDS_PER_MINUTE = 60.0;
  private static final double MICROS_PER_SECOND = 1e6;
  private static final double MILLIS_PER_SECOND = 1e3;

  private ServiceTable() {}

  static List<String> lines(List<ServiceRow> rows) {
    TextTable table =
        new TextTable(
            "NAME",
            "TYPE",
            "STATUS",
            "CONDITION",
            "HOST",
            "UPTIME",
            "VERSION",
            "CLASS",
            "INBOX",
            "DROPS",
            "REPLACED",
            "REFUSED",
            "OVERRUNS",
            "P99",
            "LAST ERROR");
    for (ServiceRow row : rows) {
      table.add(
          row.name(),
          row.type(),
          row.status(),
          row.conditionText(),
          row.discovery().map(DiscoveryResponse::host).orElse(""),
          row.discovery().map(response -> uptime(response.uptime())).orElse(""),
          row.discovery().map(DiscoveryResponse::version).orElse(""),
          row.simpleClassName(),
          count(row, HealthReport::inboxDepth),
          count(row, HealthReport::dropped),
          replaced(row),
          count(row, HealthReport::refused),
          count(row, HealthReport::overruns),
          duration(row.callbackP99S()),
          row.lastError());
    }
    return table.lines();
  }

  /** Empty where a service, of an older version or in another language, does not count them. */
  private static String replaced(ServiceRow row) {
    OptionalLong count = row.health().map(HealthReport::replaced).orElse(OptionalLong.empty());
    return count.isPresent() ? String.valueOf(count.getAsLong()) : "";
  }

  private static String count(ServiceRow row, ToLongFunction<HealthReport> of) {
    return row.health().map(report -> String.valueOf(of.applyAsLong(report))).orElse("");
  }

  /** Seconds below a minute, else hours:minutes:seconds. */
  static String uptime(double seconds) {
    if (seconds < SECONDS_PER_MINUTE) {
      return String.format(Locale.ROOT, "%.1f s", seconds);
    }
    long whole = (long) seconds;
    return String.format(Locale.ROOT, "%d:%02d:%02d", whole / 3600, whole / 60 % 60, whole % 60);
  }

  private static String duration(OptionalDouble seconds) {
    if (seconds.isEmpty()) {
      return "";
    }
    double value = seconds.getAsDouble();
    return value < 1e-3
        ? String.format(Locale.ROOT, "%.0f us", value * MICROS_PER_SECOND)
        : String.format(Locale.ROOT, "%.1f ms", value * MILLIS_PER_SECOND);
  }
}
