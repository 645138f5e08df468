package org.u2sa.device;

import java.util.List;

/** A receiver of other traffic's reports (ADS-B, AIS), or a radar that tracks. */
public interface TrafficReceiver extends Device<TrafficReceiver.Traffic> {
  /**
   * All that is known of the surroundings.
   *
   * @param measuredAtMicros when the receiver last said something
   * @param targets one for each id, in the order of ids, with the time at which each was heard;
   *     those not heard for a minute are left out
   */
  record Traffic(long measuredAtMicros, List<TrafficTarget> targets) implements Reading {}
}
