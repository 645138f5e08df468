package org.u2sa.cli.security;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.GeneralSecurityException;
import java.security.cert.CertificateFactory;
import java.security.cert.X509Certificate;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.cli.CommandFixture;
import org.u2sa.cli.command.ExitCode;
import org.u2sa.core.security.SecretFile;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.core.security.UserFile;

class SecurityCommandTest extends CommandFixture {
  @TempDir private static Path once;
  @TempDir private Path folder;

  private SecurityDirectory directory;

  /** Runs a command on the folder; words without spaces. */
  private int security(String command) {
    return u2sa(("security " + command + " --dir " + directory.path()).split(" "));
  }

  /** A folder as {@code security init} leaves it, created once, since it takes seconds. */
  @BeforeEach
  void init() throws IOException {
    Path template = once.resolve("security");
    if (!Files.exists(template)) {
      assertThat(u2sa("security", "init", template.toString(), "--host", "vehicle.local"))
          .as(err.toString())
          .isEqualTo(ExitCode.DONE);
    }
    directory = new SecurityDirectory(folder.resolve("security"));
    try (Stream<Path> files = Files.walk(template)) {
      for (Path each : (Iterable<Path>) files::iterator) {
        Path to = directory.path().resolve(template.relativize(each));
        Files.copy(each, to, StandardCopyOption.COPY_ATTRIBUTES);
      }
    }
  }

  private static X509Certificate certificate(Path file)
      throws IOException, GeneralSecurityException {
    try (InputStream in = Files.newInputStream(file)) {
      return (X509Certificate) CertificateFactory.getInstance("X.509").generateCertificate(in);
    }
  }

