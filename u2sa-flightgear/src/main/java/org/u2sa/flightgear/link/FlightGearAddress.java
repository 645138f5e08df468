package org.u2sa.flightgear.link;

import java.util.OptionalInt;

/**
 * Addresses and ports of the connection to FlightGear. {@code scripts/flightgear/start} uses 5501
 * (out), 5502 (in) and 5503 (properties).
 *
 * @param host where FlightGear runs
 * @param inPort FlightGear listens here for controls [1…65535]
 * @param propertyPort port of FlightGear's property server, used to repair a cut link; empty if
 *     absent
 * @param bindHost address on which this program listens for FlightGear's lines; "127.0.0.1" accepts
 *     connections from this machine only
 * @param outPort port on which it listens [0…65535]; 0 takes a free one
 * @param rateHz line rate requested from FlightGear when the link is repaired [Hz]
 */
public record FlightGearAddress(
    String host, int inPort, OptionalInt propertyPort, String bindHost, int outPort, int rateHz) {
  /** Line rate of {@code scripts/flightgear/start} [Hz]. */
  public static final int USUAL_RATE_HZ = 20;

  /**
   * @throws IllegalArgumentException if a number is outside its range
   */
  public FlightGearAddress {
    require("in port", inPort, 1, 65_535);
    propertyPort.ifPresent(port -> require("property port", port, 1, 65_535));
    require("out port", outPort, 0, 65_535);
    require("rate", rateHz, 1, 200);
  }

  /**
   * Returns the address of FlightGear on a host. Listens on loopback if the host is 127.0.0.1 or
   * localhost, otherwise on all addresses.
   *
   * @param propertyPort 0 for none
   */
  public static FlightGearAddress of(String host, int outPort, int inPort, int propertyPort) {
    boolean here = host.equals("127.0.0.1") || host.equals("localhost");
    OptionalInt property = propertyPort == 0 ? OptionalInt.empty() : OptionalInt.of(propertyPort);
    return new FlightGearAddress(
        host, inPort, property, here ? "127.0.0.1" : "0.0.0.0", outPort, USUAL_RATE_HZ);
  }

  private static void require(String name, int value, int lowest, int highest) {
    if (value < lowest || value > highest) {
      throw new IllegalArgumentException(
          name + ": " + value + " is outside " + lowest + "…" + highest);
    }
  }
}
