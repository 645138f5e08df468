package org.u2sa.gcs.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import io.dronefleet.mavlink.common.CommandAck;
import io.dronefleet.mavlink.common.ComponentMetadata;
import io.dronefleet.mavlink.common.MavResult;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.gcs.mavlink.FileStation.Answer;
import org.u2sa.gcs.mavlink.file.RecordingFolder;
import org.u2sa.gcs.mavlink.vehicle.Identity;
import org.u2sa.gcs.mavlink.vehicle.VehicleKind;
import org.u2sa.mavlink.MavlinkCrc32;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationVariable;

/** Files by MAVLink FTP: component metadata and recordings, and nothing else of the host. */
@SuppressWarnings("deprecation") // the library is older than the final form of COMPONENT_METADATA
class StationFileTest {
  @TempDir Path folder;

  private final byte[] recording = new byte[300_001];
  private BridgeKit kit;
  private FileStation station;

  @BeforeEach
  void begin() throws IOException {
    new Random(5).nextBytes(recording);
    Path logs = Files.createDirectory(folder.resolve("logs"));
    Files.write(logs.resolve("recording.mcap"), recording);
    Files.writeString(logs.resolve("password.txt"), "secret");
    Files.writeString(folder.resolve("outside.mcap"), "secret");
    Files.createSymbolicLink(logs.resolve("link.mcap"), folder.resolve("outside.mcap"));
    kit =
        new BridgeKit(
            Identity.PX4,
            VehicleKind.ROVER,
            Optional.empty(),
            Optional.of(new RecordingFolder(logs)));
    station = new FileStation(kit);
  }

  private void configure() {
    kit.says(
        new ConfigurationResponse()
            .serviceName("SafetyManager")
            .variables(
                List.of(
                    new ConfigurationVariable()
                        .name("BRAKING")
                        .variableType("double")
                        .value("0.5")
                        .unit("m/s²")
                        .min(0.1)
                        .description("Braking, \"assumed\"."),
                    new ConfigurationVariable()
                        .name("ON FENCE")
                        .variableType("string")
                        .value("STOP")
                        .choices(List.of("HOLD", "STOP")))));
  }

  @Test
  void metadata_fromTheMessageToTheParameters_checksumsAgree() throws IOException {
    kit.command(512, 397);
    assertThat(kit.received(CommandAck.class).get(0).result().entry())
        .as("no service has announced its variables yet")
        .isEqualTo(MavResult.MAV_RESULT_TEMPORARILY_REJECTED);
    configure();
    kit.command(512, 397);
    ComponentMetadata message = kit.received(ComponentMetadata.class).get(0);
    byte[] general = station.download(message.uri().substring("mftp://".length()));
    assertThat((int) message.fileCrc()).isEqualTo(new MavlinkCrc32().update(general).value());
    JsonNode type = new ObjectMapper().readTree(general).at("/metadataTypes/0");
    assertThat(type.get("type").asInt()).isEqualTo(1);
    byte[] parameters = station.download(type.get("uri").asText().substring("mftp://".length()));
    assertThat(type.get("fileCrc").asLong())
        .isEqualTo(new MavlinkCrc32().update(parameters).value() & 0xFFFF_FFFFL);

    JsonNode all = new ObjectMapper().readTree(parameters);
    assertThat(all.get("version").asInt()).as("what QGroundControl reads").isEqualTo(1);
    JsonNode braking = all.at("/parameters/0");
    assertThat(braking.get("name").asText()).isEqualTo("SAFM_BRAKING");
    assertThat(braking.get("units").asText()).isEqualTo("m/s²");
    assertThat(braking.get("min").asDouble()).isEqualTo(0.1);
    assertThat(braking.has("max")).isFalse();
    assertThat(braking.get("longDesc").asText()).isEqualTo("Braking, \"assumed\".");
    assertThat(all.at("/parameters/1/values/1").toString())
        .isEqualTo("{\"value\":1,\"description\":\"STOP\"}");
  }

