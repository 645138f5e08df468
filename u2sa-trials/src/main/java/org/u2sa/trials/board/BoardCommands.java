package org.u2sa.trials.board;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;

/** Registers {@code board} with the command line. */
public final class BoardCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.TOP_LEVEL, new BoardCommand()));
  }
}
