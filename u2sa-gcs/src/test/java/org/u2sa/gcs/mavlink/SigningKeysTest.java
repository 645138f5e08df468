package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.dronefleet.mavlink.common.SystemTime;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.core.security.SecretFile;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.mavlink.MavlinkSigning;
import org.u2sa.mavlink.MavlinkStream;

/** What the MAVLink links of a process know of each other's packets. */
class SigningKeysTest {
  @TempDir Path folder;

  private final AtomicLong clock = new AtomicLong(1_800_000_000_000_000L);
  private final SigningKeys keys = new SigningKeys();
  private final List<Object> heard = new ArrayList<>();
  private final List<String> warnings = new ArrayList<>();
  private byte[] packet;

  @BeforeEach
  void write() {
    secret("key", "secret\n");
    secret("copy", " secret \nsomething else\n");
    MavlinkSigning station = new MavlinkSigning("secret", clock::get);
    packet =
        new MavlinkStream(255, 190, Optional.of(station))
            .encode(SystemTime.builder().timeBootMs(1).build());
  }

  private Path secret(String name, String text) {
    Path file = folder.resolve(name);
    SecretFile.write(file, text.getBytes(StandardCharsets.UTF_8));
    return file;
  }

  private void assertThatRefused(Path file, String why) {
    assertThatThrownBy(() -> keys.of("boat", file, clock::get, warnings::add))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining(file + ": " + why);
  }

  /** A link of a vehicle. */
  private MavlinkStream link(String systemId, String file) {
    MavlinkSigning signing = keys.of(systemId, folder.resolve(file), clock::get, warnings::add);
    return new MavlinkStream(1, 1, Optional.of(signing.link()));
  }

  private int heardBy(MavlinkStream link) {
    heard.clear();
    link.accept(packet, packet.length, heard::add);
    return heard.size();
  }

  @Test
  void of_packetRecordedOnAnotherLinkOfTheVehicle_isRefused() {
    assertThat(heardBy(link("boat", "key"))).isEqualTo(1);
    assertThat(heardBy(link("boat", "key"))).isZero();
    assertThat(heardBy(link("boat", "copy"))).isZero();
  }

  @Test
  void of_packetRecordedBeforeTheStart_isRefusedAndSaid() {
    clock.addAndGet(20_000_000);
    MavlinkStream restarted = link("boat", "key");
    clock.addAndGet(500_000);
    assertThat(heardBy(restarted)).isZero();
    assertThat(heardBy(restarted)).isZero();
    assertThat(warnings)
        .singleElement()
        .asString()
        .startsWith(
            "MAVLink system 255, component 190 is refused: its packet was signed 20.5 s ago")
        .contains("expected at most 0.5 s");
  }

  @Test
  void of_otherVehicle_keepsItsOwnRecord() {
    assertThat(heardBy(link("boat", "key"))).isEqualTo(1);
    assertThat(heardBy(link("rover", "key"))).isEqualTo(1);
  }

  @Test
  void of_fileWithoutPassphrase_isNamed() {
    assertThatRefused(secret("empty", "\nsecret\n"), "expected the MAVLink passphrase in line 1");
  }

  @ParameterizedTest
  @ValueSource(strings = {"rw----r--", "rw-r-----", "rw--w----", "rw-----w-"})
  void of_fileThatOthersMayUse_isRefused(String permissions) throws IOException {
    Path file = folder.resolve("key");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(permissions));
    assertThatRefused(file, "users other than its owner may use it; chmod 600 it");
  }

  @Test
  void of_linkToAFileOfTheOwner_isRead() throws IOException {
    Files.createSymbolicLink(folder.resolve("link"), folder.resolve("key"));
    assertThat(heardBy(link("boat", "link"))).isEqualTo(1);
  }

  @Test
  void of_deviceFolderOrHugeFile_isRefusedUnread() {
    assertThatRefused(Path.of("/dev/zero"), "is not a regular file");
    assertThatRefused(folder, "is a folder; expected the MAVLink passphrase");
    assertThatRefused(secret("huge", "x".repeat(8_193)), "longer than 8192 bytes");
  }
}
