package org.u2sa.gcs.configuration;

import java.util.List;
import org.u2sa.gcs.command.CommandProvider;

/** Adds {@code u2sa config} to the command line. */
public final class ConfigurationCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.TOP_LEVEL, new ConfigCommand()));
  }
}
