package org.u2sa.gcs.template;

import java.nio.file.Path;
import java.util.List;
import org.u2sa.gcs.command.CommandProvider;

/** Adds {@code u2sa new} to the command line. */
public final class TemplateCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.TOP_LEVEL, new NewCommand(Path.of(""))));
  }
}
