package org.u2sa.trials.campaign;

import java.util.List;
import org.u2sa.cli.command.CommandProvider;

/** Registers {@code u2sa campaign} with the command line. */
public final class CampaignCommands implements CommandProvider {
  @Override
  public List<Contribution> commands() {
    return List.of(new Contribution(Group.TOP_LEVEL, new CampaignCommand()));
  }
}
