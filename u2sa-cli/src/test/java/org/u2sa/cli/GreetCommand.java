package org.u2sa.cli;

import java.util.List;
import java.util.concurrent.Callable;
import org.u2sa.cli.command.CommandProvider;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** A command as a module would contribute it: a greeting that can fail in every way. */
@Command(name = "greet", description = "Greets by the seed.")
final class GreetCommand implements Callable<Integer> {

  /** Contributes the command, as a demo and at top level under another name. */
  public static final class Provider implements CommandProvider {
    @Override
    public List<Contribution> commands() {
      return List.of(
          new Contribution(Group.DEMO, new GreetCommand()),
          new Contribution(Group.TOP_LEVEL, new WaveCommand()));
    }
  }

  /** A top-level command. */
  @Command(name = "wave", description = "Waves.")
  static final class WaveCommand implements Runnable {
    @Override
    public void run() {
      throw new NoClassDefFoundError("org/example/Arm");
    }
  }

  @Spec private CommandSpec spec;

  @Option(names = "--fail", description = "How to fail.")
  private String fail = "";

  @Option(names = "--seed", paramLabel = "N", description = "Whom to greet.")
  private long seed = 1;

  @Override
  public Integer call() {
    switch (fail) {
      case "input" ->
          throw new BadInputException("mission.xml, line 3, <z>: \"high\" is not a number");
      case "run" -> throw new RunFailedException("FlightGear went away at 12.5 s");
      case "lie" ->
          throw new RunFailedException("refused: \u001b[2J\u009bx\nu2sa: cessna: armed\u202e");
      case "bug" -> throw new IllegalStateException("wing came off");
      default -> spec.commandLine().getOut().println("hello " + seed);
    }
    return ExitCode.DONE;
  }
}
