package org.u2sa.drivers.imu;

import java.util.Optional;
import org.u2sa.drivers.link.Attached;

/**
 * All that {@link ImuSensor} knows of an inertial measurement unit: those on a serial line or a
 * network, the phone's, simulated and replayed ones look alike. Belongs to one thread; no call
 * waits.
 */
public interface Imu extends Attached, AutoCloseable {
  /**
   * What the IMU said.
   *
   * @param connected whether it is there
   * @param orientation the newest; a new object for each, the same until the next
   */
  record Reading(boolean connected, Optional<Orientation> orientation) {}

  /** Hears the IMU, and returns what it said last. Never throws for a lost one. */
  Reading read(long nowMicros);

  /** How often it sent what cannot be read. */
  long malformed();

  @Override
  void close();
}
