package org.u2sa.core.communication.limit;

import java.net.InetAddress;
import java.util.Map;

/**
 * Limits the accepted connections per second, for each network and for all networks without a
 * successful login together, so that known networks keep their own rate. Confined to the accepting
 * thread.
 */
public final class AcceptRate {
  private static final double BURST_S = 1.0; // a system's clients may connect simultaneously
  private static final int NETWORKS_REMEMBERED = 1_024;

  private final double perNetworkPerS;
  private final Allowance strangers;
  private final Map<String, Allowance> byNetwork = new RecentlyUsed<>(NETWORKS_REMEMBERED);

  /**
   * @param perS connections per second from all networks without a successful login; half of it for
   *     a single network
   */
  public AcceptRate(double perS, long nowMicros) {
    perNetworkPerS = perS / 2.0;
    strangers = new Allowance(perS, BURST_S * perS, nowMicros);
  }

  /**
   * Whether another connection may be accepted; if so, it is counted.
   *
   * @param isKnown whether its network has had a successful login
   */
  public boolean accepts(InetAddress from, boolean isKnown, long nowMicros) {
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
