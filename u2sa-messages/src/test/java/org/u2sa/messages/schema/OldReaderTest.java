package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.contract.ConnectionLost;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.contract.ServiceStatus;
import org.u2sa.messages.registry.StandardTypes;

/**
 * Services built against the data model of format 1, its very code, among present ones (thesis
 * 8.2.5, 3.5.1.2).
 */
class OldReaderTest {
  @TempDir private static Path folder;
  private static OldDataModel old;

  private final MessageCodec present = new MessageCodec(StandardTypes.registry());

  @BeforeAll
  static void buildOldModel() throws IOException, ReflectiveOperationException {
    old = OldDataModel.of(1, folder);
  }

  @AfterAll
  static void close() throws IOException {
    if (old != null) {
      old.close();
    }
  }

  /** Golden messages but those with a byte string, which formats 1 and 2 did not have. */
  private static Map<String, U2SAData> readable() {
    Map<String, U2SAData> readable = new LinkedHashMap<>(GoldenMessages.all());
    readable.values().removeIf(OldReaderTest::hasBytes);
    return readable;
  }

  private static boolean hasBytes(U2SAData message) {
    return message.type().fields().stream().anyMatch(field -> field.kind() == Kind.BYTES);
  }

  @Test
  void byteString_readByFormat1_isRefusedWithWhatWasExpected() {
    U2SAData image = GoldenMessages.all().get("CameraImage");

    assertThatThrownBy(() -> old.decode(image.typeChain(), image.serialize()))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("CameraImage.data");
  }

  @Test
  void everyGoldenMessage_readByFormat1_isItsClassOrNearestAncestor()
      throws ReflectiveOperationException {
    List<String> asThemselves = new ArrayList<>();
    for (Map.Entry<String, U2SAData> golden : readable().entrySet()) {
      U2SAData message = golden.getValue();
      OldDataModel.Read read = old.decode(message.typeChain(), message.serialize());
      assertThat(read.chain()).as(golden.getKey()).isEqualTo(message.typeChain());
      if (read.className().equals(message.getClass().getSimpleName())) {
        asThemselves.add(read.className());
      } else {
        assertThat(read.className())
            .isIn(
                "OpaqueMessage",
                "HealthReport",
                "ActuatorCommand",
                "StateInformation",
                "UnknownGoal",
                "UnknownShape",
                "Line",
                "Sphere",
                "Box",
                "Cylinder",
                "Rectangle",
                "Waypoint");
      }
    }
    assertThat(asThemselves).contains("HealthReport", "Waypoint", "DiscoveryResponse");
  }

  @Test
  void healthReport_withFieldsOfFormat2_isReadWithoutThem() throws ReflectiveOperationException {
    HealthReport report = new HealthReport().serviceName("GPS").status(ServiceStatus.RUNNING);
    report.inboxDepth(3).instance("i-1").interval(0.25).threadAlive(true).published(9);

    OldDataModel.Read read = old.decode(report.typeChain(), report.serialize());

    assertThat(read.className()).isEqualTo("HealthReport");
    assertThat(read.toString()).contains("GPS", "inboxDepth=3").doesNotContain("i-1", "published");
  }

  @Test
  void connectionLost_readByFormat1_isAHealthReportAndRelayedWhole()
      throws ReflectiveOperationException, MalformedMessageException {
    ConnectionLost lost = new ConnectionLost();
    lost.serviceName("GPS").status(ServiceStatus.FAILED).lastError("connection lost");
    lost.instance("i-1");

    OldDataModel.Read read = old.decode(lost.typeChain(), lost.serialize());

    assertThat(read.className()).isEqualTo("HealthReport");
    assertThat(read.toString()).contains("FAILED", "connection lost");
    assertThat(present.decode(read.chain(), read.serialize())).isEqualTo(lost);
  }

  @Test
  void classesOfFormat2_relayedByFormat1_loseNothing()
      throws ReflectiveOperationException, MalformedMessageException {
    for (U2SAData message : readable().values()) {
      OldDataModel.Read read = old.decode(message.typeChain(), message.serialize());
      if (read.className().equals("OpaqueMessage")) {
        assertThat(present.decode(read.chain(), read.serialize())).isEqualTo(message);
      }
    }
  }

  @Test
  void unknownConstant_ofARequiredEnum_isRefusedByBoth() {
    byte[] bytes = withText(new HealthReport().serviceName("GPS").status(ServiceStatus.RUNNING));

    assertThatThrownBy(() -> old.decode(HealthReport.TYPE.chain(), bytes))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("expected one of");
    assertThatThrownBy(() -> present.decode(HealthReport.TYPE.chain(), bytes))
        .isInstanceOf(MalformedMessageException.class)
        .hasMessageContaining("RUNNENG");
  }

  /** RUNNING becomes RUNNENG, as long and no constant. */
  private static byte[] withText(HealthReport report) {
    byte[] bytes = report.serialize();
    int at = new String(bytes, java.nio.charset.StandardCharsets.ISO_8859_1).indexOf("RUNNING");
    bytes[at + 4] = 'E';
    return bytes;
  }

  @Test
  void presentReader_messagesOfFormat1_readsAndWritesThemUnchanged()
      throws ReflectiveOperationException, MalformedMessageException {
    for (U2SAData message : readable().values()) {
      OldDataModel.Read read = old.decode(message.typeChain(), message.serialize());
      byte[] written = read.serialize();
      U2SAData again = present.decode(read.chain(), written);
      boolean sameClass = read.className().equals(message.getClass().getSimpleName());
      if (sameClass) {
        assertThat(again.serialize()).isEqualTo(written);
      } else { // keys that an ancestor does not know come last, and none is lost
        assertThat(again).isEqualTo(message);
      }
    }
  }
}
