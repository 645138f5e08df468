package org.u2sa.scenarios.cessna;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.scenarios.run.CommandLineRun;
import org.u2sa.testkit.Repository;

/** What the commands say to wrong input: one clear line, exit code 2, nothing left running. */
class BadInputTest {
  @TempDir private Path directory;

  @ParameterizedTest(name = "{1} → {2}")
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          Control.xml     | name="STALE AFTER" type="double" value="1.0" | name="STALE AFTER" type="double" value="-1" | Control.xml, line 4, variable "STALE AFTER": -1
          Control.xml     | name="STALE AFTER" | name="STALE AFTR" | Control.xml, line 4, variable "STALE AFTR": no service declares it; did you mean "STALE AFTER"?
          Control.xml     | type="double" value="1.0" unit="s" | type="double" value="1.0" unit="kg" | Control.xml, line 4, variable "STALE AFTER"
          Control.xml     | <configuration> | <configuration | Control.xml, line
          PathPlanner.xml | "LINE" | "CURVE" | PathPlanner.xml, line 5, variable "GUIDANCE": "CURVE" is not one of "LINE", "DIRECT"
          CommunicationManager.xml | "1883" | "x" | CommunicationManager.xml, line 7, variable "COMMUNICATION MANAGER PORT": value "x" is not a whole number
          CommunicationManager.xml | "embedded" | "carrier pigeon" | CommunicationManager.xml, line 4, variable "BROKER": "carrier pigeon" is not one of "embedded", "external", "none"
          system.xml      | CessnaControl" | CessnaControll" | system.xml, line 11, <service>: class "org.u2sa.control.fixedwing.CessnaControll" is not on the class path
          system.xml      | "Control.xml" | "Nothing.xml" | system.xml, line 11, <service>: configuration "Nothing.xml": there is no file
          system.xml      | id="cessna" | id="a/b" | system.xml, line 3, <system>: id
          """)
  void run_wrongConfiguration_namesFileLineAndExpected(
      String file, String text, String wrong, String expected) throws IOException {
    copyConfiguration();
    Path changed = directory.resolve("cessna").resolve(file);
    String before = Files.readString(changed);
    assertThat(before).contains(text);
    Files.writeString(changed, before.replace(text, wrong));

    String system = directory.resolve("cessna/system.xml").toString();
    if (file.equals("CommunicationManager.xml")) {
      requireRefused(expected, "run", system);
    } else { // whoever has the configured port is no matter here
      requireRefused(expected, "run", system, "--set", "CommunicationManager:BROKER=none");
    }
  }

  @Test
  void run_noSuchSystemFile_isRefused() {
    requireRefused("nothing.xml: there is no such file", "run", "nothing.xml");
  }

  @ParameterizedTest(name = "{0} → {1}")
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          <y>21.325247</y> | <y>91</y> | short.xml, line 4, <y>: 91.0 is outside -90.0…90.0 deg of latitude
          <y>21.325247</y> | <y>89.5</y> | short.xml, line 4, <y>: 89.5 is outside -85.0…85.0 deg of latitude, the range for starting
          <y>21.325247</y> | <y>-89.9</y> | short.xml, line 4, <y>: -89.9 is outside -85.0…85.0 deg of latitude
          <z unit="ft">17.5</z> | <z>9000</z> | short.xml, line 5, <z>: 9000.0 is outside -500.0…5000.0 m above sea level
          <psi>90.0</psi>  | ''        | short.xml: lacks the heading <psi> of its <home>
          <psi>90.0</psi>  | <psi>north</psi> | short.xml, line 6, <psi>: "north" is not a number
          </mission>       | ''        | short.xml, line
          <horizontalThreshold>100< | <horizontalThreshold>0< | short.xml, line 13, <horizontalThreshold>: 0.0 m can never be met
          <name>1</name>   | <nmae>1</nmae> | short.xml, line 9, <nmae>
          """)
  void demo_wrongMission_namesFileLineAndExpected(String text, String wrong, String expected) {
    Path mission = ShortMission.in(directory, text, wrong);

    requireRefused(
        expected,
        "demo",
        "cessna",
        "--port",
        "0",
        "--mission",
        mission.toString(),
        "--out",
        directory.resolve("out").toString());

    assertThat(directory.resolve("out")).doesNotExist();
  }

  @ParameterizedTest(name = "{0} {1}")
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          --seed    | x            | 'x' is not a whole number
          --runs    | 0            | --runs 0: expected 1 or more
          --wind    | 99@1         | --wind: wind "99@1": expected "calm", or speed and direction such as 5@270
          --port    | 70000        | --port 70000: expected 0…65535
          --mission | nothing.xml  | --mission nothing.xml: no such file
          --sped    | 1            | unknown option '--sped'
          """)
  void demo_wrongOption_isRefusedBeforeAnythingIsMade(String option, String value, String says) {
    Path out = directory.resolve("out");

    requireRefused(says, "demo", "cessna", "--out", out.toString(), option, value);

    assertThat(out).doesNotExist();
  }

  @Test
  void demo_sensorsInRealTime_areRefusedBecauseItsSimulatorHasNone() {
    requireRefused(
        "--estimator: \"fusing\" needs sensors",
        "demo",
        "cessna",
        "--realtime",
        "--estimator",
        "fusing",
        "--out",
        directory.resolve("out").toString());
  }

  @Test
  void demo_outIsAFile_isRefused() throws IOException {
    Path file = Files.writeString(directory.resolve("file"), "");

    requireRefused(
        "cannot write to " + file, "demo", "cessna", "--port", "0", "--out", file.toString());
  }

  @Test
  void run_brokerUnreachable_failsInOneLine() {
    Set<Thread> before = RunningThreads.now();
    Path system = Repository.root().resolve("config/cessna/system.xml");

    CommandLineRun run =
        CommandLineRun.of(
            "run",
            system.toString(),
            "--logs",
            directory.resolve("logs").toString(),
            "--set",
            "CommunicationManager:BROKER=external",
            "--set",
            "CommunicationManager:COMMUNICATION MANAGER PORT=1");

    assertThat(run.exitCode()).isEqualTo(ExitCode.FAILED);
    assertThat(run.err())
        .startsWith("u2sa: no Communication Manager at tcp://localhost:1")
        .hasLineCount(1);
    assertThat(directory.resolve("logs")).doesNotExist();
    RunningThreads.requireNoneSince(before);
  }

  private void requireRefused(String expected, String... arguments) {
    Set<Thread> before = RunningThreads.now();

    CommandLineRun run = CommandLineRun.of(arguments);

    assertThat(run.exitCode()).as(run.err()).isEqualTo(ExitCode.BAD_INPUT);
    List<String> lines = run.err().lines().toList();
    assertThat(lines.get(0)).startsWith("u2sa: ").contains(expected);
    assertThat(lines.stream().skip(1)) // what was meant, and where help is
        .allMatch(line -> line.startsWith("Try '") || line.startsWith("Did you mean "));
    RunningThreads.requireNoneSince(before);
  }

  /** The Cessna's files in the test's own folder. */
  private void copyConfiguration() throws IOException {
    Path copy = Files.createDirectory(directory.resolve("cessna"));
    Path original = Repository.root().resolve("config/cessna");
    try (Stream<Path> files = Files.list(original)) {
      for (Path file : files.toList()) {
        Files.copy(file, copy.resolve(file.getFileName()));
      }
    }
    Path mission = Repository.root().resolve("missions/cessna/mission.xml");
    for (String name : List.of("MissionManager.xml", "Simulator.xml")) {
      Path file = copy.resolve(name);
      Files.writeString(
          file,
          Files.readString(file).replace("../../missions/cessna/mission.xml", mission.toString()));
    }
  }
}
