package org.u2sa.cli.security;

import java.io.Console;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.u2sa.cli.command.BaseCommand;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.core.security.AccessRole;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.SecretFile;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.core.security.User;
import org.u2sa.core.security.UserFile;
import org.u2sa.interfaces.BadInputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code u2sa security user}: adds, lists and removes users of the broker. */
@Command(name = "user", description = "Add, list and remove users of the broker.")
final class UserCommand extends BaseCommand.Group {

  @Command(
      name = "add",
      description = {
        "Add a user, or give one a new password, role and systems.",
        "",
        "Without --password-file or --new-password-file, prompts for the password."
      })
  Integer add(
      @Parameters(paramLabel = "NAME", description = "Name of the user.") String name,
      @Option(
              names = "--role",
              paramLabel = "ROLE",
              required = true,
              split = ",",
              description =
                  "Roles, separated by commas: service, control, launcher, monitor, safety, operator, observer.")
          List<String> roles,
      @Option(
              names = "--system",
              paramLabel = "ID",
              split = ",",
              description = "Systems the user may access; default: all on the broker.")
          List<String> systems,
      @Option(
              names = "--password-file",
              paramLabel = "FILE",
              description = "Read the password from the file's first line.")
          Path passwordFile,
      @Option(
              names = "--new-password-file",
              paramLabel = "FILE",
              description = "Generate a random password and write it to this new file.")
          Path newPasswordFile,
      @Mixin SecurityFolder folder)
      throws IOException {
    SecurityDirectory directory = folder.existing();
    char[] password =
        newPasswordFile != null
            ? Passwords.make(newPasswordFile)
            : passwordFile != null ? Passwords.read(passwordFile) : Passwords.ask(name);
    User user = user(name, roles, systems, password);
    Map<String, User> users = new TreeMap<>(UserFile.read(directory.users()));
    boolean known = users.put(name, user) != null;
    UserFile.write(directory.users(), users.values());
    if (newPasswordFile != null) {
      SecretFile.write(
          newPasswordFile, (new String(password) + "\n").getBytes(StandardCharsets.UTF_8));
    }
    out()
        .printf(
            "%s user %s: %s in %s.%n",
            known ? "Changed" : "Added",
            name,
            user.rolesText(),
            user.systems().contains(User.EVERY_SYSTEM)
                ? "every system"
                : String.join(", ", user.systems()));
    return ExitCode.DONE;
  }

  private static User user(String name, List<String> roles, List<String> systems, char[] password) {
    try {
      Set<AccessRole> checked = User.rolesOf(String.join(",", roles));
      return new User(
          name,
          checked,
          systems == null ? List.of(User.EVERY_SYSTEM) : systems,
          PasswordHash.of(password, new SecureRandom()));
    } catch (IllegalArgumentException e) {
      throw new BadInputException(e.getMessage(), e);
    }
  }

  @Command(name = "list", description = "List the users.")
  Integer list(@Mixin SecurityFolder folder) {
    Map<String, User> users = UserFile.read(folder.existing().users());
    if (users.isEmpty()) {
      print("No users yet: ./u2sa security user add NAME --role ROLE");
    }
    for (User user : users.values()) {
      out()
          .printf(
              "%-20s %-30s %s%n", user.name(), user.rolesText(), String.join(",", user.systems()));
    }
    return ExitCode.DONE;
  }

  @Command(
      name = "remove",
      description = "Remove a user; a running broker disconnects it within two seconds.")
  Integer remove(
      @Parameters(paramLabel = "NAME", description = "Name of the user.") String name,
      @Mixin SecurityFolder folder) {
    SecurityDirectory directory = folder.existing();
    Map<String, User> users = new TreeMap<>(UserFile.read(directory.users()));
    if (users.remove(name) == null) {
      throw new BadInputException(
          "user \"" + name + "\" does not exist; expected one of " + users.keySet());
    }
    UserFile.write(directory.users(), users.values());
    out().printf("Removed user %s.%n", name);
    return ExitCode.DONE;
  }

  /** Sources of a user's password: never the command line, which is visible to every process. */
  private static final class Passwords {
    private static final int SHORTEST = 10;
    private static final int RANDOM_BYTES = 24;

    private Passwords() {}

    static char[] read(Path file) {
      requireClosed("--password-file", file);
      try {
        List<String> lines = Files.readAllLines(file, StandardCharsets.UTF_8);
        return checked(lines.isEmpty() ? new char[0] : lines.get(0).toCharArray(), file.toString());
      } catch (IOException e) {
        throw new BadInputException("--password-file " + file + ": cannot be read: " + e, e);
      }
    }

    private static void requireClosed(String option, Path file) {
      if (Files.exists(file) && !Files.isRegularFile(file)) {
        throw new BadInputException(option + " " + file + ": is not a regular file");
      }
      if (Files.exists(file)) {
        SecretFile.tooOpen(file)
            .ifPresent(
                what -> {
                  throw new BadInputException(option + " " + what);
                });
      }
    }

    static char[] make(Path newFile) {
      if (Files.exists(newFile)) {
        throw new BadInputException(
            "--new-password-file " + newFile + ": already exists and is not overwritten");
      }
      byte[] random = new byte[RANDOM_BYTES];
      new SecureRandom().nextBytes(random);
      return Base64.getUrlEncoder().encodeToString(random).toCharArray();
    }

    /** Prompts on the terminal, twice. */
    static char[] ask(String name) {
      Console console = System.console();
      if (console == null) {
        throw new BadInputException(
            "no terminal to ask for a password: use --password-file or --new-password-file");
      }
      char[] first = console.readPassword("Password of %s: ", name);
      char[] again = console.readPassword("Again: ");
      if (first == null || !Arrays.equals(first, again)) {
        throw new BadInputException("the two passwords differ; no change made");
      }
      return checked(first, "the password");
    }

    private static char[] checked(char[] password, String where) {
      if (password.length < SHORTEST) {
        throw new BadInputException(
            where + ": " + password.length + " characters; expected " + SHORTEST + " or more");
      }
      return password;
    }
  }
}
