package org.u2sa.benchmarks.fleet;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * One measurement.
 *
 * @param sent states that were to be published
 * @param arrived of these, at the ground
 * @param refused of these, by the vehicles' own connections, which count them
 * @param missed how many the ground's connection knows it missed: with those that arrived, all
 * @param p50Ms from when a state was due to when it was decoded [ms]
 * @param brokerMicros processor time of the broker's process, a message [µs]
 * @param clientMicros processor time of all vehicles and the ground together, a message [µs]
 * @param memoryMb of the broker's process [MB]
 */
record Result(
    String broker,
    int round,
    int vehicles,
    long sent,
    long arrived,
    long refused,
    long missed,
    double p50Ms,
    double p99Ms,
    double p999Ms,
    double brokerMicros,
    double clientMicros,
    double memoryMb) {

  String json() {
    return String.format(
        Locale.ROOT,
        "{\"broker\": \"%s\", \"round\": %d, \"vehicles\": %d, \"sent\": %d, \"arrived\": %d,"
            + " \"refused\": %d, \"missed\": %d, \"p50_ms\": %.3f, \"p99_ms\": %.3f, \"p99.9_ms\":"
            + " %.3f, \"broker_us\": %.2f, \"client_us\": %.2f, \"broker_mb\": %.0f}",
        broker,
        round,
        vehicles,
        sent,
        arrived,
        refused,
        missed,
        p50Ms,
        p99Ms,
        p999Ms,
        brokerMicros,
        clientMicros,
        memoryMb);
  }

  static String json(List<Result> results) {
    return results.stream().map(Result::json).collect(Collectors.joining(",\n", "[\n", "\n]\n"));
  }

  static String table(List<Result> results) {
    StringBuilder table = new StringBuilder();
    table.append(
        String.format(
            "%-10s %5s %9s %9s %8s %8s %8s %8s %8s %10s %10s %6s%n",
            "broker",
            "round",
            "sent",
            "arrived",
            "refused",
            "missed",
            "p50 ms",
            "p99 ms",
            "p99.9 ms",
            "broker us",
            "clients us",
            "MB"));
    for (Result each : results) {
      table.append(
          String.format(
              Locale.ROOT,
              "%-10s %5d %,9d %,9d %8d %8d %8.1f %8.1f %8.1f %10.1f %10.1f %6.0f%n",
              each.broker,
              each.round,
              each.sent,
              each.arrived,
              each.refused,
              each.missed,
              each.p50Ms,
              each.p99Ms,
              each.p999Ms,
              each.brokerMicros,
              each.clientMicros,
              each.memoryMb));
    }
    return table.toString();
  }
}
