package org.u2sa.core.communication.access;

import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.u2sa.core.communication.limit.RecentlyUsed;

/**
 * Tracks which sender runs a system's Health Monitor: the first sender to publish conditions, until
 * it falls silent and another sender publishes some. It remains the monitor when its connection
 * ends, because it does not repeat conditions after reconnecting. The vehicle is never replaced.
 *
 * <p>For the network's thread only, except where stated otherwise.
 */
final class HealthMonitors {
  private static final int MAX_SYSTEMS = 1_024; // least recently used is dropped

  private final Set<String> ofVehicle = ConcurrentHashMap.newKeySet(); // system IDs
  private final Map<String, Speaker> ofOthers = new RecentlyUsed<>(MAX_SYSTEMS); // by system ID

  /** Records a condition published by the vehicle. Thread-safe. */
  void hearVehicle(String systemId) {
    if (!ofVehicle.contains(systemId)) { // reading is cheaper than writing
      ofVehicle.add(systemId);
    }
  }

  /** Records a condition. */
  void hear(String systemId, Speaker speaker, long nowMicros) {
    if (speaker.isOfVehicle()) {
      hearVehicle(systemId);
    } else if (speaker.mayReplace(ofOthers.get(systemId), nowMicros)) {
      ofOthers.put(systemId, speaker);
    }
  }

  /** Whether a connection belongs to the sender that runs the monitor. */
  boolean isRunBy(String systemId, Speaker speaker) {
    if (ofVehicle.contains(systemId)) {
      return speaker.isOfVehicle();
    }
    Speaker known = ofOthers.get(systemId);
    return known != null && speaker.isSameAs(known);
  }
}
