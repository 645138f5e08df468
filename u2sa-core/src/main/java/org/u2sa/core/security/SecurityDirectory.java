package org.u2sa.core.security;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;

/**
 * The folder with the certificates, keys and users of a secured Communication Manager.
 *
 * @param path the folder
 */
public record SecurityDirectory(Path path) {
  /** Certificate of the local authority (PEM), the clients' trust anchor. */
  public Path authority() {
    return path.resolve("ca.pem");
  }

  /** The authority's key (PKCS #12), for further certificates; the vehicle does not need it. */
  public Path authorityKey() {
    return path.resolve("ca-key.p12");
  }

  /** Certificate of the broker and of the authority (PEM). */
  public Path certificate() {
    return path.resolve("server.pem");
  }

  /** The broker's key (PEM, PKCS #8, not encrypted). */
  public Path key() {
    return path.resolve("server-key.pem");
  }

  /** The users' file. */
  public Path users() {
    return path.resolve("users.txt");
  }

  /**
   * Checks that all files that the broker needs exist, and that keys and users are private.
   *
   * @throws BadInputException if something is missing or too open
   */
  public void check() {
    for (Path needed : new Path[] {certificate(), key(), users()}) {
      if (!Files.isRegularFile(needed)) {
        throw new BadInputException(
            String.format(
                "SECURITY DIRECTORY \"%s\": missing %s; create it with ./u2sa security init",
                path, needed.getFileName()));
      }
    }
    requireClosed();
  }

  /**
   * Checks that only the owner may read or replace keys and users, including the authority's key if
   * present: with it, anyone could set up a broker that clients trust.
   *
   * @throws BadInputException if permissions are too open; names the remedy
   */
  public void requireClosed() {
    refuse(SecretFile.tooOpenFolder(path));
    for (Path secret : new Path[] {key(), users(), authorityKey()}) {
      if (Files.exists(secret)) {
        refuse(SecretFile.tooOpen(secret));
      }
    }
  }

  private static void refuse(Optional<String> problem) {
    problem.ifPresent(
        what -> {
          throw new BadInputException(what);
        });
  }
}
