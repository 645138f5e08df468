package org.u2sa.gcs.mavlink;

import java.net.InetSocketAddress;

/** Link between a bridge and its stations. */
sealed interface StationPlace {
  /**
   * Stations connect by TCP.
   *
   * @param address address to listen on
   */
  record Tcp(InetSocketAddress address) implements StationPlace {
    @Override
    public String toString() {
      return "tcp:" + text(address);
    }
  }

  /**
   * Packets go to one station by UDP.
   *
   * @param address address of the station
   */
  record Udp(InetSocketAddress address) implements StationPlace {
    @Override
    public String toString() {
      return "udp:" + text(address);
    }
  }

  /**
   * One station on a serial port, often a telemetry radio.
   *
   * @param path device file
   * @param baud bits per second
   */
  record Serial(String path, int baud) implements StationPlace {
    @Override
    public String toString() {
      return "serial:" + path + " at " + baud + " baud";
    }
  }

  private static String text(InetSocketAddress address) {
    return address.getAddress().getHostAddress() + ":" + address.getPort();
  }
}
