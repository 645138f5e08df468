package org.u2sa.device.payload;

import org.u2sa.device.port.Device;

/** A load cell between a thruster and the vehicle: measures the thrust. */
public interface LoadCell extends Device<LoadCell.Load> {
  /**
   * A load.
   *
   * @param newtons force of the thruster on the vehicle along its axis, forward positive [N]
   */
  record Load(long measuredAtMicros, double newtons) implements Reading {}
}
