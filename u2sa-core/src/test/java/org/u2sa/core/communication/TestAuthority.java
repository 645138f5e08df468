package org.u2sa.core.communication;

import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.SecureRandom;
import java.security.cert.CertificateFactory;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import javax.net.ssl.SSLContext;
import javax.net.ssl.TrustManagerFactory;
import org.u2sa.core.security.PasswordHash;
import org.u2sa.core.security.SecretFile;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.core.security.User;
import org.u2sa.core.security.UserFile;

/**
 * Makes the files of a secured broker with the JDK's keytool: a certificate that is its own
 * authority.
 */
public final class TestAuthority {
  private static final int FEW = 1_000; // iterations: a test need not resist anybody

  private TestAuthority() {}

  /** A folder with a certificate for localhost and no users. */
  public static SecurityDirectory in(Path folder)
      throws IOException, InterruptedException, GeneralSecurityException {
    Path store = folder.resolve("test.p12");
    Process keytool = new ProcessBuilder(arguments(store)).redirectErrorStream(true).start();
    String said = new String(keytool.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    if (keytool.waitFor() != 0) {
      throw new IOException("keytool: " + said);
    }
    KeyStore keys = KeyStore.getInstance(store.toFile(), "changeit".toCharArray());
    SecurityDirectory directory = new SecurityDirectory(folder);
    Files.writeString(
        directory.authority(), pem("CERTIFICATE", keys.getCertificate("test").getEncoded()));
    Files.copy(directory.authority(), directory.certificate());
    SecretFile.write(
        directory.key(),
        pem("PRIVATE KEY", keys.getKey("test", "changeit".toCharArray()).getEncoded())
            .getBytes(StandardCharsets.US_ASCII));
    UserFile.write(directory.users(), List.of());
    return directory;
  }

  /** Another folder with the same certificate, which takes less time than a new one. */
  static SecurityDirectory copy(SecurityDirectory from, Path folder) throws IOException {
    SecurityDirectory directory = new SecurityDirectory(folder);
    Files.copy(from.authority(), directory.authority());
    Files.copy(from.certificate(), directory.certificate());
    SecretFile.write(directory.key(), Files.readAllBytes(from.key()));
    UserFile.write(directory.users(), List.of());
    return directory;
  }

  /** A socket, not connected yet, that trusts this authority. */
  static Socket socket(SecurityDirectory directory) throws IOException, GeneralSecurityException {
    return trusting(directory).getSocketFactory().createSocket();
  }

  /** What a client needs that trusts this authority. */
  public static SSLContext trusting(SecurityDirectory directory)
      throws IOException, GeneralSecurityException {
    KeyStore trusted = KeyStore.getInstance(KeyStore.getDefaultType());
    trusted.load(null, null);
    try (InputStream in = Files.newInputStream(directory.authority())) {
      trusted.setCertificateEntry(
          "authority", CertificateFactory.getInstance("X.509").generateCertificate(in));
    }
    TrustManagerFactory managers =
        TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
    managers.init(trusted);
    SSLContext context = SSLContext.getInstance("TLS");
    context.init(null, managers.getTrustManagers(), null);
    return context;
  }

  private static List<String> arguments(Path store) {
    List<String> all = new ArrayList<>();
    all.add(Path.of(System.getProperty("java.home"), "bin", "keytool").toString());
    all.addAll(
        List.of(
            ("-J-XX:TieredStopAtLevel=1 -J-XX:+UseSerialGC -genkeypair -keyalg EC -groupname secp256r1 -alias test -dname CN=test -validity 2"
                    + " -ext san=dns:localhost,ip:127.0.0.1 -ext bc:c -storetype PKCS12"
                    + " -storepass changeit -keystore")
                .split(" ")));
    all.add(store.toString());
    return all;
  }

  private static String pem(String what, byte[] content) {
    return "-----BEGIN "
        + what
        + "-----\n"
        + Base64.getMimeEncoder(64, new byte[] {'\n'}).encodeToString(content)
        + "\n-----END "
        + what
        + "-----\n";
  }

  /** Adds a user whose password is the name, and writes that into {@code NAME.password}. */
  static void addUser(SecurityDirectory directory, String name, String roles, String system)
      throws IOException {
    List<User> users = new ArrayList<>(UserFile.read(directory.users()).values());
    PasswordHash hash = PasswordHash.of(name.toCharArray(), new SecureRandom(), FEW);
    users.add(new User(name, User.rolesOf(roles), List.of(system), hash));
    UserFile.write(directory.users(), users);
    SecretFile.write(
        directory.path().resolve(name + ".password"),
        (name + "\n").getBytes(StandardCharsets.UTF_8));
  }
}