  @Test
  void crc_checkValue_isThatOfQGroundControl() {
    // 123456789 with polynomial 0xEDB88320, initial value 0, not inverted
    assertThat(
            new MavlinkCrc32()
                .update("12345".getBytes(StandardCharsets.US_ASCII))
                .update("6789".getBytes(StandardCharsets.US_ASCII))
                .value())
        .isEqualTo(0x2DFD2D88);
  }

  @Test
  void recording_burstsAndChecksum_isTheFile() {
    assertThat(station.download("/logs/recording.mcap")).isEqualTo(recording);
    byte[] path = "/logs/recording.mcap".getBytes(StandardCharsets.US_ASCII);
    assertThat(station.ask(FileStation.CHECKSUM, 3, 0, path.length, path)).isEmpty();
    kit.step();
    Answer answer = station.answers().get(0);
    assertThat(answer.number()).isEqualTo(new MavlinkCrc32().update(recording).value());
    assertThat(answer.session()).isEqualTo(3);
  }

  @Test
  void recording_growsOrShrinksWhileOpen_keepsItsSizeOrFails() throws IOException {
    Answer opened = station.one(FileStation.OPEN, 0, "logs/recording.mcap");
    Files.write(folder.resolve("logs/recording.mcap"), new byte[400_000]);
    assertThat(
            station
                .ask(FileStation.READ, opened.session(), 300_000, 239, new byte[0])
                .get(0)
                .data())
        .hasSize(1);
    Files.write(folder.resolve("logs/recording.mcap"), new byte[10]);
    assertThat(
            station
                .ask(FileStation.READ, opened.session(), 100_000, 239, new byte[0])
                .get(0)
                .code())
        .isEqualTo(1);
    assertThat(
            station
                .ask(FileStation.BURST, opened.session(), 100_000, 239, new byte[0])
                .get(0)
                .code())
        .isEqualTo(1);
  }

