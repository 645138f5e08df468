package org.u2sa.drivers.compass;

import java.util.Optional;
import org.u2sa.drivers.link.Attached;

/**
 * All that {@link CompassSensor} knows of a compass: those on a serial line or a network, the
 * phone's, simulated and replayed ones look alike. Belongs to one thread; no call waits.
 */
public interface Compass extends Attached, AutoCloseable {
  /**
   * What the compass said.
   *
   * @param connected whether it is there
   * @param heading the newest; a new object for each, the same until the next
   */
  record Reading(boolean connected, Optional<Heading> heading) {}

  /** Hears the compass, and returns what it said last. Never throws for a lost one. */
  Reading read(long nowMicros);

  /** How often it sent what cannot be read. */
  long malformed();

  @Override
  void close();
}
