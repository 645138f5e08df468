package org.u2sa.cli.dependencies;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.time.LocalDate;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.cli.command.ExitCode;
import picocli.CommandLine;

class DependenciesCommandTest {
  private static final long DAY_MICROS = 86_400_000_000L;

  private final StringWriter out = new StringWriter();

  private int run(boolean reached, String version, String... arguments) {
    LocalDate released = LocalDate.of(2024, 1, 1);
    DependencyData data =
        new DependencyData(
            List.of(new DependencyData.Library("a.b:c", version, released, "run", "MIT")),
            List.of(
                new DependencyData.Advisory("CVE-7", "a.b:c", "1.0", "1.5", reached, "too much")),
            LocalDate.of(2025, 12, 22));
    long now = LocalDate.of(2026, 1, 1).toEpochDay() * DAY_MICROS;
    return new CommandLine(new DependenciesCommand(data, () -> now))
        .setOut(new PrintWriter(out))
        .execute(arguments);
  }

  @Test
  void call_nothingAffected_listsAgesAndIsDone() {
    assertThat(run(true, "1.5")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString().lines())
        .containsExactly(
            "LIBRARY  VERSION  USE  AGE        LICENCE",
            "a.b:c    1.5      run  2.0 years  MIT",
            "1 libraries, 1 advisories looked up on 2025-12-22 (10 days ago):"
                + " 0 affect a version here, 0 of them reached");
  }

  @Test
  void call_affectedAndReached_fails() {
    assertThat(run(true, "1.4.9")).isEqualTo(ExitCode.FAILED);
    assertThat(out.toString()).contains("MIT      CVE-7").contains("1 of them reached");
  }

  @Test
  void call_affectedAndNotReached_saysSoAndIsDone() {
    assertThat(run(false, "1.4.9")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("CVE-7 (not reached)").contains("0 of them reached");
  }

  @Test
  void call_advisories_listsThemAll() {
    assertThat(run(false, "1.5", "--advisories")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("CVE-7     a.b:c    1.0   1.5    no       too much");
  }
}
