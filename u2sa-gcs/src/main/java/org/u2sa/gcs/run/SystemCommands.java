package org.u2sa.gcs.run;

import java.util.List;
import org.u2sa.gcs.command.CommandProvider;

/** Adds {@code u2sa run} to the command line. */
public final class SystemCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.TOP_LEVEL, new RunCommand()));
  }
}
