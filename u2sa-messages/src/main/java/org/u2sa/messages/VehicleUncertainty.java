package org.u2sa.messages;

import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.frame.Rotation;

/**
 * Propagates the vehicle's pose uncertainty to a position measured relative to the vehicle: the
 * vehicle's position error plus the attitude error times the lever arm. Absent standard deviations
 * count as 0.
 *
 * @param place position standard deviations along north, east and down [m]
 * @param yaw about down [rad]
 * @param pitch about the axis to the right of the heading, level [rad]
 * @param roll about the vehicle's forward axis [rad]
 * @param right pitch axis in north, east, down
 * @param forward roll axis in north, east, down
 */
record VehicleUncertainty(
    Point place, double yaw, double pitch, double roll, Point right, Point forward) {
  private static final Point DOWN = Point.of(0.0, 0.0, 1.0);

  /** Uncertainty of a state in GLOBAL or LOCAL_NED that has a heading. */
  static VehicleUncertainty of(StateInformation vehicle) {
    double psi = vehicle.psi().orElseThrow();
    Point sigma = StateTriple.POSITION_SIGMA.values(vehicle);
    Rotation nedFromFrd =
        Rotation.nedFromFrd(vehicle.phi().orElse(0.0), vehicle.theta().orElse(0.0), psi);
    return new VehicleUncertainty(
        vehicle.referenceFrame().equals(ReferenceFrame.GLOBAL)
            ? Point.of(sigma.y(), sigma.x(), sigma.z())
            : sigma,
        vehicle.psiSigma().orElse(0.0),
        vehicle.thetaSigma().orElse(0.0),
        vehicle.phiSigma().orElse(0.0),
        Point.of(-Math.sin(psi), Math.cos(psi), 0.0),
        nedFromFrd.times(Point.of(1.0, 0.0, 0.0)));
  }

  /**
   * Standard deviations along north, east and down [m] that the vehicle adds to a position.
   *
   * @param arm lever arm from the vehicle to the position, north, east, down [m]
   */
  Point sigmaNed(Point arm) {
    // A small turn δ about an axis a moves the end of the arm r by δ·(a × r).
    Point byYaw = DOWN.cross(arm);
    Point byPitch = right.cross(arm);
    Point byRoll = forward.cross(arm);
    return Point.of(
        length(place.x(), byYaw.x(), byPitch.x(), byRoll.x()),
        length(place.y(), byYaw.y(), byPitch.y(), byRoll.y()),
        length(place.z(), byYaw.z(), byPitch.z(), byRoll.z()));
  }

  private double length(double moved, double byYaw, double byPitch, double byRoll) {
    return Math.hypot(moved, Point.of(yaw * byYaw, pitch * byPitch, roll * byRoll).distance());
  }
}
