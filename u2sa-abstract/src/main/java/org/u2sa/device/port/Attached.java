package org.u2sa.device.port;

/** A device that can be disconnected and reconnected. */
public interface Attached {
  boolean isConnected();

  /**
   * Number of connections so far: when it changes, parsers reset and the device is configured
   * again.
   */
  int connections();

  /** Current fault, for the log and the health report; empty if none. */
  String trouble();
}
