package org.u2sa.cli.configuration;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.CommandFixture;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.remote.ForeignSystem;

/** {@code u2sa config} on a system of another process. */
@Timeout(120)
class ConfigCommandTest extends CommandFixture {
  private static final String PLANNER = "PathPlanner";

  @TempDir private static Path directory;
  private static ForeignSystem foreign;

  @BeforeAll
  static void start() {
    foreign =
        ForeignSystem.start(
            directory,
            "rover",
            "org.u2sa.planning.PathPlanner",
            HastyAnswerer.class.getName(),
            "org.u2sa.estimation.PassThroughStateEstimator");
  }

  @AfterAll
  static void end() {
    foreign.close();
  }

  private int run(String action, String... arguments) {
    List<String> all = new ArrayList<>(List.of("config", action));
    all.addAll(List.of(arguments));
    all.addAll(List.of("--broker", foreign.broker(), "--system", "rover"));
    if (!all.contains("--timeout")) {
      all.addAll(List.of("--timeout", "60")); // ends with the answer
    }
    out.getBuffer().setLength(0);
    err.getBuffer().setLength(0);
    return u2sa(all.toArray(new String[0]));
  }

  @Test
  void list_oneService_showsValueTypeWhatIsAllowedAndMeaning() {
    assertThat(run("list", PLANNER)).isEqualTo(ExitCode.DONE);

    assertThat(out.toString())
        .startsWith("PathPlanner (revision ")
        .doesNotContain("StateEstimator")
        .containsPattern("GUIDANCE +LINE +string +LINE \\| DIRECT \\| ILOS +\\w")
        .containsPattern("STALE AFTER +[0-9.]+ s +double +\\S");
  }

  @Test
  void list_allAsJson_namesEveryServiceAndEndsWithTheLastAnswer() {
    assertThat(run("list", "--json", "--timeout", "3600")).isEqualTo(ExitCode.DONE);

    assertThat(out.toString())
        .contains("\"name\" : \"PathPlanner\"", "\"name\" : \"StateEstimator\"")
        .contains("\"system\" : \"rover\"", "\"choices\"");
  }

  @Test
  void setGetUndo_twoVariables_changeTogetherAndBack() {
    assertThat(run("set", PLANNER, "LOITER RADIUS=0.5 km", "ATTEMPTS=7")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .containsPattern("LOITER RADIUS: [0-9.]+ → 500.0 m\n")
        .containsPattern("ATTEMPTS: \\d+ → 7\n")
        .containsPattern("PathPlanner is at revision \\d+; not saved: the service has no config");

    assertThat(run("get", PLANNER, "LOITER RADIUS")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).isEqualTo("500.0 m\n");

    assertThat(run("undo", PLANNER)).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).containsPattern("LOITER RADIUS: 500.0 → [0-9.]+ m\n");
    assertThat(run("get", PLANNER, "LOITER RADIUS")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).isNotEqualTo("500.0 m\n");
  }

  /** The other one answers at once, the planner after it has looked at the value. */
  @Test
  void set_anotherServiceAnswersThatItIsDone_isRefusedByTheServiceAsked() {
    assertThat(run("set", PLANNER, "GUIDANCE=NONE")).isNotEqualTo(ExitCode.DONE);
    assertThat(out + "" + err).contains("NONE").doesNotContain("revision 99");
  }

  @Test
  void exportImport_bothFormats_changesOnlyWhatDiffersAndAllOrNothing() throws IOException {
    for (String name : List.of("rover.params", "rover.parm")) {
      Path file = directory.resolve(name);
      assertThat(run("export", file.toString())).isEqualTo(ExitCode.DONE);
      assertThat(run("import", file.toString())).isEqualTo(ExitCode.DONE);
      assertThat(out.toString()).startsWith("Nothing to change");

      String text = Files.readString(file);
      assertThat(text).containsPattern("PATP_ATTEMPTS[,\\t]\\d+");
      String eight = text.replaceFirst("(PATP_ATTEMPTS[,\\t])\\d+", "$18");
      Files.writeString(file, eight);
      assertThat(run("import", file.toString())).isEqualTo(ExitCode.DONE);
      assertThat(out.toString()).containsPattern("^ATTEMPTS: \\d+ → 8\nPathPlanner is at revision");
      assertThat(run("undo", PLANNER)).isEqualTo(ExitCode.DONE);

      Files.writeString(file, eight.replaceFirst("(PATP_GUIDANCE[,\\t])\\d+", "$177"));
      assertThat(run("import", file.toString())).isEqualTo(ExitCode.BAD_INPUT);
      assertThat(err.toString()).contains("PATP_GUIDANCE 77: expected 0 = LINE, 1 = DIRECT");
      assertThat(run("get", PLANNER, "ATTEMPTS")).isEqualTo(ExitCode.DONE);
      assertThat(out.toString()).isNotEqualTo("8\n");
    }
  }

  @Test
  void set_refusedByTheService_tellsItsReasonAndFails() {
    assertThat(run("set", PLANNER, "ATTEMPTS=3", "LOITER RADIUS=-1")).isEqualTo(ExitCode.FAILED);

    assertThat(err.toString())
        .startsWith("u2sa: ")
        .contains("variable \"LOITER RADIUS\": -1 m is not at least 0 m");
  }

  @Test
  void set_oldRevision_isRefused() {
    assertThat(run("set", PLANNER, "ATTEMPTS=5", "--revision", "999")).isEqualTo(ExitCode.FAILED);

    assertThat(err.toString()).contains("not 999");
  }

  @Test
  void misspeltNames_areBadInputWithASuggestion() {
    assertThat(run("set", PLANNER, "LOITER RADUIS=5")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("did you mean \"LOITER RADIUS\"?");

    assertThat(run("get", "PathPlaner", "ATTEMPTS", "--timeout", "3600"))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("did you mean \"PathPlanner\"?");

    assertThat(run("set", PLANNER, "ATTEMPTS")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("\"ATTEMPTS\": expected VARIABLE=VALUE");

    assertThat(run("set", PLANNER, "LOITER RADIUS=5 kg")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("variable \"LOITER RADIUS\": ").contains("kg");
  }
}
