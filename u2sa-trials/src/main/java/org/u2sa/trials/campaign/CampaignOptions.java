package org.u2sa.trials.campaign;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.SortedMap;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.trials.run.HomeFolder;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** The options of {@code u2sa campaign} and the runs they define. */
final class CampaignOptions {
  private static final String SIMULATE = "simulate";

  private static final int MAX_RUNS = 1_000_000;

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  private int seeds = 100;
  private OptionalInt jobs = OptionalInt.empty();
  private final List<Sweep> sweeps = new ArrayList<>();

  @Parameters(
      index = "0",
      paramLabel = "DEMO",
      description =
          "Demo to run, such as ugv, cessna or igvc; or simulate, with its system file and "
              + "options after --.")
  private String demo;

  @Parameters(
      index = "1..*",
      paramLabel = "OPTION",
      description = "After --: options of the demo, for all runs.")
  private List<String> told = List.of();

  @Option(
      names = "--seed",
      paramLabel = "N",
      description = "First seed; others count up. Default: ${DEFAULT-VALUE}.")
  private long firstSeed = 1;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description =
          "Output folder, empty, new, or that of the same campaign, which continues. Default: "
              + "out/campaign-<demo>.")
  private Path out;

  @Option(
      names = "--rank",
      paramLabel = "FIGURE",
      description =
          "Figure in summary.json that ranks the worst runs; larger is worse. Default: ${DEFAULT-VALUE}.")
  private String ranking = "worstMissM";

  @Option(
      names = "--worst",
      paramLabel = "N",
      description = "How many of the worst runs to list. Default: ${DEFAULT-VALUE}.")
  private int worst = 10;

  @Option(
      names = "--keep",
      description =
          "Keep the files of all runs, including pictures; otherwise only those of failed runs, "
              + "without pictures.")
  private boolean keep;

  @Option(names = "--json", description = "Print the summary to standard output, and nothing else.")
  private boolean json;

  @Option(
      names = "--runs",
      paramLabel = "N",
      description = "Number of seeds, for each combination of swept values. Default: 100.")
  private void runs(int value) {
    seeds = atLeastOne("--runs", value);
  }

  @Option(
      names = "--jobs",
      paramLabel = "N",
      description = "Number of parallel processes. Default: one per core.")
  private void jobs(int value) {
    jobs = OptionalInt.of(atLeastOne("--jobs", value));
  }

  @Option(
      names = "--master",
      paramLabel = "ADDRESS",
      description =
          "Distribute the runs with Apache Spark: local[N], local[*] or spark://HOST:PORT. "
              + "Default: local processes (--jobs).")
  private String master;

  @Option(
      names = "--sweep",
      paramLabel = "NAME=VALUE,…",
      description = {
        "Try each of the values of a demo's option (payload=0,5,10), a service's variable (\"PathPlanner:LOOK AHEAD=0.8,1.2\"), or a value of simulate's vehicle (vehicle:body/mass=20,25).",
        "Several: all combinations."
      })
  private void sweeps(List<String> texts) { // called repeatedly with all values so far
    sweeps.clear();
    for (String text : texts) {
      Sweep sweep = Sweep.of(text);
      if (sweeps.stream().anyMatch(earlier -> earlier.name().equals(sweep.name()))) {
        throw refused("--sweep \"" + text + "\": " + sweep.name() + " is already swept");
      }
      sweeps.add(sweep);
    }
  }

  private int atLeastOne(String option, int value) {
    if (value < 1) {
      throw refused(option + " " + value + ": expected 1 or more");
    }
    return value;
  }

  private ParameterException refused(String why) {
    return new ParameterException(command.commandLine(), why);
  }

  /** All runs. */
  List<Experiment> experiments() {
    CommandLine demos = command.root().commandLine().getSubcommands().get("demo");
    if (!demo.equals(SIMULATE) && !demos.getSubcommands().containsKey(demo)) {
      throw refused(
          "DEMO \""
              + demo
              + "\": no such demo; expected one of "
              + demos.getSubcommands().keySet()
              + ", or "
              + SIMULATE);
    }
    long combinations = seeds;
    for (Sweep sweep : sweeps) {
      combinations *= sweep.values().size();
      if (combinations > MAX_RUNS) {
        throw refused("these are more than " + MAX_RUNS + " runs; expected fewer");
      }
    }
    return Experiment.all(base(), firstSeed, seeds, sweeps);
  }

  private List<String> base() {
    List<String> base =
        new ArrayList<>(demo.equals(SIMULATE) ? List.of(SIMULATE) : List.of("demo", demo));
    base.addAll(told);
    return base;
  }

  /** Textual description of the runs; equal text means equal runs. */
  String inWords() {
    StringBuilder words = new StringBuilder(String.join(" ", base()));
    words.append(", seeds ").append(firstSeed).append(" to ").append(firstSeed + seeds - 1);
    for (Sweep sweep : sweeps) {
      words.append(", ").append(sweep.name()).append(" ").append(sweep.values());
    }
    return words.toString();
  }

  /** Digests of the files that the runs read, by name. */
  SortedMap<String, String> inputs() {
    Set<String> words = new LinkedHashSet<>(told);
    for (Sweep sweep : sweeps) {
      sweep.values().forEach(value -> words.addAll(sweep.arguments(value)));
    }
    return InputFiles.of(words, HomeFolder.path(), directory(), System.getenv());
  }

  /** Backend that executes the runs. */
  RunBackend backend() {
    if (master == null) {
      return new WorkerPool(
          jobs.orElseGet(() -> Runtime.getRuntime().availableProcessors()), directory());
    }
    if (jobs.isPresent()) {
      throw refused(
          "--jobs cannot be combined with --master; set Spark's cores with local["
              + jobs.getAsInt()
              + "], or all cores of the cluster");
    }
    return ServiceLoader.load(RunBackendProvider.class)
        .findFirst()
        .orElseThrow(
            () ->
                refused(
                    "--master \""
                        + master
                        + "\": requires the module u2sa-spark, which is not on the class path"))
        .at(master, directory());
  }

  /** Arguments that execute a single run and print its summary. */
  RunRequest request(Experiment experiment) {
    List<String> arguments = new ArrayList<>(experiment.arguments());
    arguments.addAll(List.of("--json", "--port", "0"));
    if (!keep) {
      arguments.add("--summary-only");
    }
    String folder = String.format(Locale.ROOT, "run-%05d", experiment.number());
    return new RunRequest(experiment.number(), arguments, folder, keep);
  }

  List<Sweep> sweeps() {
    return sweeps;
  }

  int worst() {
    return worst;
  }

  String ranking() {
    return ranking;
  }

  boolean json() {
    return json;
  }

  Path directory() {
    return out == null ? Path.of("out", "campaign-" + demo) : out;
  }

  /** Stream for human-readable messages. */
  Terminal terminal() {
    CommandLine line = command.commandLine();
    return Terminal.detect(json ? line.getErr() : line.getOut(), System.getenv());
  }
}
