package org.u2sa.cli;

import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import picocli.AutoComplete;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/**
 * {@code u2sa completion}: prints the shell script that completes commands, options and their
 * values.
 */
@Command(
    name = "completion",
    description = {
      "Print the shell script that completes u2sa's commands, options and values.",
      "",
      "  source <(./u2sa completion bash)     in bash, for ./u2sa and u2sa; permanently in ~/.bashrc",
      "  source <(./u2sa completion zsh)      in zsh, after autoload -Uz compinit && compinit"
    })
final class CompletionCommand extends BaseCommand {
  enum Shell {
    BASH,
    /** zsh, using bash's completion. */
    ZSH
  }

  @Parameters(paramLabel = "SHELL", description = "One of ${COMPLETION-CANDIDATES}.")
  private Shell shell;

  @Override
  public Integer call() {
    CommandLine root = commandLine().getParent();
    String script = AutoComplete.bash(root.getCommandName(), root);
    if (shell == Shell.ZSH) {
      root.getOut().println("autoload -U +X bashcompinit && bashcompinit");
    }
    script.lines().forEach(root.getOut()::println);
    return ExitCode.DONE;
  }
}
