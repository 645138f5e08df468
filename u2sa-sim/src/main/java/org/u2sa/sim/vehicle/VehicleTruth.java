package org.u2sa.sim.vehicle;

import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;

/**
 * Ground-truth state of a vehicle's reference point at one time. East, north and level refer to the
 * world's plane; vehicles that follow the earth's curvature use local level and true north far from
 * the origin.
 *
 * @param timeS simulated time since the start [s]
 * @param position east, north, up on the world's plane [m]
 * @param attitude of forward-right-down axes against north, east, down [rad]
 * @param velocity velocity over ground: east, north, up [m/s]
 * @param rates p, q, r about the forward, right and down axes [rad/s]
 * @param acceleration time derivative of the velocity: east, north, up [m/s²]; 0 at rest
 */
public record VehicleTruth(
    double timeS,
    Point position,
    Attitude attitude,
    Point velocity,
    Point rates,
    Point acceleration) {

  /** Horizontal speed over ground [m/s]. */
  public double speedMps() {
    return StrictMath.sqrt(velocity.x() * velocity.x() + velocity.y() * velocity.y());
  }

  /** Heading, clockwise from north [rad, 0…2π). */
  public double headingRad() {
    return attitude.psi();
  }

  /**
   * Specific force measured by accelerometers: forward, right, down [m/s²]; about −g in the down
   * axis at rest.
   */
  public Point specificForce() {
    Point ned =
        Point.of(acceleration.y(), acceleration.x(), -acceleration.z() - Gravity.STANDARD_MPS2);
    return attitude.nedFromFrd().transposed().times(ned);
  }
}
