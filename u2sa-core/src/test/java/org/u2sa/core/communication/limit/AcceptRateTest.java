package org.u2sa.core.communication.limit;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.UnknownHostException;
import org.junit.jupiter.api.Test;

/** How many connections a second may come, and from where. */
class AcceptRateTest {
  private static final int PER_S = 200;

  private final AcceptRate rate = new AcceptRate(PER_S, 0L);

  private static InetAddress address(int number) throws UnknownHostException {
    return InetAddress.getByAddress(new byte[] {10, 0, (byte) (number >> 8), (byte) number});
  }

  private int accepted(int connections, int networks, boolean known, long nowMicros)
      throws UnknownHostException {
    int accepted = 0;
    for (int i = 0; i < connections; i++) {
      accepted += rate.accepts(address(i % networks), known, nowMicros) ? 1 : 0;
    }
    return accepted;
  }

  @Test
  void accepts_ofOneNetwork_halfOfAll() throws UnknownHostException {
    assertThat(accepted(10 * PER_S, 1, false, 0L)).isEqualTo(PER_S / 2);
    assertThat(accepted(10 * PER_S, 1, false, 100_000L)).isEqualTo(PER_S / 20);
  }

  @Test
  void accepts_ofManyNetworks_noMoreThanAll() throws UnknownHostException {
    assertThat(accepted(10 * PER_S, 2_500, false, 0L)).isEqualTo(PER_S);
    assertThat(accepted(10 * PER_S, 2_500, false, 500_000L)).isEqualTo(PER_S / 2);
  }

  @Test
  void accepts_knownNetworkDuringAFloodOfOthers_isNotTheirs() throws UnknownHostException {
    accepted(10 * PER_S, 2_000, false, 0L);
    assertThat(rate.accepts(address(3_000), false, 0L)).isFalse();
    assertThat(rate.accepts(address(3_000), true, 0L)).isTrue();
  }

  @Test
  void accepts_knownNetworkThatFloods_halfOfAllAndLeavesTheOthersTheirs()
      throws UnknownHostException {
    assertThat(accepted(10 * PER_S, 1, true, 0L)).isEqualTo(PER_S / 2);
    assertThat(rate.accepts(address(1), false, 0L)).isTrue();
  }
}
