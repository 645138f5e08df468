package org.u2sa.scenarios.ugv;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.cli.Main;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.recorder.mcap.McapCursor;
import org.u2sa.recorder.mcap.McapReader;
import org.u2sa.recorder.mcap.record.McapMessage;
import org.u2sa.scenarios.run.CommandLineRun;

/** A drive that is recorded. */
class RecordedDriveTest {
  private static final String TWO_WAYPOINTS =
      """
      <mission>
        <home><x>11</x><y>48</y><psi>0</psi></home>
        <waypoint><y>48.0001</y><x>11</x></waypoint>
        <waypoint><y>48.0001</y><x>11.0001</x></waypoint>
      </mission>
      """;

  @TempDir Path folder;

  private CommandLineRun drive(String out, String... options) throws IOException {
    Path mission = Files.writeString(folder.resolve("short.xml"), TWO_WAYPOINTS);
    List<String> all = new ArrayList<>(List.of(options));
    all.addAll(List.of("--seed", "3", "--mission", mission.toString()));
    CommandLineRun run =
        CommandLineRun.demo("ugv", folder.resolve(out), all.toArray(new String[0]));
    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    return run;
  }

  /**
   * Messages as texts: those of health without their contents, which measure the machine, and none
   * of the last instant, when services end on threads of their own.
   */
  private static List<String> messages(Path out) throws IOException {
    List<String> all = new ArrayList<>();
    try (McapReader reader = McapReader.open(out.resolve("recording.mcap"))) {
      McapCursor cursor = reader.messages(Long.MIN_VALUE, channel -> true);
      for (Optional<McapMessage> m = cursor.next(); m.isPresent(); m = cursor.next()) {
        McapMessage message = m.get();
        String topic = reader.channels().get(message.channelId()).topic();
        if (message.logTimeNanos() < reader.statistics().endNanos()) {
          all.add(
              topic
                  + " "
                  + message.sequence()
                  + " "
                  + message.logTimeNanos()
                  + " "
                  + (topic.contains("/health/") ? "" : HexFormat.of().formatHex(message.data())));
        }
      }
    }
    return all;
  }

  @Test
  void demo_recordedTwice_drivesAsUnrecordedAndGivesTheSameMessages() throws IOException {
    CommandLineRun unrecorded = drive("plain");
    CommandLineRun recorded = drive("recorded", "--record");
    drive("again", "--record");
    assertThat(recorded.track()).isEqualTo(unrecorded.track());
    List<String> messages = messages(folder.resolve("recorded"));
    List<String> again = messages(folder.resolve("again"));
    assertThat(messages).hasSizeGreaterThan(5_000);
    for (int i = 0; i < Math.min(messages.size(), again.size()); i++) {
      assertThat(again.get(i)).as("message %d", i).isEqualTo(messages.get(i));
    }
    assertThat(again).hasSameSizeAs(messages);
    assertThat(messages).anyMatch(line -> line.startsWith("u2sa/ugv/goal-reports/"));
    assertThat(folder.resolve("plain/recording.mcap")).doesNotExist();
    try (McapReader reader = McapReader.open(folder.resolve("recorded/recording.mcap"))) {
      assertThat(reader.attachmentNames())
          .contains(
              "config/ugv/system.xml",
              "config/ugv/Control.xml",
              "config/ugv/fence.xml",
              "logs/PathPlanner.log")
          .anyMatch(name -> name.startsWith("pursued-mission/"));
      assertThat(reader.metadata())
          .anySatisfy(
              metadata ->
                  assertThat(metadata.entries())
                      .containsEntry("dropped", "0")
                      .containsEntry("not-written", "0"))
          .anySatisfy(
              metadata ->
                  assertThat(metadata.entries())
                      .containsEntry("seed", "3")
                      .containsEntry("demo", "ugv"));
    }
  }

  @Test
  void rerun_recordedDrive_isIdenticalAndAChangedGainIsFound() throws IOException {
    drive("recorded", "--record");
    String file = folder.resolve("recorded/recording.mcap").toString();
    StringWriter same = new StringWriter();
    assertThat(replay(same, file, "--rerun", "all")).as(same.toString()).isEqualTo(ExitCode.DONE);
    assertThat(same.toString())
        .contains("StateEstimator", "MissionManager", "PathPlanner", "Control", "SafetyManager")
        .contains("\nIdentical: ");
    StringWriter other = new StringWriter();
    Path page = folder.resolve("against.html");
    String change = "Control:TURN GAIN=1.0000001";
    replay(other, file, "--rerun", "Control", "--against", change, "--page", page.toString());
    assertThat(other.toString())
        .contains("\nNot identical: ")
        .contains("actuation  percentage (LEFT MOTOR)")
        .contains(page.toString());
    assertThat(page)
        .content()
        .contains("\"title\":\"Control: actuation, percentage (LEFT MOTOR)\"", change)
        .contains("\"name\":\"now − recorded\"")
        .doesNotContain("http://localhost", "https://");
    StringWriter unknown = new StringWriter();
    assertThat(replay(unknown, file, "--rerun", "PathPlaner")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(unknown.toString()).contains("PathPlaner").contains("PathPlanner");
  }

  /** The fence of the shipped mission is a file, which the repetition reads from another folder. */
  @Test
  void rerun_driveWithinAFence_isIdentical() {
    Path out = folder.resolve("fenced");
    CommandLineRun run = CommandLineRun.demo("ugv", out, "--loops", "1", "--seed=1", "--record");
    assertThat(run.exitCode()).as(run.out() + run.err()).isEqualTo(ExitCode.DONE);
    StringWriter same = new StringWriter();
    replay(same, out.resolve("recording.mcap").toString(), "--rerun", "SafetyManager");
    assertThat(same.toString())
        .containsPattern("SafetyManager +fence +1 +1 +1")
        .contains("\nIdentical: ");
  }

  @Test
  void rerun_servicesSwappedWhileDriving_thoseBeforeAndAfterAreIdentical() throws IOException {
    CommandLineRun run =
        drive(
            "swapped",
            "--record",
            "--swap",
            "5:StateEstimator=org.u2sa.estimation.ComplementaryStateEstimator",
            "--swap",
            "8:PathPlanner=org.u2sa.planning.VectorFieldPlanner",
            "--swap",
            "12:Control=org.u2sa.control.ground.DifferentialDriveControl",
            "--swap",
            "15:StateEstimator=org.u2sa.estimation.FusingStateEstimator");
    assertThat(run.out()).contains("15.0 s: StateEstimator swapped");
    StringWriter out = new StringWriter();
    int exitCode =
        replay(out, folder.resolve("swapped/recording.mcap").toString(), "--rerun", "all");
    assertThat(exitCode).as(out.toString()).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .contains("StateEstimator#2", "StateEstimator#3", "PathPlanner#2", "Control#2")
        .contains("\nIdentical: ");
  }

  private static int replay(StringWriter out, String... options) {
    PrintWriter printer = new PrintWriter(out, true);
    List<String> all = new ArrayList<>(List.of("replay"));
    all.addAll(List.of(options));
    return Main.run(printer, printer, all.toArray(new String[0]));
  }

  @Test
  void demo_splitWithoutRecord_isRefused() {
    CommandLineRun run = CommandLineRun.demo("ugv", folder.resolve("out"), "--split", "10s");
    assertThat(run.exitCode()).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(run.err()).contains("--record");
  }
}
