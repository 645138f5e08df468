package org.u2sa.gcs.security;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code u2sa security}: the parent of the commands about certificates and users. */
@Command(
    name = "security",
    description = {
      "Make certificates and users for a vehicle that is reached over a network.",
      "",
      "They write to one folder; SECURITY DIRECTORY in CommunicationManager.xml names it. docs/security.md has the steps."
    },
    subcommands = {
      InitCommand.class,
      CertificateCommand.class,
      UserCommand.class,
      MosquittoCommand.class
    })
public final class SecurityCommand implements Runnable {
  @Spec private CommandSpec command;

  @Override
  public void run() {
    command.commandLine().usage(command.commandLine().getOut());
  }
}
