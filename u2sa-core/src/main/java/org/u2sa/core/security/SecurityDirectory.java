package org.u2sa.core.security;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.u2sa.interfaces.BadInputException;

/**
 * The folder in which all lies that a secured Communication Manager needs.
 *
 * @param path the folder
 */
public record SecurityDirectory(Path path) {
  /** Certificate of the local authority (PEM): what clients trust. */
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
   * Checks that all is there that the broker needs, and that keys and users are not for everyone.
   *
   * @throws BadInputException if something is missing or too open
   */
  public void check() {
    for (Path needed : new Path[] {certificate(), key(), users()}) {
      if (!Files.isRegularFile(needed)) {
        throw new BadInputException(
            "SECURITY DIRECTORY \""
                + path
                + "\": there is no "
                + needed.getFileName()
                + "; ./u2sa security init makes it");
      }
    }
    requireClosed();
  }

  /**
   * Checks that nobody but the owner may read keys and users, or put others in their place. The
   * authority's key, too, if it is here: whoever has it makes brokers that clients trust.
   *
   * @throws BadInputException if one is too open; says how to close it
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
