package org.u2sa.core.communication;

import static org.assertj.core.api.Assertions.assertThat;

import io.netty.handler.codec.DecoderException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Map;
import java.util.Set;
import javax.net.ssl.SSLHandshakeException;
import org.junit.jupiter.api.Test;
import org.u2sa.core.communication.discovery.FoundBroker;
import org.u2sa.core.communication.discovery.MulticastAddresses;
import org.u2sa.core.communication.limit.BrokerLimits;
import org.u2sa.core.communication.limit.SourceNetwork;
import org.u2sa.interfaces.configuration.XmlConfiguration;

/** What a connection failed by, whom an address is counted as, which limits follow from others. */
class SmallPartsTest {
  private static BrokerLimits limits(int clients) {
    return XmlConfiguration.inMemory("test", Map.of("MAX CLIENTS", clients))
        .settings(BrokerLimits.class)
        .get();
  }

  private static String fault(Throwable error) {
    ConnectionFault fault = ConnectionFault.of(error);
    return fault.kind() + ": " + fault.words();
  }

  @Test
  void fault_ofEncryption_isFoundHoweverDeep() {
    assertThat(fault(new DecoderException(new SSLHandshakeException("no cipher"))))
        .isEqualTo("connection without the right encryption: \"no cipher\"");
  }

  @Test
  void fault_ofAPacket_isMalformedAlsoIfMoquetteWrapsIt() {
    assertThat(fault(new DecoderException("bad length")))
        .isEqualTo("malformed packet: \"bad length\"");
    assertThat(fault(new IOException("wrapped", new IllegalStateException("bad type"))))
        .isEqualTo("malformed packet: \"bad type\"");
  }

  @Test
  void fault_ofTheNetwork_isThatOfTheConnection() {
    assertThat(fault(new IOException("reset"))).isEqualTo("connection failed: \"reset\"");
    assertThat(fault(new IllegalStateException("x", new IOException("y"))))
        .isEqualTo("connection failed: \"x\"");
  }

  @Test
  void network_ofAnAddress_isItselfOrForIpv6ItsFirstHalf() throws UnknownHostException {
    assertThat(SourceNetwork.of(InetAddress.getByName("10.1.2.3"))).isEqualTo("10.1.2.3");
    String one = SourceNetwork.of(InetAddress.getByName("2001:db8:0:1::1"));
    assertThat(one)
        .isEqualTo(SourceNetwork.of(InetAddress.getByName("2001:db8:0:1:ffff::2")))
        .isNotEqualTo(SourceNetwork.of(InetAddress.getByName("2001:db8:0:2::1")));
  }

  @Test
  void limits_ofOneUserAndOfAllBesidesOperators_leaveRoom() {
    assertThat(limits(512).clientsPerUser()).isEqualTo(256);
    assertThat(limits(5).clientsPerUser()).isEqualTo(2);
    assertThat(limits(512).clientsBesidesOperators()).isEqualTo(480);
    assertThat(limits(31).clientsBesidesOperators()).isEqualTo(30);
    assertThat(limits(32).clientsBesidesOperators()).isEqualTo(30);
  }

  @Test
  void found_broker_carriesTheSystemsThatItNamesOrAny() {
    FoundBroker one = new FoundBroker("10.0.0.1", 1883, Set.of("cessna"), true);
    FoundBroker any = new FoundBroker("10.0.0.2", 1884, Set.of("*"), false);

    assertThat(one.carries("cessna")).isTrue();
    assertThat(one.carries("boat")).isFalse();
    assertThat(any.carries("boat")).isTrue();
    assertThat(one).hasToString("10.0.0.1:1883 (cessna, TLS)");
    assertThat(any).hasToString("10.0.0.2:1884 (any system)");
  }

  @Test
  void addresses_ofABoundServer_areItsOwnOrAllWithLoopbackLast() throws IOException {
    assertThat(MulticastAddresses.of("127.0.0.1"))
        .containsExactly(InetAddress.getByName("127.0.0.1"));
    assertThat(MulticastAddresses.of("0.0.0.0"))
        .isEqualTo(MulticastAddresses.all())
        .last()
        .matches(InetAddress::isLoopbackAddress);
  }
}
