package org.u2sa.device.port;

import java.util.List;

/** A receiver of other traffic's reports (ADS-B, AIS), or a radar that tracks. */
public interface TrafficReceiver extends Device<TrafficReceiver.Traffic> {
  /**
   * Known traffic in the surroundings.
   *
   * @param measuredAtMicros time of the receiver's last message
   * @param targets one per id, sorted by id, with the time of its last report; targets silent for a
   *     minute are omitted
   */
  record Traffic(long measuredAtMicros, List<TrafficTarget> targets) implements Reading {}
}
