package org.u2sa.device.payload;

import org.u2sa.device.port.Device;

/** A gimbal with a pan and a tilt axis, for a camera or another instrument. */
public interface Gimbal extends Device<Gimbal.Pointing> {
  /**
   * Status reported by the gimbal.
   *
   * @param panRad angle of its pan axis from straight ahead, to the left positive [rad]
   * @param tiltRad angle of its tilt axis, up positive [rad]
   */
  record Pointing(long measuredAtMicros, double panRad, double tiltRad) implements Reading {}

  /**
   * Sets the angles, which hold until the next ones; axes and signs as in {@link Pointing}.
   *
   * @param panRad to the left positive [rad]
   * @param tiltRad up positive [rad]
   */
  void point(double panRad, double tiltRad);

  /** Releases the gimbal without moving it, for a successor. */
  void leave();
}
