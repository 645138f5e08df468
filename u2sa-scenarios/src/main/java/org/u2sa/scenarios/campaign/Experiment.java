package org.u2sa.scenarios.campaign;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * One run of a campaign.
 *
 * @param number from 1
 * @param seed of everything random in it
 * @param factors the value of each parameter that is swept, as written
 * @param arguments what {@code u2sa} is told to make it, in words
 */
record Experiment(int number, long seed, Map<String, String> factors, List<String> arguments) {
  /**
   * All runs: for each combination of the swept values, the first parameter slowest, as many seeds.
   *
   * @param base the demo and its options
   * @param firstSeed of each combination
   * @param seeds how many, at least one
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

  /** The line that makes the same run by itself, pictures included. */
  String command() {
    return arguments.stream()
        .map(Experiment::quoted)
        .collect(Collectors.joining(" ", "./u2sa ", ""));
  }

  private static String quoted(String word) {
    return word.matches("[A-Za-z0-9_./:=,@%+-]+") ? word : "'" + word.replace("'", "'\\''") + "'";
  }
}
