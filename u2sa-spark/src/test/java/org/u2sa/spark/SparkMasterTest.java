package org.u2sa.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.testkit.FreePort;

class SparkMasterTest {
  @ParameterizedTest
  @ValueSource(strings = {"local", "local[1]", "local[16]", "local[*]"})
  void of_coresOfThisMachine_areNoCluster(String text) {
    SparkMaster master = SparkMaster.of(text);

    assertThat(master.isCluster()).isFalse();
    assertThat(master.localAddress()).isEqualTo("127.0.0.1");
    assertThat(master.text()).isEqualTo(text);
  }

  @Test
  void of_twoMasters_areBothKnown() {
    SparkMaster master = SparkMaster.of("spark://10.0.0.1:7077,[fd00::1]:7078");

    assertThat(master.isCluster()).isTrue();
    assertThat(master.hosts())
        .extracting(host -> host.getHostString() + " " + host.getPort())
        .containsExactly("10.0.0.1 7077", "[fd00::1] 7078");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "yarn",
        "local[0]",
        "local[]",
        "local[2",
        "LOCAL",
        "spark://",
        "spark://host",
        "spark://host:0",
        "spark://host:65536",
        "spark://a:1,",
        "spark://a:1/x",
        "http://a:1"
      })
  void of_anythingElse_isRefusedWithWhatWasExpected(String text) {
    assertThatThrownBy(() -> SparkMaster.of(text))
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("--master \"" + text + "\"")
        .hasMessageContaining("local[*]")
        .hasMessageContaining("spark://HOST:PORT");
  }

  @Test
  void localAddress_nobodyListens_isRefusedWithTheReason() {
    int port = FreePort.find();

    assertThatThrownBy(SparkMaster.of("spark://127.0.0.1:" + port)::localAddress)
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("127.0.0.1:" + port + " (Connection refused)")
        .hasMessageContaining("scripts/spark/node");
  }

  @Test
  void localAddress_hostThatIsUnknown_isRefused() {
    assertThatThrownBy(SparkMaster.of("spark://no-such-host.invalid:7077")::localAddress)
        .isInstanceOf(BadInputException.class)
        .hasMessageContaining("no-such-host.invalid:7077");
  }

  @Test
  void localAddress_secondMasterAnswers_isTheAddressOnTheWayToIt() throws IOException {
    try (ServerSocket listening = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
      SparkMaster master =
          SparkMaster.of(
              "spark://127.0.0.1:" + FreePort.find() + ",127.0.0.1:" + listening.getLocalPort());

      assertThat(master.localAddress()).isEqualTo("127.0.0.1");
    }
  }
}
