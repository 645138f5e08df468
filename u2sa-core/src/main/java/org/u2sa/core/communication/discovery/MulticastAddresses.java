package org.u2sa.core.communication.discovery;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/** This host's addresses for multicast DNS: one IPv4 address per network. */
public final class MulticastAddresses {
  private MulticastAddresses() {}

  /**
   * Addresses of all networks that are up, loopback last.
   *
   * @throws IOException if they cannot be determined
   */
  public static List<InetAddress> all() throws IOException {
    List<InetAddress> networks = new ArrayList<>();
    List<InetAddress> loopback = new ArrayList<>();
    try {
      for (NetworkInterface each : Collections.list(NetworkInterface.getNetworkInterfaces())) {
        if (each.isUp() && (each.supportsMulticast() || each.isLoopback())) {
          Collections.list(each.getInetAddresses()).stream()
              .filter(Inet4Address.class::isInstance)
              .findFirst()
              .ifPresent((each.isLoopback() ? loopback : networks)::add);
        }
      }
    } catch (SocketException e) {
      throw new IOException("the host's networks cannot be listed: " + e.getMessage(), e);
    }
    networks.addAll(loopback);
    return networks;
  }

  /**
   * Addresses at which a server bound to the given address can be reached.
   *
   * @param bindAddress an address of this host, or the wildcard address
   */
  public static List<InetAddress> of(String bindAddress) throws IOException {
    InetAddress address = InetAddress.getByName(bindAddress);
    return address.isAnyLocalAddress() ? all() : List.of(address);
  }
}
