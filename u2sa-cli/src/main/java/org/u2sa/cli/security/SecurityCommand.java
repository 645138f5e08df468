package org.u2sa.cli.security;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.core.security.User;
import org.u2sa.core.security.UserFile;
import org.u2sa.interfaces.BadInputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/**
 * {@code u2sa security}: prints its help; init, certificate and mosquitto are subcommands,
 * implemented as methods.
 */
@Command(
    name = "security",
    description = {
      "Create certificates and users for a vehicle that is reached over a network.",
      "",
      "The commands write to one folder; set SECURITY DIRECTORY in CommunicationManager.xml to "
          + "it. See docs/security.md for the steps."
    },
    subcommands = UserCommand.class)
public final class SecurityCommand extends BaseCommand.Group {

  @Command(
      name = "init",
      description = "Create a local authority, a certificate of the broker and an empty user list.")
  Integer init(
      @Parameters(
              paramLabel = "DIR",
              defaultValue = "security",
              description = "New folder. Default: ${DEFAULT-VALUE}.")
          Path folder,
      @Option(
              names = "--host",
              paramLabel = "HOST",
              description =
                  "Name or address under which clients reach the broker; repeatable. localhost and this host's name are always included.")
          List<String> hosts)
      throws IOException, InterruptedException {
    SecurityDirectory directory = new SecurityDirectory(folder);
    if (Files.exists(directory.authority()) || Files.exists(directory.users())) {
      throw new BadInputException(
          folder + ": already contains an authority or users, which are not overwritten");
    }
    SecurityFolder.makePrivate(folder);
    LocalAuthority authority = LocalAuthority.create(directory);
    List<String> names = LocalAuthority.HostNames.with(hosts == null ? List.of() : hosts);
    authority.certify(names);
    UserFile.write(directory.users(), List.of());
    out()
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

  @Command(
      name = "certificate",
      description =
          "Renew the broker's key and certificate under the same authority; clients need no change.")
  Integer certificate(
      @Parameters(
              paramLabel = "HOST",
              arity = "1..*",
              description =
                  "Names or addresses under which clients reach the broker, in addition to "
                      + "localhost.")
          List<String> hosts,
      @Mixin SecurityFolder folder)
      throws IOException, InterruptedException {
    SecurityDirectory directory = folder.existing();
    List<String> names = LocalAuthority.HostNames.with(hosts);
    LocalAuthority.in(directory).certify(names);
    out()
        .printf(
            "%s: certificate for %s. Restart the broker to use it.%n",
            directory.certificate(), String.join(", ", names));
    return ExitCode.DONE;
  }

  @Command(
      name = "mosquitto",
      description =
          "Write configuration, users and access rights for Mosquitto, to replace the embedded "
              + "broker.")
  Integer mosquitto(
      @Parameters(
              paramLabel = "DIR",
              description = "Output folder for mosquitto.conf and the files it refers to.")
          Path target,
      @Option(
              names = "--port",
              paramLabel = "N",
              defaultValue = "8883",
              description = "TCP port. Default: ${DEFAULT-VALUE}.")
          int port,
      @Option(
              names = "--bind",
              paramLabel = "ADDRESS",
              defaultValue = "0.0.0.0",
              description = "Address to listen on. Default: ${DEFAULT-VALUE}.")
          String bind,
      @Mixin SecurityFolder folder)
      throws IOException {
    SecurityDirectory directory = folder.existing();
    directory.check();
    Collection<User> users = UserFile.read(directory.users()).values();
    SecurityFolder.makePrivate(target);
    MosquittoFiles.write(target.toAbsolutePath().normalize(), directory, users, bind, port);
    out()
        .printf(
            "%s: %d users. Start it with: mosquitto -c %s%n",
            target, users.size(), target.resolve("mosquitto.conf"));
    return ExitCode.DONE;
  }
}
