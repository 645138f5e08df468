package org.u2sa.gcs.security;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Collection;
import java.util.concurrent.Callable;
import org.u2sa.core.security.SecretFile;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.core.security.User;
import org.u2sa.core.security.UserFile;
import org.u2sa.gcs.command.ExitCode;
import org.u2sa.messages.schema.MessageTypes;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code u2sa security mosquitto}: the same users and roles for Mosquitto. */
@Command(
    name = "mosquitto",
    description =
        "Write configuration, users and their rights for Mosquitto in place of the embedded broker.")
final class MosquittoCommand implements Callable<Integer> {
  @Spec private CommandSpec command;
  @Mixin private SecurityFolder folder;

  @Parameters(
      paramLabel = "DIR",
      description = "Where mosquitto.conf and the files that it names go.")
  private Path target;

  @Option(
      names = "--port",
      paramLabel = "N",
      defaultValue = "8883",
      description = "TCP port. Default: ${DEFAULT-VALUE}.")
  private int port;

  @Option(
      names = "--bind",
      paramLabel = "ADDRESS",
      defaultValue = "0.0.0.0",
      description = "Address on which it listens. Default: ${DEFAULT-VALUE}.")
  private String bind;

  @Override
  public Integer call() throws IOException {
    SecurityDirectory directory = folder.existing();
    directory.check();
    Collection<User> users = UserFile.read(directory.users()).values();
    SecurityFolder.makePrivate(target);
    Path at = target.toAbsolutePath().normalize();
    Files.copy(
        directory.certificate(), at.resolve("server.pem"), StandardCopyOption.REPLACE_EXISTING);
    SecretFile.write(at.resolve("server-key.pem"), Files.readAllBytes(directory.key()));
    write(at.resolve("passwords"), MosquittoFiles.passwords(users));
    write(at.resolve("acl"), MosquittoFiles.rights(users, MessageTypes.discovered()));
    write(at.resolve("mosquitto.conf"), MosquittoFiles.configuration(at, bind, port));
    command
        .commandLine()
        .getOut()
        .printf(
            "%s: %d users. Start it with: mosquitto -c %s%n",
            target, users.size(), target.resolve("mosquitto.conf"));
    return ExitCode.DONE;
  }

  private static void write(Path file, String text) {
    SecretFile.write(file, text.getBytes(StandardCharsets.UTF_8));
  }
}
