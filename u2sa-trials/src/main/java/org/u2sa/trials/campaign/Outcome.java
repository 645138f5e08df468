package org.u2sa.trials.campaign;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.u2sa.cli.command.ExitCode;

/**
 * Result of one run.
 *
 * @param experiment the run
 * @param exit exit code of the demo, {@link ExitCode}, or {@link RunAnswer#LOST} if its processes
 *     died
 * @param summary its {@code summary.json}, or empty
 * @param trouble the demo's error message; empty if none
 */
record Outcome(Experiment experiment, int exit, String summary, String trouble) {
  private static final List<String> OF_THE_MACHINE = List.of("wallSeconds", "simSecondsPerSecond");

  static Outcome of(Experiment experiment, RunAnswer answer) {
    String summary = SummaryFigures.areIn(answer.output()) ? answer.output() : "";
    boolean isToldInSummary = !summary.isEmpty();
    String said = isToldInSummary ? answer.errors() : answer.output() + answer.errors();
    return new Outcome(
        experiment,
        answer.exit(),
        summary,
        answer.exit() == ExitCode.DONE || isToldInSummary
            ? ""
            : said.strip().replaceFirst("^u2sa: ", ""));
  }

  /** Whether the run succeeded completely. */
  boolean success() {
    return exit == ExitCode.DONE;
  }

  /** The summary's metrics by name. */
  Map<String, Double> figures() {
    Map<String, Double> figures = SummaryFigures.of(summary);
    OF_THE_MACHINE.forEach(figures::remove);
    return figures;
  }

  /** One metric, or empty if the summary lacks it. */
  OptionalDouble figure(String name) {
    Double value = figures().get(name);
    return value == null ? OptionalDouble.empty() : OptionalDouble.of(value);
  }

  /** All machine-independent results, for comparison. */
  String repeatable() {
    String lines =
        summary
            .lines()
            .filter(
                line -> OF_THE_MACHINE.stream().noneMatch(name -> line.contains('"' + name + '"')))
            .collect(Collectors.joining("\n"));
    return experiment.command() + "\n" + exit + "\n" + lines + "\n";
  }
}