  @Test
  void init_newFolder_brokersCertificateIsTheAuthoritysAndKeysAreTheOwners()
      throws IOException, GeneralSecurityException {
    X509Certificate authority = certificate(directory.authority());
    X509Certificate broker = certificate(directory.certificate());

    broker.verify(authority.getPublicKey());
    broker.checkValidity();
    assertThat(authority.getBasicConstraints()).isZero(); // an authority, of end certificates only
    assertThat(broker.getBasicConstraints()).isNegative();
    assertThat(broker.getSubjectAlternativeNames().toString())
        .contains("localhost", "127.0.0.1", "vehicle.local");
    directory.check();
    for (Path secret : List.of(directory.key(), directory.authorityKey(), directory.users())) {
      assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(secret)))
          .as(secret.toString())
          .isEqualTo("rw-------");
    }
  }

  @Test
  void init_folderInUse_overwritesNothing() {
    assertThat(u2sa("security", "init", directory.path().toString())).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("not overwritten");
  }

  @Test
  void certificate_otherHost_isBySameAuthority() throws IOException, GeneralSecurityException {
    byte[] before = Files.readAllBytes(directory.authority());
    assertThat(security("certificate 10.0.0.7")).as(err.toString()).isEqualTo(ExitCode.DONE);

    assertThat(Files.readAllBytes(directory.authority())).isEqualTo(before);
    X509Certificate broker = certificate(directory.certificate());
    broker.verify(certificate(directory.authority()).getPublicKey());
    assertThat(broker.getSubjectAlternativeNames().toString()).contains("10.0.0.7");
  }

  @Test
  void certificate_nameWithACommaInIt_isRefused() {
    assertThat(security("certificate a,eku=any")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("host \"a,eku=any\"");
  }

  @Test
  void user_addListRemove_changesTheFileAndWritesThePasswordForItsOwnerOnly() throws IOException {
    Path password = folder.resolve("pilot.password");
    assertThat(
            security(
                "user add pilot --role operator,observer --system cessna --new-password-file "
                    + password))
        .as(err.toString())
        .isEqualTo(ExitCode.DONE);

    String word = Files.readString(password).trim();
    assertThat(UserFile.read(directory.users()).get("pilot").password().matches(word.toCharArray()))
        .isTrue();
    assertThat(Files.readString(directory.users())).doesNotContain(word);
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(password)))
        .isEqualTo("rw-------");
    assertThat(security("user list")).isEqualTo(ExitCode.DONE);
    assertThat(out.toString()).containsPattern("pilot +operator,observer +cessna");
    assertThat(security("user remove pilot")).isEqualTo(ExitCode.DONE);
    assertThat(UserFile.read(directory.users())).isEmpty();
    assertThat(security("user remove pilot")).isEqualTo(ExitCode.BAD_INPUT);
  }

  @ParameterizedTest
  @CsvSource({
    "ca-key.p12, rw-r--r--, chmod 600",
    "users.txt, rw-rw----, chmod 600",
    "server-key.pem, rw-r-----, chmod 600",
    "'', rwxrwxrwx, chmod 700",
    "'', rwxrwx---, chmod 700"
  })
  void commands_folderOrFileOpenToOthers_areRefusedAndSayWhatToDo(
      String name, String permissions, String remedy) throws IOException {
    Path open = directory.path().resolve(name);
    Files.setPosixFilePermissions(open, PosixFilePermissions.fromString(permissions));

    assertThat(security("user list")).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains(directory.path().toString(), remedy);
    assertThat(security("certificate 10.0.0.7")).isEqualTo(ExitCode.BAD_INPUT);
    assertThatThrownBy(directory::check).hasMessageContaining(remedy);
  }

  @Test
  void userAdd_passwordFileOpenToOthers_isRefused() throws IOException {
    Path password = secret("word", "1234567890\n");
    Files.setPosixFilePermissions(password, PosixFilePermissions.fromString("rw-r--r--"));

    assertThat(security("user add x --role service --password-file " + password))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("users other than its owner may use it; chmod 600 it");
  }

  /** Root adds a user on the vehicle, whose own account must go on reading the file. */
  @Test
  void userAdd_usersOfAnotherAccount_staysTheirs() throws IOException {
    assumeTrue((Integer) Files.getAttribute(directory.users(), "unix:uid") == 0, "root only");
    Files.setAttribute(directory.users(), "unix:uid", 12_345);

    assertThat(
            security("user add x --role service --password-file " + secret("word", "1234567890\n")))
        .as(err.toString())
        .isEqualTo(ExitCode.DONE);
    assertThat(Files.getAttribute(directory.users(), "unix:uid")).isEqualTo(12_345);
  }

  private Path secret(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    SecretFile.write(file, text.getBytes(StandardCharsets.UTF_8));
    return file;
  }

  @Test
  void userAdd_wrongRoleShortPasswordNoTerminal_saysWhatIsExpected() throws IOException {
    Path tooShort = secret("short", "123456789\n");
    assertThat(
            security("user add x --role captain --password-file " + secret("long", "1234567890\n")))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("role \"captain\": expected one of service, control");
    assertThat(security("user add x --role service --password-file " + tooShort))
        .isEqualTo(ExitCode.BAD_INPUT);
    assertThat(err.toString()).contains("9 characters; expected 10 or more");
    assertThat(UserFile.read(directory.users())).isEmpty();
  }

  @Test
  void mosquitto_users_haveTheirRolesRights() throws IOException {
    security(
        "user add autopilot --role control --system cessna --new-password-file "
            + folder.resolve("p"));
    Path target = folder.resolve("mosquitto");
    assertThat(security("mosquitto " + target + " --port 18883"))
        .as(err.toString())
        .isEqualTo(ExitCode.DONE);

    assertThat(Files.readString(target.resolve("mosquitto.conf")))
        .contains("listener 18883 ", "allow_anonymous false", "tls_version tlsv1.2");
    assertThat(Files.readString(target.resolve("acl")))
        .contains(
            "user autopilot\n",
            "topic read u2sa/cessna/#\n",
            "topic write u2sa/cessna/actuation/ActuatorCommand/PercentageCommand\n",
            "topic write u2sa/cessna/configuration/ConfigurationResponse\n")
        .doesNotContain("u2sa/cessna/stop", "configuration/ConfigurationChange\n", "emergency-stop")
        .doesNotContainPattern("write .*#");
    assertThat(Files.readString(target.resolve("passwords"))).startsWith("autopilot:$7$210000$");
  }
}
