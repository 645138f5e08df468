package org.u2sa.drivers.gps;

import java.util.Optional;
import org.u2sa.drivers.link.Attached;

/**
 * All that {@link GpsSensor} knows of a satellite receiver: those on a serial line or a network,
 * the phone's, simulated and replayed ones look alike. Belongs to one thread; no call waits.
 */
public interface GpsReceiver extends Attached, AutoCloseable {
  /**
   * What the receiver said.
   *
   * @param connected whether it is there
   * @param fix the newest; a new object for each fix, the same until the next
   */
  record Reading(boolean connected, Optional<GpsFix> fix) {}

  /** Hears the receiver, and returns what it said last. Never throws for a lost one. */
  Reading read(long nowMicros);

  /** How often it sent what cannot be read. */
  long malformed();

  @Override
  void close();
}
