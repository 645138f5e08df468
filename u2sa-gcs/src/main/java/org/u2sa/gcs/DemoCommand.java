package org.u2sa.gcs;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/**
 * {@code u2sa demo}: lists the demos that the modules on the class path contribute; each is a
 * sub-command of it.
 */
@Command(
    name = "demo",
    description = "Run simulated vehicles on missions. Alone: list the demos.",
    synopsisSubcommandLabel = "[<demo> [<options>]]",
    commandListHeading = "%n@|bold DEMOS|@%n")
final class DemoCommand implements Runnable {

  @Spec private CommandSpec spec;

  @Override
  public void run() {
    spec.commandLine().usage(spec.commandLine().getOut());
  }
}
