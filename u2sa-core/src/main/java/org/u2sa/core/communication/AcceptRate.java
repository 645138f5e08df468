package org.u2sa.core.communication;

import java.net.InetAddress;
import java.util.Map;

/**
 * How many connections a second are accepted: of one network, and of all from which nobody has
 * logged in, which leaves the others their own. Confined to the accepting thread.
 */
final class AcceptRate {
  private static final double BURST_S = 1.0; // a system's clients may connect all at once
  private static final int NETWORKS_REMEMBERED = 1_024;

  private final double perNetworkPerS;
  private final Allowance strangers;
  private final Map<String, Allowance> byNetwork = new RecentlyUsed<>(NETWORKS_REMEMBERED);

  /**
   * @param perS connections a second from all networks from which nobody has logged in; each
   *     network has half of that
   */
  AcceptRate(double perS, long nowMicros) {
    perNetworkPerS = perS / 2.0;
    strangers = new Allowance(perS, BURST_S * perS, nowMicros);
  }

  /**
   * Whether one more may be accepted, which then counts.
   *
   * @param isKnown whether somebody has logged in from its network
   */
  boolean accepts(InetAddress from, boolean isKnown, long nowMicros) {
    Allowance network =
        byNetwork.computeIfAbsent(
            SourceNetwork.of(from),
            key -> new Allowance(perNetworkPerS, BURST_S * perNetworkPerS, nowMicros));
    if (!network.isOpen(nowMicros) || !isKnown && !strangers.isOpen(nowMicros)) {
      return false;
    }
    network.take(1.0);
    if (!isKnown) {
      strangers.take(1.0);
    }
    return true;
  }
}
