package org.u2sa.sim.vehicle;

import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Gravity;
import org.u2sa.messages.frame.Point;

/**
 * The true state of a vehicle at one moment, that of its reference point. East, north and level are
 * those of the world's plane; far from its origin a vehicle that follows the earth's curvature
 * takes its own level and true north.
 *
 * @param timeS simulated time since the start [s]
 * @param position east, north, up on the world's plane [m]
 * @param attitude of forward-right-down axes against north, east, down [rad]
 * @param velocity over ground: east, north, up [m/s]
 * @param rates p, q, r about the forward, right and down axes [rad/s]
 * @param acceleration of the velocity: east, north, up [m/s²]; 0 at rest
 */
public record VehicleTruth(
    double timeS,
    Point position,
    Attitude attitude,
    Point velocity,
    Point rates,
    Point acceleration) {

  /** Speed over ground, the climb left out [m/s]. */
  public double speedMps() {
    return StrictMath.sqrt(velocity.x() * velocity.x() + velocity.y() * velocity.y());
  }

  /** Heading, clockwise from north [rad, 0…2π). */
  public double headingRad() {
    return attitude.psi();
  }

  /**
   * What accelerometers feel: acceleration without gravity, forward, right, down [m/s²]; about −g
   * downwards at rest.
   */
  public Point specificForce() {
    Point ned =
        Point.of(acceleration.y(), acceleration.x(), -acceleration.z() - Gravity.STANDARD_MPS2);
    return attitude.nedFromFrd().transposed().times(ned);
  }
}
