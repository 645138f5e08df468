package org.u2sa.core.security;

import java.security.GeneralSecurityException;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Arrays;
import java.util.Base64;
import javax.crypto.SecretKeyFactory;
import javax.crypto.spec.PBEKeySpec;

/**
 * A stored password: PBKDF2 with HMAC-SHA-512, salted so that equal passwords cannot be recognised.
 * Each guess against a stolen file costs as much time as a log-in.
 *
 * @param iterations number of iterations
 * @param salt random salt, different for each user
 * @param hash 64 bytes
 */
public record PasswordHash(int iterations, byte[] salt, byte[] hash) {
  /** OWASP's recommended iterations for PBKDF2-HMAC-SHA512 (Password Storage Cheat Sheet, 2023). */
  public static final int ITERATIONS = 210_000;

  private static final String NAME = "pbkdf2-sha512";
  private static final String ALGORITHM = "PBKDF2WithHmacSHA512";
  private static final int MAX_ITERATIONS = 10_000_000;
  private static final int SALT_BYTES = 12; // Mosquitto accepts no other length
  private static final int HASH_BYTES = 64;
  private static final int PARTS = 4;

  public PasswordHash {
    salt = salt.clone();
    hash = hash.clone();
  }

  @Override
  public byte[] salt() {
    return salt.clone();
  }

  @Override
  public byte[] hash() {
    return hash.clone();
  }

  /** Hashes a new password with a new salt. */
  public static PasswordHash of(char[] password, SecureRandom random) {
    return of(password, random, ITERATIONS);
  }

  /** Like {@link #of(char[], SecureRandom)}, with a given number of iterations. */
  public static PasswordHash of(char[] password, SecureRandom random, int iterations) {
    byte[] salt = new byte[SALT_BYTES];
    random.nextBytes(salt);
    return new PasswordHash(iterations, salt, derive(password, salt, iterations));
  }

  /** A hash that no password matches; checking against it takes as long as against any other. */
  public static PasswordHash unguessable(SecureRandom random) {
    byte[] salt = new byte[SALT_BYTES];
    byte[] hash = new byte[HASH_BYTES];
    random.nextBytes(salt);
    random.nextBytes(hash);
    return new PasswordHash(ITERATIONS, salt, hash);
  }

  /** Whether the password matches, in constant time. */
  public boolean matches(char[] password) {
    return MessageDigest.isEqual(hash, derive(password, salt, iterations));
  }

  private static byte[] derive(char[] password, byte[] salt, int iterations) {
    PBEKeySpec spec = new PBEKeySpec(password, salt, iterations, HASH_BYTES * Byte.SIZE);
    try {
      return SecretKeyFactory.getInstance(ALGORITHM).generateSecret(spec).getEncoded();
    } catch (GeneralSecurityException e) {
      throw new IllegalStateException("this Java has no " + ALGORITHM, e);
    } finally {
      spec.clearPassword();
    }
  }

  /** Parses the format of {@link #toString}; throws IllegalArgumentException for any other. */
  static PasswordHash parse(String text) {
    String[] parts = text.split("\\$", -1);
    if (parts.length != PARTS || !parts[0].equals(NAME)) {
      throw new IllegalArgumentException("expected " + NAME + "$iterations$salt$hash");
    }
    int iterations = Integer.parseInt(parts[1]);
    byte[] salt = Base64.getDecoder().decode(parts[2]);
    byte[] hash = Base64.getDecoder().decode(parts[3]);
    if (iterations < 1 || iterations > MAX_ITERATIONS || hash.length != HASH_BYTES) {
      throw new IllegalArgumentException(
          "expected 1…" + MAX_ITERATIONS + " iterations and a hash of " + HASH_BYTES + " bytes");
    }
    return new PasswordHash(iterations, salt, hash);
  }

  /** Format of Mosquitto's password file: {@code $7$iterations$salt$hash}. */
  public String forMosquitto() {
    Base64.Encoder base64 = Base64.getEncoder();
    return String.format(
        "$7$%s$%s$%s", iterations, base64.encodeToString(salt), base64.encodeToString(hash));
  }

  /** Compares contents, so that parsing a line twice gives equal users. */
  @Override
  public boolean equals(Object other) {
    return other instanceof PasswordHash hashed
        && iterations == hashed.iterations
        && Arrays.equals(salt, hashed.salt)
        && Arrays.equals(hash, hashed.hash);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(hash);
  }

  /** Format of the users' file. */
  @Override
  public String toString() {
    return NAME + forMosquitto().substring(2);
  }
}
