package org.u2sa.sim.device;

import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

/** Converts world vectors to body axes. */
final class VehicleAxes {
  private VehicleAxes() {}

  /** Converts (east, north, up) to (forward, left, down). */
  static Point of(VehicleTruth truth, Point enu) {
    return truth.attitude().bodyOf(Point.of(enu.y(), enu.x(), -enu.z()));
  }
}
