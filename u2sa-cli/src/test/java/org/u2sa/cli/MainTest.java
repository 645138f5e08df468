package org.u2sa.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.cli.command.CommandProvider;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.cli.safety.EmergencyStopCommand;
import org.u2sa.cli.terminal.PlainLines;
import picocli.CommandLine.Help;

class MainTest {

  @TempDir private Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... args) {
    List<CommandProvider> providers = CommandTree.discover(new PrintWriter(err), args);
    return Main.run(
        providers,
        new PlainLines(new PrintWriter(out)),
        new PlainLines(new PrintWriter(err)),
        Help.Ansi.OFF,
        args);
  }

  @Test
  void run_help_teachesTheFirstCommandAndExitCodes() {
    assertThat(run("--help")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString())
        .contains("./u2sa demo cessna", "START HERE", "EXIT CODES", "bad input", "wave", "Waves.");
    assertThat(err.toString()).isEmpty();
  }

  @Test
  void run_help_fitsEightyColumnsAsWritten() {
    run("--help");
    assertThat(out.toString().lines())
        .allSatisfy(line -> assertThat(line.length()).isLessThanOrEqualTo(80));
    assertThat(out.toString()).contains("flies\n                            ten waypoints");
  }

  @Test
  void run_nothing_printsTheHelp() {
    assertThat(run()).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("START HERE");
  }

  @Test
  void run_version_tellsTheBuiltVersion() {
    assertThat(run("--version")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).matches("(?s)u2sa \\d+\\.\\d+\\S*\\R.*Java .*");
  }

  @Test
  void run_demoAlone_listsTheDemos() {
    assertThat(run("demo")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("DEMOS", "greet  Greets by the seed.");
  }

  @Test
  void run_contributedDemo_getsItsOptions() {
    assertThat(run("demo", "greet", "--seed", "42")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).isEqualToIgnoringNewLines("hello 42");
  }

  @Test
  void run_helpOfContributedDemo_needsNothingFromItsAuthor() {
    assertThat(run("demo", "greet", "--help")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).contains("--seed=N", "--help", "--debug");
  }

  private int runWith(CommandProvider... providers) {
    List<CommandProvider> all = new ArrayList<>(CommandTree.discover(new PrintWriter(err)));
    all.addAll(0, List.of(providers));
    return Main.run(
        all,
        new PlainLines(new PrintWriter(out)),
        new PlainLines(new PrintWriter(err)),
        Help.Ansi.OFF,
        "demo",
        "greet",
        "--seed",
        "42");
  }

  static List<CommandProvider> brokenProviders() {
    return List.of(
        () -> {
          throw new NoClassDefFoundError("org/example/Library");
        },
        () -> {
          throw new IllegalStateException("no licence");
        },
        () -> null,
        () -> List.of(new CommandProvider.Contribution(CommandProvider.Group.DEMO, "no command")));
  }

  @ParameterizedTest
  @MethodSource("brokenProviders")
  void run_providerOfAnotherJarThrows_itsCommandsAreMissingAndTheOthersWork(
      CommandProvider broken) {
    assertThat(runWith(broken)).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).isEqualToIgnoringNewLines("hello 42");
    assertThat(err.toString().lines()).singleElement().asString().contains("commands are missing");
  }

  @Test
  void discover_classForANewerJava_isReportedAndTheOthersAreFound() throws IOException {
    assertThat(withANewerClass()).extracting(each -> each.getClass().getSimpleName()).isNotEmpty();
    assertThat(err.toString()).contains("commands are missing", "UnsupportedClassVersionError");
  }

  @Test
  void discover_emergencyStop_asksNobodyElse() throws IOException {
    List<CommandProvider> found = withANewerClass("estop", "--reason", "smoke");

    assertThat(found).singleElement();
    assertThat(found.get(0).commands())
        .singleElement()
        .satisfies(only -> assertThat(only.command()).isInstanceOf(EmergencyStopCommand.class));
    assertThat(err.toString()).isEmpty();
  }

  /** What is found if the class path also has a provider that was compiled for a newer Java. */
  private List<CommandProvider> withANewerClass(String... args) throws IOException {
    Path list = folder.resolve("META-INF/services/" + CommandProvider.class.getName());
    Files.createDirectories(list.getParent());
    Files.writeString(list, "Newer\n");
    Files.write(folder.resolve("Newer.class"), new byte[] {-54, -2, -70, -66, 0, 0, 1, 0, 0, 0});
    Thread thread = Thread.currentThread();
    ClassLoader before = thread.getContextClassLoader();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {folder.toUri().toURL()}, before)) {
      thread.setContextClassLoader(loader);
      return CommandTree.discover(new PrintWriter(err, true), args);
    } finally {
      thread.setContextClassLoader(before);
    }
  }

  @Test
  void run_unknownCommand_suggestsAndIsBadInput() {
    assertThat(run("dmeo")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString())
        .contains("u2sa: ", "unknown command 'dmeo'", "Did you mean demo?", "Try 'u2sa --help'.");
    assertThat(out.toString()).isEmpty();
  }

  @Test
  void run_unknownDemo_suggestsTheDemo() {
    assertThat(run("demo", "gret")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString())
        .contains("unknown command 'gret'", "Did you mean greet?", "Try 'u2sa demo --help'.");
  }

  @Test
  void run_unknownOption_suggestsTheOption() {
    assertThat(run("demo", "greet", "--sede=1")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("unknown option '--sede=1'", "Did you mean --seed?");
  }

  @Test
  void run_seedThatIsNoNumber_namesOptionAndValue() {
    assertThat(run("demo", "greet", "--seed", "many")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("--seed", "many");
  }

  @Test
  void run_badInput_printsItsMessageAlone() {
    assertThat(run("demo", "greet", "--fail", "input")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString())
        .isEqualToIgnoringNewLines("u2sa: mission.xml, line 3, <z>: \"high\" is not a number");
  }

  @Test
  void run_failedRun_printsItsMessageAlone() {
    assertThat(run("demo", "greet", "--fail", "run")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString()).isEqualToIgnoringNewLines("u2sa: FlightGear went away at 12.5 s");
  }

  @Test
  void run_wordsOfOthersWithControlCharacters_stayOneLineAndCommandNoTerminal() {
    assertThat(run("demo", "greet", "--fail", "lie")).isEqualTo(ExitCode.FAILED);
    assertThat(err)
        .hasToString("u2sa: refused:  [2J x u2sa: cessna: armed " + System.lineSeparator());
  }

  @Test
  void run_unexpectedException_isOneLineWithoutDebug() {
    assertThat(run("demo", "greet", "--fail", "bug")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString().lines())
        .singleElement()
        .asString()
        .contains("IllegalStateException: wing came off", "--debug");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"report", "view", "replay", "export --format csv", "log", "replay --rerun all"})
  void run_fileOfMagicBytesAlone_isBadInputAndSaysWhatToDo(String command, @TempDir Path folder)
      throws IOException {
    Path file = folder.resolve("magic.mcap");
    Files.write(file, new byte[] {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'});
    List<String> arguments = new ArrayList<>(List.of(command.split(" ")));
    arguments.add(1, file.toString());
    assertThat(run(arguments.toArray(String[]::new))).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString())
        .isEqualToIgnoringNewLines(
            "u2sa: "
                + file
                + ": the file has 8 bytes: too few for an MCAP footer; recover it first");
  }

  @Test
  void run_unexpectedExceptionWithDebug_hasAStackTrace() {
    assertThat(run("--debug", "demo", "greet", "--fail", "bug")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString()).contains("at org.u2sa.cli.GreetCommand");
    assertThat(run("demo", "greet", "--fail", "bug", "--debug")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString().lines().filter(line -> line.startsWith("u2sa: "))).hasSize(2);
    assertThat(err.toString()).doesNotContain("--debug"); // heeded before and after the command
  }

  @Test
  void run_brokenInstallation_isOneLineToo() {
    assertThat(run("wave")).isEqualTo(ExitCode.FAILED);
    assertThat(err.toString().lines())
        .singleElement()
        .asString()
        .contains("NoClassDefFoundError: org/example/Arm");
  }
}
