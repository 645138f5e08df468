package org.u2sa.trials.campaign;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * One run of a campaign.
 *
 * @param number from 1
 * @param seed the seed of all random streams
 * @param factors the value of each swept parameter, as written
 * @param arguments command-line arguments of {@code u2sa} for this run
 */
record Experiment(int number, long seed, Map<String, String> factors, List<String> arguments) {
  /**
   * All runs: every combination of the swept values (the first parameter varies slowest) with each
   * seed.
   *
   * @param base the demo and its options
   * @param firstSeed first seed of each combination
   * @param seeds seeds per combination, at least one
   */
  static List<Experiment> all(List<String> base, long firstSeed, int seeds, List<Sweep> sweeps) {
    List<Experiment> all = new ArrayList<>();
    add(all, base, firstSeed, seeds, sweeps, new LinkedHashMap<>());
    return all;
  }

  private static void add(
      List<Experiment> all,
      List<String> told,
      long firstSeed,
      int seeds,
      List<Sweep> left,
      Map<String, String> factors) {
    if (left.isEmpty()) {
      for (int k = 0; k < seeds; k++) {
        List<String> arguments = new ArrayList<>(told);
        arguments.addAll(List.of("--seed", Long.toString(firstSeed + k)));
        all.add(
            new Experiment(all.size() + 1, firstSeed + k, new LinkedHashMap<>(factors), arguments));
      }
      return;
    }
    Sweep first = left.get(0);
    for (String value : first.values()) {
      List<String> more = new ArrayList<>(told);
      more.addAll(first.arguments(value));
      factors.put(first.name(), value);
      add(all, more, firstSeed, seeds, left.subList(1, left.size()), factors);
    }
  }

  /** The command line that repeats only this run, including pictures. */
  String command() {
    return arguments.stream()
        .map(Experiment::quoted)
        .collect(Collectors.joining(" ", "./u2sa ", ""));
  }

  private static String quoted(String word) {
    return word.matches("[A-Za-z0-9_./:=,@%+-]+") ? word : "'" + word.replace("'", "'\\''") + "'";
  }
}
