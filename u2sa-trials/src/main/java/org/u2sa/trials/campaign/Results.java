package org.u2sa.trials.campaign;

import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.u2sa.interfaces.JsonText;

/**
 * Results of all runs of a campaign.
 *
 * @param outcomes in the order of their numbers, at least one
 * @param ranking metric for ranking the runs; greater is worse
 */
record Results(List<Outcome> outcomes, String ranking) {
  Results {
    outcomes =
        outcomes.stream()
            .sorted(Comparator.comparingInt(outcome -> outcome.experiment().number()))
            .toList();
  }

  /** Number of successful runs. */
  long succeeded() {
    return outcomes.stream().filter(Outcome::success).count();
  }

  /** Distributions of all metrics, over the runs that have them. */
  Map<String, Distribution> spreads() {
    Map<String, List<Double>> values = new TreeMap<>();
    for (Outcome outcome : outcomes) {
      outcome
          .figures()
          .forEach(
              (name, value) -> values.computeIfAbsent(name, n -> new ArrayList<>()).add(value));
    }
    Map<String, Distribution> spreads = new TreeMap<>();
    values.forEach(
        (name, all) ->
            spreads.put(name, Distribution.of(all.stream().mapToDouble(Double::doubleValue))));
    return spreads;
  }

  /** The worst runs: failed runs first, then by the ranking metric. */
  List<Outcome> worst(int most) {
    return outcomes.stream()
        .sorted(
            Comparator.comparing(Outcome::success)
                .thenComparing(
                    outcome -> -outcome.figure(ranking).orElse(Double.NEGATIVE_INFINITY)))
        .limit(most)
        .toList();
  }

  /**
   * SHA-256 of all results except execution speed: identical for any number of cores and machines.
   */
  String hash() {
    try {
      MessageDigest digest = MessageDigest.getInstance("SHA-256");
      for (Outcome outcome : outcomes) {
        digest.update(outcome.repeatable().getBytes(StandardCharsets.UTF_8));
      }
      return HexFormat.of().formatHex(digest.digest());
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }

  /** One line per run, comma-separated: its parameters and all metrics. */
  void writeCsv(Writer out) throws IOException {
    List<String> factors = List.copyOf(outcomes.get(0).experiment().factors().keySet());
    SortedSet<String> figures = new TreeSet<>(spreads().keySet());
    List<String> head = new ArrayList<>(List.of("run", "seed"));
    head.addAll(factors);
    head.add("success");
    head.addAll(figures);
    line(out, head);
    for (Outcome outcome : outcomes) {
      Experiment experiment = outcome.experiment();
      List<String> cells = new ArrayList<>();
      cells.add(Integer.toString(experiment.number()));
      cells.add(Long.toString(experiment.seed()));
      factors.forEach(factor -> cells.add(experiment.factors().get(factor)));
      cells.add(Boolean.toString(outcome.success()));
      for (String figure : figures) {
        OptionalDouble value = outcome.figure(figure);
        cells.add(value.isPresent() ? Double.toString(value.getAsDouble()) : "");
      }
      line(out, cells);
    }
  }

  private static void line(Writer out, List<String> cells) throws IOException {
    for (int i = 0; i < cells.size(); i++) {
      String cell = cells.get(i);
      boolean quoted = cell.matches("(?s).*[\",\r\n].*");
      out.write(i == 0 ? "" : ",");
      out.write(quoted ? '"' + cell.replace("\"", "\"\"") + '"' : cell);
    }
    out.write('\n');
  }

  JsonText json(String campaign, int worst) {
    JsonText figures = new JsonText();
    spreads()
        .forEach(
            (name, spread) ->
                figures.put(
                    name,
                    new JsonText()
                        .put("runs", spread.values().length)
                        .put("least", spread.least())
                        .put("median", spread.median())
                        .put("mean", spread.mean())
                        .put("p95", spread.quantile(0.95))
                        .put("greatest", spread.greatest())));
    List<JsonText> bad = new ArrayList<>();
    for (Outcome outcome : worst(worst)) {
      bad.add(
          new JsonText()
              .put("run", outcome.experiment().number())
              .put("seed", outcome.experiment().seed())
              .put("success", outcome.success())
              .put(ranking, outcome.figure(ranking))
              .put("trouble", outcome.trouble())
              .put("command", outcome.experiment().command()));
    }
    return new JsonText()
        .put("campaign", campaign)
        .put("runs", outcomes.size())
        .put("runsSucceeded", succeeded())
        .put("sha256", hash())
        .put("figures", figures)
        .put("worst", bad);
  }

  /** Success rate, such as "98.5 %". */
  String share() {
    return String.format(Locale.ROOT, "%.1f %%", 100.0 * succeeded() / outcomes.size());
  }
}
