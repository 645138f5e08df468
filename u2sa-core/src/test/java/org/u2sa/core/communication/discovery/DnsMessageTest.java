package org.u2sa.core.communication.discovery;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class DnsMessageTest {
  private static final List<String> INSTANCE = List.of("a boat", "_mqtt", "_tcp", "local");
  private static final List<String> HOST = List.of("bow", "local");

  private static DnsMessage message() {
    return new DnsMessage(
        List.of(new DnsMessage.Question(INSTANCE, DnsRecord.TEXT)),
        List.of(
            DnsRecord.service(INSTANCE, 120, 40_000, HOST),
            DnsRecord.address(HOST, 120, InetAddress.getLoopbackAddress())));
  }

  private static DnsMessage read(byte[] bytes) throws IOException {
    return DnsMessage.read(bytes, bytes.length);
  }

  @Test
  void read_whatWasWritten_isTheSame() throws IOException {
    DnsMessage read = read(message().bytes());

    assertThat(read.questions()).isEqualTo(message().questions());
    DnsRecord service = read.records().get(0);
    assertThat(service.name()).isEqualTo(INSTANCE);
    assertThat(service.port()).isEqualTo(40_000);
    assertThat(DnsMessage.target(service)).isEqualTo(HOST);
    assertThat(read.records().get(1).data()).containsExactly(127, 0, 0, 1);
  }

  @Test
  void read_nameWhoseRestIsEarlier_isWhole() throws IOException {
    byte[] bytes =
        bytes(1, 1, "0161016202636400" + "00010001" + "C00E" + "000100010000000000047F000001");

    assertThat(read(bytes).records().get(0).name()).containsExactly("b", "cd");
  }

  @Test
  void read_nameThatPointsToItself_isRefused() {
    assertThatThrownBy(() -> read(bytes(1, 0, "C00C00010001")))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("does not point backwards");
  }

  @Test
  void read_anyLengthOrByteWrong_isReadOrRefused() {
    byte[] whole = message().bytes();
    Random random = new Random(1);
    for (int i = 0; i < 100_000; i++) {
      byte[] broken = Arrays.copyOf(whole, random.nextInt(whole.length + 1));
      for (int j = 0; j < 3 && broken.length > 0; j++) {
        broken[random.nextInt(broken.length)] = (byte) random.nextInt();
      }
      try {
        read(broken).records().forEach(DnsRecord::properties);
      } catch (IOException e) {
        assertThat(e).hasMessageMatching(".*(early|name|record).*");
      }
    }
  }

  @Test
  void properties_twoOfOneKeyAndOneThatEndsEarly_theFirstCounts() {
    DnsRecord text =
        new DnsRecord(
            INSTANCE, DnsRecord.TEXT, 120, new byte[] {3, 'a', '=', '1', 3, 'a', '=', '2', 9, 'b'});

    assertThat(text.properties()).containsEntry("a", "1").containsEntry("b", "");
  }

  private static byte[] bytes(int questions, int records, String hex) {
    byte[] body = HexFormat.of().parseHex(hex);
    byte[] bytes = new byte[12 + body.length];
    bytes[5] = (byte) questions;
    bytes[7] = (byte) records;
    System.arraycopy(body, 0, bytes, 12, body.length);
    return bytes;
  }
}
