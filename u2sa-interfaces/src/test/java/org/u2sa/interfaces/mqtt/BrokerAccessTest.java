package org.u2sa.interfaces.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.KeyStore;
import java.util.Base64;
import java.util.Map;
import javax.net.ssl.SSLSocket;
import javax.net.ssl.TrustManagerFactory;
import javax.net.ssl.X509TrustManager;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.XmlConfiguration;

/** As whom and how a client comes to a broker, from its configuration. */
class BrokerAccessTest {
  @TempDir Path folder;

  private String passwordFile(String text) throws IOException {
    Path file = Files.write(folder.resolve("password"), text.getBytes(StandardCharsets.UTF_8));
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-------"));
    return file.toString();
  }

  private static void assertRefused(Runnable access, String start) {
    assertThatThrownBy(access::run)
        .isInstanceOf(BadInputException.class)
        .hasMessageStartingWith(start);
  }

  @Test
  void configured_nothing_isWithoutUserAndPlain() {
    BrokerAccess access = BrokerAccess.configured(XmlConfiguration.inMemory("test", Map.of()));

    assertThat(access.user()).isEmpty();
    assertThat(access.password()).isEmpty();
    assertThat(access.isEncrypted()).isFalse();
    assertThat(access.scheme()).isEqualTo("tcp");
    assertThat(access.sockets()).isInstanceOf(PromptSockets.class);
    assertThat(access).isSameAs(BrokerAccess.open());
  }

  @Test
  void configured_userAndPassword_isThatUserWithTheFirstLine() throws IOException {
    XmlConfiguration configuration =
        XmlConfiguration.inMemory(
            "test", Map.of("USER", "ann", "PASSWORD FILE", passwordFile("geheim é\nrest\n")));

    BrokerAccess access = BrokerAccess.configured(configuration);

    assertThat(access.user()).contains("ann");
    assertThat(new String(access.password())).isEqualTo("geheim é");
    assertThat(access.isEncrypted()).isFalse();
  }

  @Test
  void password_changedByItsReader_isTheSameForTheNext() throws IOException {
    BrokerAccess access = BrokerAccess.of("ann", passwordFile("secret"), false, "");

    access.password()[0] = 'X';

    assertThat(new String(access.password())).isEqualTo("secret");
  }

  @Test
  void of_encryptedWithoutUser_trustsWhomJavaTrusts() {
    BrokerAccess access = BrokerAccess.of("", "", true, "");

    assertThat(access.isEncrypted()).isTrue();
    assertThat(access.scheme()).isEqualTo("ssl");
    assertThat(access.sockets()).isInstanceOf(PromptTlsSockets.class);
    assertThat(access.user()).isEmpty();
  }

  @Test
  void of_userWithoutPasswordOrTheOtherWayRound_isRefused() {
    assertRefused(
        () -> BrokerAccess.of("ann", "", false, ""),
        "USER \"ann\" and PASSWORD FILE \"\": expected both or neither");
    assertRefused(
        () -> BrokerAccess.of("", "x", false, ""),
        "USER \"\" and PASSWORD FILE \"x\": expected both or neither");
  }

  @Test
  void of_passwordFileWithoutPassword_isRefused() throws IOException {
    for (String text : new String[] {"", "\nsecond"}) {
      String file = passwordFile(text);
      assertRefused(
          () -> BrokerAccess.of("ann", file, false, ""),
          "PASSWORD FILE \"" + file + "\": its first line is empty; expected the password");
    }
  }

  @Test
  void of_passwordFileNotThereOrOpenOrNoPath_isRefused() throws IOException {
    String absent = folder.resolve("none").toString();
    assertRefused(
        () -> BrokerAccess.of("ann", absent, false, ""),
        "PASSWORD FILE \"" + absent + "\" cannot be read: ");
    assertRefused(
        () -> BrokerAccess.of("ann", "a\u0000b", false, ""),
        "PASSWORD FILE \"a b\" is not a path: ");
    String open = passwordFile("secret");
    Files.setPosixFilePermissions(Path.of(open), PosixFilePermissions.fromString("rw-r--r--"));
    assertRefused(
        () -> BrokerAccess.of("ann", open, false, ""),
        "PASSWORD FILE \"" + open + "\": users other than its owner may use it");
  }

  /** Two of the certificates that this Java trusts. */
  private Path authorities() throws Exception {
    TrustManagerFactory managers =
        TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm());
    managers.init((KeyStore) null);
    X509TrustManager java = (X509TrustManager) managers.getTrustManagers()[0];
    StringBuilder pem = new StringBuilder();
    for (int i = 0; i < 2; i++) {
      pem.append("-----BEGIN CERTIFICATE-----\n")
          .append(Base64.getMimeEncoder().encodeToString(java.getAcceptedIssuers()[i].getEncoded()))
          .append("\n-----END CERTIFICATE-----\n");
    }
    return Files.writeString(folder.resolve("ca.pem"), pem);
  }

  @Test
  void of_authoritiesFile_switchesEncryptionOn() throws Exception {
    BrokerAccess access = BrokerAccess.of("", "", false, authorities().toString());

    assertThat(access.isEncrypted()).isTrue();
    assertThat(access.sockets().createSocket()).isInstanceOf(SSLSocket.class);
  }

  @Test
  void of_authoritiesFileThatEverybodyMayWrite_isRefused() throws IOException {
    Path open = Files.createFile(folder.resolve("ca.pem"));
    Files.setPosixFilePermissions(open, PosixFilePermissions.fromString("rw-rw-rw-"));
    assertRefused(
        () -> BrokerAccess.of("", "", true, open.toString()),
        "CA FILE \"" + open + "\": users other than its owner may write it; chmod o-w it");
  }

  @Test
  void of_authoritiesFileThatHoldsNone_isRefusedThoughTlsIsNotNamed() throws IOException {
    Path empty = Files.createFile(folder.resolve("ca.pem"));
    assertRefused(
        () -> BrokerAccess.of("", "", false, empty.toString()),
        "CA FILE \"" + empty + "\" holds no certificate; expected one or more in PEM");
    Path noise = Files.write(folder.resolve("noise.pem"), new byte[] {1, 2, 3});
    assertRefused(
        () -> BrokerAccess.of("", "", false, noise.toString()),
        "CA FILE \"" + noise + "\" cannot be used: ");
    Path huge = Files.write(folder.resolve("huge.pem"), new byte[(1 << 20) + 1]);
    assertRefused(
        () -> BrokerAccess.of("", "", true, huge.toString()),
        "CA FILE \"" + huge + "\" is longer than 1 MiB; expected certificates in PEM");
    assertRefused(
        () -> BrokerAccess.of("", "", true, folder.toString()),
        "CA FILE \"" + folder + "\" is not a regular file");
    Path absent = folder.resolve("none.pem");
    assertRefused(
        () -> BrokerAccess.of("", "", true, absent.toString()),
        "CA FILE \"" + absent + "\" cannot be used: ");
  }
}
