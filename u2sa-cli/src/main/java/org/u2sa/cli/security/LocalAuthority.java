package org.u2sa.cli.security;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.u2sa.core.security.SecretFile;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.RunFailedException;

/**
 * A certificate authority for the hosts of one team: its certificate is trusted by clients, and its
 * key certifies brokers. Uses the JDK's keytool, because Java has no API for creating certificates.
 */
final class LocalAuthority {
  private static final String AUTHORITY_DAYS = "3650";
  private static final String BROKER_DAYS = "825"; // the maximum that Apple's clients accept
  private static final String ELLIPTIC = "-keyalg EC -groupname secp256r1";

  private final SecurityDirectory directory;

  private LocalAuthority(SecurityDirectory directory) {
    this.directory = directory;
  }

  /** Creates an authority in the folder, which must not contain one. */
  static LocalAuthority create(SecurityDirectory directory)
      throws IOException, InterruptedException {
    Keytool.run(
        "-genkeypair -alias ca -startdate -1d -validity " + AUTHORITY_DAYS + " " + ELLIPTIC,
        List.of(
            "-dname",
            "CN=U2SA local authority",
            "-ext",
            "bc:critical=ca:true,pathlen:0",
            "-ext",
            "ku:critical=keyCertSign,cRLSign"),
        directory.authorityKey());
    SecretFile.write(directory.authorityKey(), Files.readAllBytes(directory.authorityKey()));
    String certificate =
        Keytool.run("-exportcert -rfc -alias ca", List.of(), directory.authorityKey());
    Files.writeString(directory.authority(), certificate);
    return new LocalAuthority(directory);
  }

  /**
   * Loads the authority of the folder.
   *
   * @throws BadInputException if its key is missing
   */
  static LocalAuthority in(SecurityDirectory directory) {
    if (!Files.isRegularFile(directory.authorityKey())) {
      throw new BadInputException(
          directory.authorityKey()
              + ": no such file; create certificates on the host that has the authority's key");
    }
    return new LocalAuthority(directory);
  }

  /** Creates a new key for the broker and certifies it for the names and addresses. */
  void certify(List<String> hosts) throws IOException, InterruptedException {
    Path work = Files.createTempDirectory(directory.path(), "new"); // accessible to the owner only
    Path store = work.resolve("server.p12");
    Path request = work.resolve("request.pem");
    try {
      Keytool.run(
          "-genkeypair -alias server -validity " + BROKER_DAYS + " " + ELLIPTIC,
          List.of("-dname", "CN=U2SA broker"),
          store);
      Files.writeString(request, Keytool.run("-certreq -alias server", List.of(), store));
      String certificate =
          Keytool.run(
              "-gencert -rfc -alias ca -startdate -1d -validity " + BROKER_DAYS,
              List.of(
                  "-infile",
                  request.toString(),
                  "-ext",
                  HostNames.extension(hosts),
                  "-ext",
                  "ku:critical=digitalSignature",
                  "-ext",
                  "eku=serverAuth"),
              directory.authorityKey());
      SecretFile.write(directory.key(), keyOf(store).getBytes(StandardCharsets.US_ASCII));
      Files.writeString(
          directory.certificate(), certificate + Files.readString(directory.authority()));
    } finally {
      Files.deleteIfExists(request);
      Files.deleteIfExists(store);
      Files.delete(work);
    }
  }

  private static String keyOf(Path store) throws IOException {
    try {
      char[] password = Keytool.PASSWORD.toCharArray();
      byte[] key =
          KeyStore.getInstance(store.toFile(), password).getKey("server", password).getEncoded();
      return "-----BEGIN PRIVATE KEY-----\n"
          + Base64.getMimeEncoder(64, new byte[] {'\n'}).encodeToString(key)
          + "\n-----END PRIVATE KEY-----\n";
    } catch (GeneralSecurityException e) {
      throw new IOException(store + ": " + e.getMessage(), e);
    }
  }

  static final class Keytool {
    /**
     * Password of all key stores. It need not be secret, because the files are private to their
     * owner; keytool requires one.
     */
    static final String PASSWORD = "u2sa-local";

    private Keytool() {}

    /** Runs keytool on a PKCS #12 store; words are separated by spaces. Returns its output. */
    static String run(String words, List<String> more, Path store)
        throws IOException, InterruptedException {
      List<String> command = new ArrayList<>();
      command.add(Path.of(System.getProperty("java.home"), "bin", "keytool").toString());
      command.addAll(List.of("-J-XX:TieredStopAtLevel=1", "-J-XX:+UseSerialGC")); // faster startup
      command.addAll(List.of(words.split(" ")));
      command.addAll(more);
      command.addAll(
          List.of(
              "-storetype",
              "PKCS12",
              "-keystore",
              store.toString(),
              "-storepass:env",
              "U2SA_STORE"));
      ProcessBuilder builder = new ProcessBuilder(command);
      builder.environment().put("U2SA_STORE", PASSWORD);
      Process process = builder.redirectError(ProcessBuilder.Redirect.DISCARD).start();
      String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      if (process.waitFor() != 0) {
        throw new RunFailedException(
            "keytool " + words + " failed on " + store + ": " + printed.trim());
      }
      return printed;
    }
  }

  /** Names and addresses of a host for its certificate. */
  static final class HostNames {
    private static final Pattern NAME =
        Pattern.compile("[A-Za-z0-9]([A-Za-z0-9-]{0,62})(\\.[A-Za-z0-9][A-Za-z0-9-]{0,62})*");
    private static final Pattern IPV4 = Pattern.compile("\\d{1,3}(\\.\\d{1,3}){3}");

    private HostNames() {}

    /** The given names, in addition to those in every broker's certificate. */
    static List<String> with(List<String> given) {
      Set<String> names = new LinkedHashSet<>(List.of("localhost", "127.0.0.1", "::1"));
      ownName(names);
      names.addAll(given);
      names.forEach(HostNames::check);
      return new ArrayList<>(names);
    }

    private static void ownName(Set<String> names) {
      try {
        String own = InetAddress.getLocalHost().getHostName();
        if (NAME.matcher(own).matches()) {
          names.add(own);
        }
      } catch (UnknownHostException e) {
        return; // a host without a name is reachable only by the given names
      }
    }

    private static void check(String name) {
      if (!isAddress(name) && !NAME.matcher(name).matches()) {
        throw new BadInputException(
            "host \"" + name + "\": expected a name such as vehicle.local, or an IP address");
      }
    }

    private static boolean isAddress(String name) {
      return name.indexOf(':') >= 0 && name.matches("[0-9A-Fa-f:.]+")
          || IPV4.matcher(name).matches();
    }

    /** In the format of keytool's option: {@code san=dns:…,ip:…}. */
    static String extension(List<String> names) {
      List<String> parts = new ArrayList<>();
      names.forEach(name -> parts.add((isAddress(name) ? "ip:" : "dns:") + name));
      return "san=" + String.join(",", parts);
    }
  }
}
