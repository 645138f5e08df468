package org.u2sa.interfaces.mqtt;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.u2sa.interfaces.BadInputException;

/**
 * Folders in which programs of one account share files: {@code $XDG_RUNTIME_DIR/u2sa} and {@code
 * ~/.u2sa/run}. Files are written to and searched for in both, because the variable differs between
 * sessions of one account, and its folder is removed with the last session. {@value #VARIABLE}
 * names one folder that replaces both: for tests, and for accounts shared by several separate
 * users.
 */
public final class AccountFolders {
  /** Environment variable: absolute path of the folder that replaces the usual ones. */
  public static final String VARIABLE = "U2SA_ACCOUNT_FOLDER";

  private static final String UNKNOWN = "?"; // the JVM's name of an account without an entry
  private static final Path SELF = Paths.get("/proc/self");

  private final String runtime;
  private final String home;
  private final String only; // replaces both; empty if unset

  /**
   * @param runtime value of {@code XDG_RUNTIME_DIR}; empty if unset
   */
  public AccountFolders(String runtime, String home) {
    this(runtime, home, "");
  }

  private AccountFolders(String runtime, String home, String only) {
    this.runtime = runtime;
    this.home = home;
    this.only = only;
  }

  /**
   * @throws BadInputException if {@value #VARIABLE} is not an absolute path
   */
  public static AccountFolders ofProcess() {
    return of(System.getenv(), System.getProperty("user.home", ""));
  }

  static AccountFolders of(Map<String, String> environment, String home) {
    String only = environment.getOrDefault(VARIABLE, "");
    if (!only.isEmpty() && !Paths.get(only).isAbsolute()) {
      throw new BadInputException(
          VARIABLE
              + ": \""
              + only
              + "\" is not an absolute path; programs that start in different"
              + " folders would not find each other's files");
    }
    return new AccountFolders(environment.getOrDefault("XDG_RUNTIME_DIR", ""), home, only);
  }

  /**
   * The folders, existing or not; {@code XDG_RUNTIME_DIR} only if no other account can replace its
   * content.
   */
  public List<Path> all() {
    List<Path> all = new ArrayList<>();
    if (!only.isEmpty()) {
      all.add(Paths.get(only));
      return all;
    }
    if (!runtime.isEmpty() && isPrivate(Paths.get(runtime))) {
      all.add(Paths.get(runtime, "u2sa"));
    }
    all.add(Paths.get(home, ".u2sa", "run"));
    return all;
  }

  /** The existing folders that only this account can write. */
  public List<Path> readable() {
    List<Path> readable = new ArrayList<>();
    for (Path folder : all()) {
      if (isPrivate(folder)) {
        readable.add(folder);
      }
    }
    return readable;
  }

  /**
   * Creates the folder if absent, with access for its owner only.
   *
   * @throws IOException on failure, or if it is a link or belongs to another account
   */
  public static void prepare(Path folder) throws IOException {
    if (!Files.exists(folder, LinkOption.NOFOLLOW_LINKS)) {
      Files.createDirectories(folder.toAbsolutePath().getParent());
      if (isPosix(folder)) {
        Files.createDirectory(
            folder,
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
      } else {
        Files.createDirectory(folder);
      }
    }
    if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
      throw new IOException(folder + " is not a folder");
    }
    if (!isOurs(folder)) {
      throw new IOException(folder + " belongs to another account");
    }
    if (isPosix(folder)) {
      Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwx------"));
    }
  }

  private static boolean isPrivate(Path folder) {
    try {
      if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS) || !isOurs(folder)) {
        return false;
      }
      if (!isPosix(folder)) {
        return true; // non-POSIX permissions, not visible to Java
      }
      Set<PosixFilePermission> others =
          EnumSet.of(PosixFilePermission.GROUP_WRITE, PosixFilePermission.OTHERS_WRITE);
      others.retainAll(Files.getPosixFilePermissions(folder, LinkOption.NOFOLLOW_LINKS));
      return others.isEmpty();
    } catch (IOException e) {
      return false; // removed in the meantime, or not accessible
    }
  }

  private static boolean isOurs(Path folder) throws IOException {
    if (!isPosix(folder)) {
      return true; // there, the owner of a created file may be a group
    }
    String account = System.getProperty("user.name", UNKNOWN);
    if (account.equals(UNKNOWN) && Files.exists(SELF)) {
      account = Files.getOwner(SELF).getName();
    }
    return Files.getOwner(folder, LinkOption.NOFOLLOW_LINKS).getName().equals(account);
  }

  private static boolean isPosix(Path folder) {
    return folder.getFileSystem().supportedFileAttributeViews().contains("posix");
  }
}
