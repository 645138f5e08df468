package org.u2sa.cli.dependencies;

import java.io.PrintWriter;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.function.LongSupplier;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.terminal.TextTable;
import org.u2sa.interfaces.time.SystemClock;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code u2sa dependencies}: lists libraries, their age and published advisories. */
@Command(
    name = "dependencies",
    description = {
      "List the libraries U2SA uses: version, age, licence and published advisories.",
      "",
      "Works offline: advisories are those known when they were last looked up. "
          + "Exit code 1: an advisory affects a version in use, in code that U2SA reaches."
    })
public final class DependenciesCommand implements Callable<Integer> {
  private static final double DAYS_A_YEAR = 365.25;

  private final DependencyData data;
  private final LongSupplier clockMicros;

  @Spec private CommandSpec command;

  @Option(
      names = "--advisories",
      description = "List all known advisories, including those that do not affect our versions.")
  private boolean advisories;

  /** Uses this program's libraries and the current date. */
  public DependenciesCommand() {
    this(null, new SystemClock()::micros);
  }

  /**
   * @param data libraries to list; null to read those in the jar when the command runs
   * @param clockMicros current time since 1970 [us]
   */
  DependenciesCommand(DependencyData data, LongSupplier clockMicros) {
    this.data = data;
    this.clockMicros = clockMicros;
  }

  @Override
  public Integer call() {
    DependencyData known = data == null ? DependencyData.inThisJar() : data;
    PrintWriter out = command.commandLine().getOut();
    (advisories ? looked(known) : listed(known)).lines().forEach(out::println);
    List<DependencyData.Advisory> affecting =
        known.libraries().stream().flatMap(each -> known.affecting(each).stream()).toList();
    long reached = affecting.stream().filter(DependencyData.Advisory::reached).count();
    out.printf(
        Locale.ROOT,
        "%d libraries, %d advisories looked up on %s (%s ago): %d affect a version here, %d of them reached%n",
        known.libraries().size(),
        known.advisories().size(),
        known.lookedUp(),
        age(known.lookedUp()),
        affecting.size(),
        reached);
    return reached == 0 ? ExitCode.DONE : ExitCode.FAILED;
  }

  private TextTable listed(DependencyData known) {
    TextTable table = new TextTable("LIBRARY", "VERSION", "USE", "AGE", "LICENCE", "AFFECTED BY");
    for (DependencyData.Library each : known.libraries()) {
      table.add(
          each.name(),
          each.version(),
          each.use(),
          age(each.released()),
          each.licence(),
          String.join(
              ", ",
              known.affecting(each).stream()
                  .map(advisory -> advisory.id() + (advisory.reached() ? "" : " (not reached)"))
                  .toList()));
    }
    return table;
  }

  private static TextTable looked(DependencyData known) {
    TextTable table = new TextTable("ADVISORY", "LIBRARY", "FROM", "FIXED", "REACHED", "WHAT");
    for (DependencyData.Advisory each : known.advisories()) {
      table.add(
          each.id(),
          each.library(),
          each.introduced(),
          each.fixed(),
          each.reached() ? "yes" : "no",
          each.what());
    }
    return table;
  }

  private String age(LocalDate since) {
    Duration sinceEpoch = Duration.of(clockMicros.getAsLong(), ChronoUnit.MICROS);
    LocalDate today = Instant.EPOCH.plus(sinceEpoch).atOffset(ZoneOffset.UTC).toLocalDate();
    long days = Math.max(0, ChronoUnit.DAYS.between(since, today));
    return days < DAYS_A_YEAR
        ? days + " days"
        : String.format(Locale.ROOT, "%.1f years", days / DAYS_A_YEAR);
  }
}
