package org.u2sa.gcs.security;

import java.util.List;
import org.u2sa.gcs.command.CommandProvider;

/** Adds {@code u2sa security} to the command line. */
public final class SecurityCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.TOP_LEVEL, new SecurityCommand()));
  }
}
