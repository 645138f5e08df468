package org.u2sa.core.communication;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.util.Arrays;

/**
 * The key by which addresses are counted: the address, or for IPv6 its /64, which one host owns.
 */
final class SourceNetwork {
  private static final int NETWORK_BYTES = 8;

  private SourceNetwork() {}

  static String of(InetAddress address) {
    return address instanceof Inet6Address
        ? Arrays.toString(Arrays.copyOf(address.getAddress(), NETWORK_BYTES))
        : address.getHostAddress();
  }
}
