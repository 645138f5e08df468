package org.u2sa.device.port;

import org.u2sa.device.DeviceWatch;

/**
 * A device that can be disconnected and reconnected; {@link DeviceWatch} reports both in log and
 * health.
 */
public interface Attached {
  /** Whether the device is connected. */
  boolean isConnected();

  /**
   * Number of connections so far: on a change, parsers reset and the device is set up again if
   * necessary.
   */
  int connections();

  /** Current fault, for the log and the health report; empty if none. */
  String trouble();
}
