package org.u2sa.trials.run;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.TimeUnit;
import org.u2sa.cli.terminal.Terminal;
import org.u2sa.interfaces.disk.RegularFile;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The options common to all demos; used as {@code @Mixin DemoOptions options}. */
public final class DemoOptions {

  private static final long DEFAULT_SEED = 1;
  private static final DateTimeFormatter STAMP =
      DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss", Locale.ROOT);

  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  private OptionalLong seed = OptionalLong.empty();
  private Path mission;
  private int runs = 1;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description =
          "Output folder, empty or new. Default: out/<demo>-<time or seed>; a run with the same "
              + "seed replaces it.")
  private Path out;

  @Option(
      names = "--json",
      description = "Print summary.json to standard output, and nothing else.")
  private boolean json;

  @Option(
      names = "--summary-only",
      description = "Write summary.json and the logs, but no track and no pictures.")
  private boolean summaryOnly;

  @Option(
      names = "--realtime",
      description = "Run in real time instead of as fast as the machine allows.")
  private boolean realtime;

  @Option(
      names = "--seed",
      paramLabel = "N",
      description =
          "Random seed: the same seed reproduces the run byte for byte. Default: "
              + DEFAULT_SEED
              + ".")
  private void seed(long value) {
    seed = OptionalLong.of(value);
  }

  @Option(
      names = "--mission",
      paramLabel = "FILE",
      description = "Mission file (XML) to use instead of the demo's own.")
  private void mission(Path file) {
    Optional<String> problem =
        RegularFile.problem(file)
            .or(() -> Files.isReadable(file) ? Optional.empty() : Optional.of("is not readable"));
    if (problem.isPresent()) {
      throw new ParameterException(
          command.commandLine(),
          "--mission " + file + ": " + problem.get() + "; expected a mission (XML)");
    }
    mission = file;
  }

  @Option(
      names = "--runs",
      paramLabel = "N",
      description = "Number of runs, with seeds counting up from --seed. Default: 1.")
  private void runs(int value) {
    if (value < 1) {
      throw new ParameterException(
          command.commandLine(), "--runs " + value + ": expected 1 or more");
    }
    runs = value;
  }

  /** Seed of the first run; run k (from 0) uses {@code seed() + k}. */
  public long seed() {
    return seed.orElse(DEFAULT_SEED);
  }

  /** The requested mission, a readable file; empty for the demo's default. */
  public Optional<Path> mission() {
    return Optional.ofNullable(mission);
  }

  /** Number of runs, at least 1. */
  public int runs() {
    return runs;
  }

  /** Whether standard output is reserved for {@code summary.json}. */
  public boolean json() {
    return json;
  }

  /** Whether to omit track and pictures. */
  public boolean summaryOnly() {
    return summaryOnly;
  }

  /** Whether to run in real time. */
  public boolean realtime() {
    return realtime;
  }

  /** Stream for human-readable messages: standard output, or standard error with {@code --json}. */
  public Terminal terminal() {
    CommandLine line = command.commandLine();
    return Terminal.detect(json ? line.getErr() : line.getOut(), System.getenv());
  }

  /** The folder named by {@code --out}; empty if the default is used. */
  Optional<Path> out() {
    return Optional.ofNullable(out);
  }

  /**
   * Output directory of this command: {@code --out}, else {@code out/<demo>-seed<N>} if a seed was
   * given, else {@code out/<demo>-<yyyyMMdd-HHmmss>} by local time.
   *
   * @param demo name of the demo, e.g. {@code cessna}
   * @param startedAtMicros when the command started, system clock [µs since 1970]
   */
  public Path outDirectory(String demo, long startedAtMicros) {
    if (out != null) {
      return out;
    }
    String run =
        seed.isPresent()
            ? "seed" + seed.getAsLong()
            : STAMP.format(
                Instant.ofEpochSecond(TimeUnit.MICROSECONDS.toSeconds(startedAtMicros))
                    .atZone(ZoneId.systemDefault()));
    return Paths.get("out", demo + "-" + run);
  }

  /**
   * Output directory of run {@code k} (from 0): the directory itself for a single run, else {@code
   * run-01}, … inside it.
   */
  public Path runDirectory(Path directory, int k) {
    return runs == 1 ? directory : directory.resolve(String.format(Locale.ROOT, "run-%02d", k + 1));
  }
}
