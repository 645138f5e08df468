package org.u2sa.trials.campaign;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.concurrent.Callable;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.command.ProgramVersion;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.cli.terminal.TextTable;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import org.u2sa.interfaces.time.SystemClock;
import org.u2sa.report.ReportFile;
import org.u2sa.report.summary.RunReport;
import org.u2sa.trials.run.Interruption;
import org.u2sa.trials.run.OutputFolder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code u2sa campaign}: many runs of one demo, on all cores or a cluster. */
@Command(
    name = "campaign",
    description = {
      "Run a demo with many seeds and parameters, on all cores, and report the distribution of its figures.",
      "",
      "Each run is independent: the same seed always gives the same result. The same command "
          + "with the same --out continues an interrupted campaign.",
      "",
      "Examples:",
      "  u2sa campaign ugv --runs 200",
      "  u2sa campaign cessna --runs 50 --sweep wind=calm,breezy,gusty -- --world missions/cessna/obstructed.xml",
      "  u2sa campaign cessna --runs 2000 --master spark://10.0.0.1:7077"
    })
final class CampaignCommand implements Callable<Integer> {
  private static final SystemClock CLOCK = new SystemClock();

  @Mixin private CampaignOptions options;
  @Spec private CommandSpec command;

  @Override
  public Integer call() throws IOException, InterruptedException {
    List<Experiment> experiments = options.experiments();
    RunBackend backend = options.backend();
    Path directory = options.directory();
    OutputFolder.requireUnusedOrCampaign(directory);
    RunReport.prepare(directory);
    String campaign = "u2sa " + ProgramVersion.text() + ": " + options.inWords();
    SortedMap<String, String> inputs = options.inputs();
    SortedMap<String, String> all = InputFiles.ofProgram(System.getProperty("java.class.path"));
    all.putAll(inputs);
    List<Outcome> outcomes = new ArrayList<>();
    try (Interruption interruption = new Interruption();
        Journal journal =
            Journal.open(
                directory.resolve(OutputFolder.JOURNAL), campaign, all, experiments, outcomes)) {
      RunReport.deleteSummary(directory);
      run(backend, experiments, inputs, outcomes, journal, interruption);
      if (outcomes.isEmpty()) {
        throw new RunFailedException("interrupted before the first run was complete");
      }
      return report(campaign, outcomes, experiments.size(), directory);
    }
  }

  private void run(
      RunBackend backend,
      List<Experiment> experiments,
      SortedMap<String, String> inputs,
      List<Outcome> outcomes,
      Journal journal,
      Interruption interruption)
      throws InterruptedException {
    Terminal terminal = options.terminal();
    Path directory = options.directory();
    List<Experiment> left = new ArrayList<>(experiments);
    outcomes.forEach(outcome -> left.remove(outcome.experiment()));
    if (!outcomes.isEmpty()) {
      terminal
          .out()
          .printf("%d of %d runs were already complete.%n", outcomes.size(), experiments.size());
    }
    terminal.out().printf("%d runs on %s; files: %s%n", left.size(), backend.inWords(), directory);
    terminal.out().flush();
    Progress progress = new Progress(terminal, CLOCK::micros, experiments.size(), outcomes.size());
    interruption.onRequest(backend::stop);
    backend.run(
        left.stream().map(options::request).toList(),
        (request, answer) -> {
          Outcome outcome = Outcome.of(experiments.get(request.number() - 1), answer);
          if (outcome.exit() == ExitCode.BAD_INPUT) {
            throw new BadInputException(outcome.trouble());
          }
          requireUnchanged(inputs);
          journal.add(outcome);
          outcomes.add(outcome);
          progress.done(outcome);
        });
  }

  /** Refuses a run whose files may have changed before it read them. */
  private void requireUnchanged(SortedMap<String, String> inputs) {
    SortedMap<String, String> now = options.inputs();
    now.keySet().retainAll(inputs.keySet()); // a run may write a file that its configuration names
    InputFiles.difference(inputs, now)
        .ifPresent(
            name -> {
              throw new BadInputException(
                  name
                      + ": was changed while the campaign ran; expected the same content for all "
                      + "runs: restore it and repeat the command, or use another --out");
            });
  }

  private Integer report(String campaign, List<Outcome> outcomes, int runs, Path directory)
      throws IOException {
    Terminal terminal = options.terminal();
    Results results = new Results(outcomes, options.ranking());
    ReportFile.writeText(directory.resolve("runs.csv"), results::writeCsv);
    ReportFile.writeText(
        directory.resolve("campaign.html"),
        out -> out.write(CampaignPage.of(campaign, results, options.sweeps(), options.worst())));
    String summary = results.json(campaign, options.worst()).toString();
    ReportFile.writeText(directory.resolve(RunReport.SUMMARY), out -> out.write(summary + "\n"));
    spreads(terminal, results.spreads());
    for (Outcome outcome : results.worst(options.worst())) {
      if (!outcome.success()) {
        terminal.out().println(terminal.bad("failed: ") + outcome.experiment().command());
      }
    }
    terminal
        .out()
        .printf(
            "%d of %d runs succeeded (%s). SHA-256 of the results %s%n",
            results.succeeded(), outcomes.size(), results.share(), results.hash());
    terminal.out().println("Report: " + directory.resolve("campaign.html"));
    if (outcomes.size() < runs) {
      terminal
          .out()
          .printf(
              "Interrupted after %d of %d runs; the same command continues from there.%n",
              outcomes.size(), runs);
    }
    if (options.json()) {
      command.commandLine().getOut().println(summary);
    }
    return results.succeeded() == runs ? ExitCode.DONE : ExitCode.FAILED;
  }

  private static void spreads(Terminal terminal, Map<String, Distribution> spreads) {
    TextTable table = new TextTable("figure", "minimum", "median", "95 %", "maximum");
    spreads.forEach(
        (name, spread) -> {
          if (!spread.isConstant()) {
            table.add(
                name,
                number(spread.least()),
                number(spread.median()),
                number(spread.quantile(0.95)),
                number(spread.greatest()));
          }
        });
    table.lines().forEach(terminal.out()::println);
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.3f", value);
  }
}
