package org.u2sa.device;

/** Something that may be lost and found again; {@link DeviceWatch} reports it in log and health. */
public interface Attached {
  /** Whether the device is there. */
  boolean isConnected();

  /**
   * How often the device has been found so far: a parser that sees another number than before
   * starts anew, and a device that needs a setup is set up again.
   */
  int connections();

  /** What is wrong, for the log and the health report; empty if nothing is. */
  String trouble();
}
