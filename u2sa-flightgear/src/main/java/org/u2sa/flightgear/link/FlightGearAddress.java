package org.u2sa.flightgear.link;

import java.util.OptionalInt;

/**
 * Where FlightGear and this program meet. {@code scripts/flightgear/start} uses 5501 (out), 5502
 * (in) and 5503 (properties).
 *
 * @param host where FlightGear runs
 * @param inPort FlightGear listens here for controls [1…65535]
 * @param propertyPort FlightGear's property server, by which a cut link is repaired; empty if there
 *     is none
 * @param bindHost address on which this program listens for FlightGear's lines; "127.0.0.1" lets
 *     only this machine in
 * @param outPort port on which it listens [0…65535]; 0 takes a free one
 * @param rateHz lines a second that FlightGear is asked for when the link is repaired [1/s]
 */
public record FlightGearAddress(
    String host, int inPort, OptionalInt propertyPort, String bindHost, int outPort, int rateHz) {
  /** Lines a second of {@code scripts/flightgear/start}. */
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
   * FlightGear on a host, at given ports. Listens for this machine only if the host is 127.0.0.1 or
   * localhost, otherwise on all addresses.
   *
   * @param propertyPort 0 is none
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
