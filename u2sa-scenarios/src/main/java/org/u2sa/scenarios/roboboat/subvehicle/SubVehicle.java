package org.u2sa.scenarios.roboboat.subvehicle;

import org.u2sa.interfaces.communication.Transport;

/** A sub-vehicle as seen by its carrier. */
public interface SubVehicle {
  /** Switches it on and returns the radio link to its services. */
  Transport switchOn();
}
