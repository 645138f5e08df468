package org.u2sa.gcs.security;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.core.security.UserFile;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.interfaces.BadInputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * {@code u2sa security init}: a local authority, the broker's certificate, and an empty list of
 * users.
 */
@Command(
    name = "init",
    description = "Make a local authority, the broker's certificate and an empty list of users.")
final class InitCommand implements Callable<Integer> {
  @Spec private CommandSpec command;

  @Parameters(
      paramLabel = "DIR",
      defaultValue = "security",
      description = "New folder. Default: ${DEFAULT-VALUE}.")
  private Path folder;

  @Option(
      names = "--host",
      paramLabel = "HOST",
      description =
          "Name or address under which clients reach the broker; several times for several. localhost and this host's name are always there.")
  private List<String> hosts = List.of();

  @Override
  public Integer call() throws IOException, InterruptedException {
    SecurityDirectory directory = new SecurityDirectory(folder);
    if (Files.exists(directory.authority()) || Files.exists(directory.users())) {
      throw new BadInputException(
          folder + ": holds an authority or users already; they are not overwritten");
    }
    SecurityFolder.makePrivate(folder);
    LocalAuthority authority = LocalAuthority.create(directory);
    List<String> names = HostNames.with(hosts);
    authority.certify(names);
    UserFile.write(directory.users(), List.of());
    command
        .commandLine()
        .getOut()
        .printf(
            "%s: authority and certificate for %s.%nNext: ./u2sa security user add NAME --role ROLE --dir %s;"
                + " give clients %s, and keep %s off the vehicle.%n",
            folder,
            String.join(", ", names),
            folder,
            directory.authority(),
            directory.authorityKey());
    return ExitCode.DONE;
  }
}
