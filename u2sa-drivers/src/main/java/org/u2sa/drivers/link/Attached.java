package org.u2sa.drivers.link;

/** A device that may be lost and found again; {@link LinkWatch} tells of it in log and health. */
public interface Attached {
  /** Whether the device is there. */
  boolean isConnected();

  /**
   * How often the device was found so far: a parser that sees another number than before starts
   * anew, and a device that needs to be set up is set up again.
   */
  int connections();

  /** What is wrong, for the log and the health report; empty if nothing. */
  String trouble();
}
