package org.u2sa.cli;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.ServiceLoader;
import org.u2sa.cli.command.CommandProvider;
import org.u2sa.cli.command.CommandProvider.Contribution;
import org.u2sa.cli.command.CommandProvider.Group;
import org.u2sa.cli.safety.EmergencyStopCommand;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Spec;

/** Builds the command tree from the frame's own commands and those of the providers. */
final class CommandTree {
  private static final String URGENT = "estop";
  private static final int MAX_FAULTS = 100; // a broken list may never end

  private CommandTree() {}

  /**
   * Loads all providers on the class path; a broken one is reported on {@code err} and skipped, so
   * that one bad jar does not disable the other commands. For an emergency stop there is only that
   * command: nothing else may delay or prevent it.
   */
  static List<CommandProvider> discover(PrintWriter err, String... args) {
    if (args.length > 0 && args[0].equals(URGENT)) {
      return List.of(() -> List.of(new Contribution(Group.TOP_LEVEL, new EmergencyStopCommand())));
    }
    List<CommandProvider> found = new ArrayList<>();
    Iterator<CommandProvider> providers = ServiceLoader.load(CommandProvider.class).iterator();
    for (int faults = 0; faults < MAX_FAULTS; ) {
      try {
        if (!providers.hasNext()) {
          return found;
        }
        found.add(providers.next());
      } catch (Exception | Error e) { // whatever the extension's code throws
        faults++;
        report(e, err);
      }
    }
    return found;
  }

  private static void report(Throwable fault, PrintWriter err) {
    err.println(
        "u2sa: some commands are missing: "
            + ProviderFault.causeOf(fault).orElseGet(fault::toString));
  }

  /**
   * Creates the command line of the providers' commands, with the project's error handling.
   *
   * @param err receives what is wrong with a provider, whose commands are skipped
   */
  static CommandLine build(List<CommandProvider> providers, PrintWriter err, Help.Ansi ansi) {
    RootCommand root = new RootCommand();
    CommandLine line = new CommandLine(root);
    CommandLine demo = new CommandLine(new DemoCommand());
    line.addSubcommand(demo);
    for (CommandProvider provider : providers) {
      try {
        for (Contribution contribution : provider.commands()) {
          (contribution.group() == Group.DEMO ? demo : line).addSubcommand(contribution.command());
        }
      } catch (Exception | Error e) { // whatever the extension's code throws
        report(e, err);
      }
    }
    line.addSubcommand(new CompletionCommand());
    for (CommandLine command : line.getSubcommands().values()) {
      addHelp(command);
    }
    ErrorAnswers answers = new ErrorAnswers(root::debug);
    line.setParameterExceptionHandler(answers);
    line.setExecutionExceptionHandler(answers);
    line.setColorScheme(Help.defaultColorScheme(ansi));
    line.setCaseInsensitiveEnumValuesAllowed(true);
    line.setUsageHelpLongOptionsMaxWidth(30);
    return line;
  }

  /**
   * Adds {@code --help} to each command without it, so that authors of commands cannot forget it.
   */
  private static void addHelp(CommandLine command) {
    CommandSpec spec = command.getCommandSpec();
    if (spec.findOption("--help") == null) {
      spec.addOption(
          OptionSpec.builder("-h", "--help")
              .usageHelp(true)
              .type(boolean.class)
              .description("Show this help.")
              .build());
    }
    for (CommandLine child : command.getSubcommands().values()) {
      addHelp(child);
    }
  }

  /**
   * {@code u2sa demo}: lists the demos contributed by modules on the class path; each is a
   * subcommand.
   */
  @Command(
      name = "demo",
      description = "Run simulated vehicles on missions. Alone: list the demos.",
      synopsisSubcommandLabel = "[<demo> [<options>]]",
      commandListHeading = "%n@|bold DEMOS|@%n")
  private static final class DemoCommand implements Runnable {

    @Spec private CommandSpec spec;

    @Override
    public void run() {
      spec.commandLine().usage(spec.commandLine().getOut());
    }
  }
}
