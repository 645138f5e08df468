package org.u2sa.sim.device;

import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;

/** Vectors of the world along a vehicle's own axes. */
final class VehicleAxes {
  private VehicleAxes() {}

  /** East, north, up as forward, left, down. */
  static Point of(VehicleTruth truth, Point enu) {
    return truth.attitude().bodyOf(Point.of(enu.y(), enu.x(), -enu.z()));
  }
}
