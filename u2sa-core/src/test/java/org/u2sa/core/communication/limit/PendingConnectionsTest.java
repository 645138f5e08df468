package org.u2sa.core.communication.limit;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.UnknownHostException;
import org.junit.jupiter.api.Test;

/** Who is put out where more connect than say who they are. */
class PendingConnectionsTest {
  private final PendingConnections<String> pending = new PendingConnections<>();

  private static InetAddress address(String text) throws UnknownHostException {
    return InetAddress.getByName(text);
  }

  @Test
  void add_floodFromManyAddresses_leavesWhoComesFromWhereSomebodyCameIn() throws Exception {
    pending.add("pilot's first", address("192.0.2.1"));
    pending.proven("pilot's first");
    pending.add("pilot", address("192.0.2.1"));
    for (int i = 0; i < 10 * BrokerLimits.PENDING; i++) {
      assertThat(pending.add("flood " + i, address("10.0." + i / 250 + "." + i % 250)))
          .doesNotContain("pilot");
    }
  }

  @Test
  void add_floodFromOneNetworkOfIpv6_putsOutItsOwn() throws Exception {
    pending.add("pilot", address("2001:db8::1"));
    for (int i = 0; i < 10 * BrokerLimits.PENDING; i++) {
      assertThat(pending.add("flood " + i, address("2001:db8:0:1::" + Integer.toHexString(i))))
          .doesNotContain("pilot");
    }
  }

  @Test
  void add_manyOfOneKnownAddress_putsOutItsOldest() throws Exception {
    pending.add("known", address("192.0.2.1"));
    pending.proven("known");
    pending.add("other", address("192.0.2.2"));
    for (int i = 0; i < BrokerLimits.PENDING_PER_ADDRESS; i++) {
      assertThat(pending.add("own " + i, address("192.0.2.1"))).isEmpty();
    }
    assertThat(pending.add("last", address("192.0.2.1"))).containsExactly("own 0");
  }

  @Test
  void ofAnotherPort_flood_displacesNoneOfThisPortAndKnowsItsNetworks() throws Exception {
    PendingConnections<String> web = pending.ofAnotherPort();
    pending.add("pilot", address("192.0.2.1"));
    for (int i = 0; i < 10 * BrokerLimits.PENDING; i++) {
      assertThat(web.add("flood " + i, address("192.0.2.1"))).doesNotContain("pilot");
    }
    pending.proven("pilot");
    assertThat(web.isKnown(address("192.0.2.1"))).isTrue();
  }
}
