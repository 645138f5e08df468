package org.u2sa.cli;

import org.u2sa.cli.command.ProgramVersion;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.Spec;

/** The command {@code u2sa} itself: without arguments it prints the help, where newcomers start. */
@Command(
    name = "u2sa",
    versionProvider = RootCommand.Version.class,
    sortOptions = false,
    synopsisHeading = "%n@|bold USAGE|@%n  ",
    customSynopsis = "u2sa [--debug] <command> [<options>]",
    header = {
      "@|bold U2SA|@ - one architecture for unmanned vehicles on the ground, on and under water, and in the air.",
    },
    description = {
      "",
      "A vehicle is a set of services (sensors, state estimator, mission manager, path planner, control system, actuators) that know only"
          + " the messages they exchange. XML files define which services run and how they are configured.",
      "",
      "@|bold START HERE|@",
      "  ./u2sa demo cessna        a Cessna 172 takes off by itself and flies",
      "                            ten waypoints, in the built-in simulator",
      "",
      "@|bold THEN TRY|@",
      "  ./u2sa demo                               list the demos",
      "  ./u2sa demo cessna --seed 7               different wind and gusts",
      "  ./u2sa demo cessna --realtime             watch it in real time",
      "  ./u2sa demo cessna --mission my.xml       your own waypoints",
      "  ./u2sa demo cessna --json | jq .          the result for a program",
      "  ./u2sa new sensor barometer               a project with your own sensor",
      "  ./u2sa apk                                assemble the Android application",
      "  ./u2sa <command> --help                   help on one command",
      "",
      "A run writes a picture of its track (SVG, PNG), KML, CSV, summary.json and logs to out/<run>/.",
    },
    optionListHeading = "%n@|bold OPTIONS|@%n",
    commandListHeading = "%n@|bold COMMANDS|@%n",
    exitCodeListHeading = "%n@|bold EXIT CODES|@%n",
    exitCodeList = {
      "0:done; for a mission, every goal was reached",
      "1:the run failed: a goal was missed, or something unexpected happened",
      "2:bad input: unknown command or option, faulty configuration or mission; nothing was started"
    })
final class RootCommand implements Runnable {

  @Spec private CommandSpec spec;

  @Option(
      names = {"-h", "--help"},
      usageHelp = true,
      description = "Show this help; after a command, the help of that command.")
  private boolean help;

  @Option(
      names = {"-V", "--version"},
      versionHelp = true,
      description = "Show the versions of U2SA and Java.")
  private boolean version;

  @Option(
      names = "--debug",
      scope = ScopeType.INHERIT,
      description = "Show the stack trace of an unexpected error.")
  private boolean debug;

  @Override
  public void run() {
    spec.commandLine().usage(spec.commandLine().getOut());
  }

  boolean debug() {
    return debug;
  }

  static final class Version implements IVersionProvider {
    @Override
    public String[] getVersion() {
      return new String[] {
        "u2sa " + ProgramVersion.text(),
        String.format(
            "Java %s (%s), picocli %s",
            System.getProperty("java.version"),
            System.getProperty("java.vm.name"),
            CommandLine.VERSION)
      };
    }
  }
}
