package org.u2sa.gcs.security;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.gcs.command.ExitCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa security certificate}: a new certificate for the broker by the same authority. */
@Command(
    name = "certificate",
    description =
        "Renew the broker's key and certificate under the same authority; clients need no change.")
final class CertificateCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private SecurityFolder folder;

  @Parameters(
      paramLabel = "HOST",
      arity = "1..*",
      description = "Names or addresses under which clients reach the broker, beside localhost.")
  private List<String> hosts;

  @Override
  public Integer call() throws IOException, InterruptedException {
    SecurityDirectory directory = folder.existing();
    List<String> names = HostNames.with(hosts);
    LocalAuthority.in(directory).certify(names);
    Path certificate = directory.certificate();
    command
        .commandLine()
        .getOut()
        .printf(
            "%s: certificate for %s. Restart the broker to use it.%n",
            certificate, String.join(", ", names));
    return ExitCode.DONE;
  }
}
