package org.u2sa.benchmarks.mqtt;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/** Medians of all rounds, and the best round. */
final class Table {
  private Table() {}

  static String of(List<Result> results) {
    Map<String, List<Result>> byKey = new LinkedHashMap<>();
    for (Result result : results) {
      byKey.computeIfAbsent(result.key(), key -> new ArrayList<>()).add(result);
    }
    StringBuilder table = new StringBuilder();
    table.append(
        String.format(
            "%-54s %9s %9s %9s %9s %11s %11s %6s %8s %10s%n",
            "way, processes, contents",
            "p50 us",
            "p99 us",
            "p99.9 us",
            "best p50",
            "messages/s",
            "best",
            "lost",
            "cpu us",
            "alloc B"));
    byKey.forEach(
        (key, rounds) ->
            table.append(
                String.format(
                    Locale.ROOT,
                    "%-54s %9.1f %9.1f %9.1f %9.1f %,11.0f %,11.0f %6d %8.1f %,10.0f%n",
                    key,
                    median(rounds, Result::p50Micros),
                    median(rounds, Result::p99Micros),
                    median(rounds, Result::p999Micros),
                    rounds.stream().mapToDouble(Result::p50Micros).min().orElseThrow(),
                    median(rounds, Result::arrivedPerS),
                    rounds.stream().mapToDouble(Result::arrivedPerS).max().orElseThrow(),
                    rounds.stream().mapToLong(Result::lost).sum(),
                    median(rounds, Result::cpuMicros),
                    median(rounds, Result::allocatedBytes))));
    return table.toString();
  }

  private static double median(List<Result> rounds, ToDoubleFunction<Result> of) {
    double[] sorted = rounds.stream().mapToDouble(of).sorted().toArray();
    int middle = sorted.length / 2;
    return sorted.length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
  }
}