  @Test
  void list_rootAndLogs_namesWhatMayBeHad() {
    byte[] listed = station.one(3, 0, "/").data();
    assertThat(new String(listed, StandardCharsets.US_ASCII))
        .matches("Fgeneral.json\t[0-9]+\0Fparameter.json\t[0-9]+\0Fevents.json\t[0-9]+\0Dlogs\0");
    assertThat(new String(station.one(3, 0, "/logs/").data(), StandardCharsets.US_ASCII))
        .isEqualTo("Frecording.mcap\t300001\0");
    assertThat(station.ask(3, 0, 4, 1, new byte[] {'/'}).get(0).code()).isEqualTo(6);
    assertThat(station.one(3, 0, "/etc").code()).isEqualTo(10);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "/",
        "logs",
        "/etc/passwd",
        "../outside.mcap",
        "/logs/../../outside.mcap",
        "/logs/../outside.mcap",
        "/logs/link.mcap",
        "/logs/password.txt",
        "/logs//recording.mcap",
        "/logs/..\\outside.mcap",
        "/logs/recording.mcap/../../outside.mcap",
        "@PARAM/param.pck?withdefaults=1"
      })
  void open_anyOtherPath_isNotFound(String path) {
    assertThat(station.one(FileStation.OPEN, 0, path).code()).isEqualTo(10);
    byte[] data = path.getBytes(StandardCharsets.US_ASCII);
    assertThat(station.ask(FileStation.CHECKSUM, 0, 0, data.length, data).get(0).code())
        .isEqualTo(10);
  }

  @ParameterizedTest
  @CsvSource({"6,9", "7,9", "8,9", "9,9", "10,9", "11,9", "12,9", "13,9", "16,7", "99,7", "200,7"})
  void request_writesOrUnknown_isRefused(int opcode, int code) {
    assertThat(station.one(opcode, 0, "/general.json").code()).isEqualTo(code);
  }

  @Test
  void request_sizesThatDoNotFit_areRefused() {
    assertThat(station.ask(FileStation.OPEN, 0, 0, 255, new byte[0]).get(0).code()).isEqualTo(3);
    assertThat(station.ask(3, 0, 0, 240, new byte[0]).get(0).code()).isEqualTo(3);
    int session = station.one(FileStation.OPEN, 0, "general.json").session();
    assertThat(station.ask(FileStation.READ, session, 0, 240, new byte[0]).get(0).code())
        .isEqualTo(3);
    assertThat(station.ask(FileStation.BURST, session, 0, 0, new byte[0]).get(0).code())
        .isEqualTo(3);
    assertThat(station.ask(FileStation.READ, session, 0xFFFF_FFFFL, 10, new byte[0]).get(0).code())
        .isEqualTo(6);
  }

  @Test
  void sessions_moreThanEight_areRefusedUntilOneEndsOrIdles() {
    for (int i = 0; i < 8; i++) {
      assertThat(station.one(FileStation.OPEN, 0, "general.json").session()).isEqualTo(i);
    }
    assertThat(station.one(FileStation.OPEN, 0, "general.json").code()).isEqualTo(5);
    assertThat(station.ask(1, 4, 0, 0, new byte[0]).get(0).ack()).isTrue();
    assertThat(station.one(FileStation.OPEN, 0, "general.json").session()).isEqualTo(4);
    kit.advance(31.0);
    assertThat(station.one(FileStation.OPEN, 0, "general.json").ack()).isTrue();
  }

  @Test
  void session_ofAnotherSender_isInvalidAndSurvivesItsReset() {
    int session = station.one(FileStation.OPEN, 0, "general.json").session();
    FileStation other = new FileStation(kit.sendingAs(191));
    assertThat(other.ask(FileStation.READ, session, 0, 10, new byte[0]).get(0).code()).isEqualTo(4);
    assertThat(other.ask(FileStation.BURST, session, 0, 10, new byte[0]).get(0).code())
        .isEqualTo(4);
    assertThat(other.ask(1, session, 0, 0, new byte[0]).get(0).code()).isEqualTo(4);
    assertThat(other.ask(2, 0, 0, 0, new byte[0]).get(0).ack()).isTrue();
    kit.sendingAs(190);
    assertThat(station.ask(FileStation.READ, session, 0, 10, new byte[0]).get(0).data())
        .hasSize(10);
    assertThat(station.ask(2, 0, 0, 0, new byte[0]).get(0).ack()).isTrue();
    assertThat(station.ask(FileStation.READ, session, 0, 10, new byte[0]).get(0).code())
        .isEqualTo(4);
  }

  @Test
  void open_answerLost_repetitionGetsTheSameSession() {
    byte[] path = "general.json".getBytes(StandardCharsets.US_ASCII);
    int session = station.ask(FileStation.OPEN, 0, 0, path.length, path).get(0).session();
    assertThat(station.repeat(FileStation.OPEN, 0, 0, path.length, path).get(0).session())
        .isEqualTo(session);
    assertThat(station.one(FileStation.OPEN, 0, "general.json").session()).isNotEqualTo(session);
  }

  @Test
  void terminateAndReads_comeAgainLate_nextSessionStaysOpenAndNothingIsSaid() {
    int first = station.one(FileStation.OPEN, 0, "general.json").session();
    station.ask(FileStation.BURST, first, 0, 10, new byte[0]);
    assertThat(station.ask(1, first, 0, 0, new byte[0]).get(0).ack()).isTrue();
    int second = station.one(FileStation.OPEN, 0, "parameter.json").session();
    assertThat(second).isEqualTo(first).isZero(); // whatever the answer, MAVSDK uses 0
    assertThat(station.late(2, 1, first)).isEmpty();
    assertThat(station.late(3, FileStation.BURST, first)).isEmpty();

    assertThat(station.ask(FileStation.READ, second, 0, 10, new byte[0]).get(0).data()).hasSize(10);
  }

  @Test
  void open_twoSenders_eachHasTheSessionZero() {
    assertThat(station.one(FileStation.OPEN, 0, "general.json").session()).isZero();
    FileStation other = new FileStation(kit.sendingAs(191));
    assertThat(other.one(FileStation.OPEN, 0, "parameter.json").session()).isZero();
    byte[] parameters = other.ask(FileStation.READ, 0, 0, 100, new byte[0]).get(0).data();
    kit.sendingAs(190);
    assertThat(station.ask(FileStation.READ, 0, 0, 100, new byte[0]).get(0).data())
        .isNotEqualTo(parameters);
  }
}
