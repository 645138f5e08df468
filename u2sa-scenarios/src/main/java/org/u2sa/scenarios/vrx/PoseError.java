package org.u2sa.scenarios.vrx;

import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/** Pose error of VRX: d + 0.75^d |Δψ|, with the distance d [m] and the heading error Δψ [rad]. */
final class PoseError {
  private static final double HEADING_SHARE = 0.75; // left of the heading's weight per metre

  private final Point place;
  private final double headingRad;

  PoseError(VrxWorld.Goal goal, LocalPlane plane) {
    place = plane.point(new Geodetic(goal.longitudeDeg(), goal.latitudeDeg(), 0.0));
    headingRad = goal.headingRad();
  }

  double distanceM(VehicleTruth truth) {
    return Math.hypot(truth.position().x() - place.x(), truth.position().y() - place.y());
  }

  double turnRad(VehicleTruth truth) {
    return Math.abs(Math.IEEEremainder(truth.headingRad() - headingRad, 2.0 * Math.PI));
  }

  double of(VehicleTruth truth) {
    double distance = distanceM(truth);
    return distance + Math.pow(HEADING_SHARE, distance) * turnRad(truth);
  }
}
